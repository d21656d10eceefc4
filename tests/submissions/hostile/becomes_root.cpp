// right: would like to be root
#include <unistd.h>
#include <cstdlib>
static void attack() {
  if (setuid(0) == 0 || setgid(0) == 0) std::abort();
}
