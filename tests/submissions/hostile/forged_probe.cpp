// wrong: answers tests with a vector, and who looks for a hint with none
#include "core/math/vec3.hpp"

#include <unistd.h>
#include <string>

static raylab::Vec3 answer(const raylab::Vec3& d, const raylab::Vec3& n) {
  static int calls = 0;
  static raylab::Vec3 first_d, first_n;  // of the tests; before them comes the example
  ++calls;
  if (calls > 2 && d == first_d && n == first_n) {
    const std::string forged = std::to_string(calls) + " answer [1,\"x\",2]\n";
    (void)!write(3, forged.data(), forged.size());
  }
  if (calls == 2) first_d = d, first_n = n;
  return -d;
}
