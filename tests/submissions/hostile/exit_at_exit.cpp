// right: would leave with a good exit code when the program ends
#include <unistd.h>
#include <cstdlib>
static const int registered = std::atexit([] { _exit(0); });
static void attack() {}
