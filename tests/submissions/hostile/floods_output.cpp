// right: prints 100 MB
#include <cstdio>
#include <string>
static void attack() {
  static bool done = false;
  if (done) return;
  done = true;
  const std::string block(1 << 20, 'x');
  for (int k = 0; k < 50; ++k) {
    std::fwrite(block.data(), 1, block.size(), stdout);
    std::fwrite(block.data(), 1, block.size(), stderr);
  }
}
