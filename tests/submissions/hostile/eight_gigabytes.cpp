// out_of_memory: wants 8 GiB
#include <vector>
static void attack() {
  std::vector<char> all(std::size_t{8} << 30U, 1);
  volatile char last = all.back();
  (void)last;
}
