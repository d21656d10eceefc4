// right: would like to have more
#include <sys/resource.h>
#include <cstdlib>
static void attack() {
  const rlimit none{RLIM_INFINITY, RLIM_INFINITY};
  if (setrlimit(RLIMIT_AS, &none) == 0 || setrlimit(RLIMIT_CPU, &none) == 0) std::abort();
}
