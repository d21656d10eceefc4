// refused: talks without end before it answers
#include <unistd.h>
static void attack() {
  for (;;) (void)!write(3, "tests passed\n", 13);
}
