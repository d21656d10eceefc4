// right: would leave a copy of itself behind
#include <unistd.h>
static void attack() {
  if (fork() != 0) return;
  setsid();
  if (fork() == 0) sleep(1000);
  _exit(0);
}
