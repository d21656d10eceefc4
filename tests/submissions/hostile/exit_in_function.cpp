// crashed: leaves the program, with a good exit code
#include <unistd.h>
static void attack() { _exit(0); }
