// too_slow: stops, to be continued by nobody
#include <unistd.h>
#include <csignal>
static void attack() { kill(getpid(), SIGSTOP); }
