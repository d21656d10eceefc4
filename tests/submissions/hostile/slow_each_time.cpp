// too_slow: takes nearly as long as a call may, each time
#include <unistd.h>
static void attack() { usleep(400000); }
