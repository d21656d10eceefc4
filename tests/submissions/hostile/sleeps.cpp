// too_slow: does nothing for a long time
#include <unistd.h>
static void attack() { sleep(1000); }
