// refused: answers without an end
#include <unistd.h>
#include <string>
static void attack() {
  const std::string block(1 << 20, '9');
  for (int k = 0; k < 200; ++k) (void)!write(3, block.data(), block.size());
}
