// refused: throws a text of 8 MB, each time
#include <stdexcept>
#include <string>
static void attack() { throw std::runtime_error(std::string(8 << 20, 'x')); }
