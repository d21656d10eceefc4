// crashed: leaves by another door
#include <cstdlib>
static void attack() { std::quick_exit(0); }
