// crashed: throws as much as a line may have, each time
#include <stdexcept>
#include <string>
static void attack() {
  std::string text;
  for (int k = 0; k < 30; ++k) text += std::string(1200, '\1') + '\n';
  throw std::runtime_error(text);
}
