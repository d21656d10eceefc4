// refused: writes nonsense to every descriptor
#include <unistd.h>
static void attack() {
  for (int k = 0; k < 64; ++k) (void)!write(k, "nonsense\n", 9);
}
