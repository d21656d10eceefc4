// crashed: aborts
#include <cstdlib>
static void attack() { std::abort(); }
