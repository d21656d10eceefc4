// refused: answers with a million brackets
#include <unistd.h>
#include <string>
static void attack() {
  const std::string line = "answer " + std::string(1000000, '[') + "\n";
  (void)!write(3, line.data(), line.size());
}
