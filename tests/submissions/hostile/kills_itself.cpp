// crashed: kills itself in a way that nobody can catch
#include <unistd.h>
#include <csignal>
static void attack() { kill(getpid(), SIGTERM); }
