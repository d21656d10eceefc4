// crashed: answers by how often it was asked
#include <stdexcept>
static int calls = 0;
static void attack() {
  if (++calls % 7 == 0) throw std::runtime_error("the seventh time");
}
