#include "core/scene/utf8.hpp"

namespace raylab {

// Unicode 15, table 3-7.
std::size_t utf8_length(std::string_view text) {
  if (text.empty()) return 0;
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const auto continued = [&](std::size_t i) { return byte(i) >= 0x80U && byte(i) <= 0xBFU; };
  const unsigned first = byte(0);
  const unsigned second = byte(1);
  if (first < 0x80U) return 1;
  if (first < 0xC2U || !continued(1)) return 0;
  if (first < 0xE0U) return 2;
  if (first == 0xE0U && second < 0xA0U) return 0;  // could be written shorter
  if (first == 0xEDU && second > 0x9FU) return 0;  // half of a UTF-16 pair
  if (first < 0xF0U) return continued(2) ? 3 : 0;
  if (first == 0xF0U && second < 0x90U) return 0;                     // could be written shorter
  if (first > 0xF4U || (first == 0xF4U && second > 0x8FU)) return 0;  // beyond the last character
  return continued(2) && continued(3) ? 4 : 0;
}

}  // namespace raylab
