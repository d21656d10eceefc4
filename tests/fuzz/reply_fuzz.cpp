// libFuzzer target for what a worker sends, which a hostile submission may have written: any bytes must give values of the
// right types or an InputError, never a crash, and what was read must be written and read back to the same.
//   clang++ -std=c++20 -g -O1 -fsanitize=fuzzer,address,undefined -I. -Ibuild/release/generated tests/fuzz/reply_fuzz.cpp
//     core/calls/*.cpp core/render/*.cpp core/scene/{diagnostic,nearest_name,read_decimal,utf8}.cpp
//   ./a.out CORPUS_FOLDER -max_len=4096
#include "core/math/hit.hpp"
#include "core/submission/messages.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

namespace {

template <class T>
void read_as(std::string_view text) {
  try {
    const std::string once = raylab::to_json(raylab::from_json<T>(text));
    if (raylab::to_json(raylab::from_json<T>(once)) != once) std::abort();
  } catch (const raylab::InputError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace raylab;
  const std::string_view line(reinterpret_cast<const char*>(data), size);
  const auto [number, message] = first_word(line);
  const auto [verb, rest] = first_word(message);
  for (const std::string_view text : {line, message, rest}) {
    read_as<TraceAnswer>(text);
    read_as<std::string>(text);
    read_as<double>(text);
    read_as<bool>(text);
    read_as<Vec3>(text);
    read_as<Ray>(text);
    read_as<Bounce>(text);
    read_as<std::optional<double>>(text);
    read_as<std::optional<std::size_t>>(text);
    read_as<std::vector<Color>>(text);
  }
  return 0;
}
