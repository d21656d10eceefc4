// right: would like to be root in a place of its own
#include <sched.h>
#include <sys/mount.h>
#include <cstdlib>
static void attack() {
  if (unshare(CLONE_NEWUSER) == 0 || mount("none", "/", "tmpfs", 0, "") == 0) std::abort();
}
