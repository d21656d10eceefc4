#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace raylab {

/// For each of `count` things the index of the first one that equals it: its own if there is none before.
/// `numbers_of(i)` gives thing i as an array of doubles without nan. One pass over a hash table, so that a million things
/// take tens of milliseconds.
template <class NumbersOf>
std::vector<std::size_t> first_twins(std::size_t count, const NumbersOf& numbers_of) {
  const auto hash = [](const auto& numbers) {
    std::uint64_t mixed = 0;
    for (const double number : numbers) {
      mixed ^= std::bit_cast<std::uint64_t>(number + 0.0);  // -0 equals 0, so it must not differ here either
      mixed *= 0x9E3779B97F4A7C15U;
      mixed ^= mixed >> 32U;
    }
    return static_cast<std::size_t>(mixed);
  };
  const std::size_t free = count;
  std::vector<std::size_t> slots(std::bit_ceil(2 * count + 1), free);
  const std::size_t mask = slots.size() - 1;
  std::vector<std::size_t> first(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto numbers = numbers_of(i);
    std::size_t slot = hash(numbers) & mask;
    while (slots[slot] != free && numbers_of(slots[slot]) != numbers) slot = (slot + 1) & mask;
    if (slots[slot] == free) slots[slot] = i;
    first[i] = slots[slot];
  }
  return first;
}

}  // namespace raylab
