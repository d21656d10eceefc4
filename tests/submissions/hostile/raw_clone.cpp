// right: would leave a copy behind, without the library's help
#include <sys/syscall.h>
#include <unistd.h>
#include <csignal>
static void attack() {
  if (syscall(SYS_clone, SIGCHLD, 0, 0, 0, 0) != 0) return;
  sleep(1000);
  _exit(0);
}
