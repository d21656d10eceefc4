// crashed: closes every descriptor, the line to the grader too
#include <unistd.h>
static void attack() {
  for (int k = 0; k < 1024; ++k) close(k);
}
