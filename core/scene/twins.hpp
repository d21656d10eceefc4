#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace raylab {

/// A place in the hash table of first_twins().
struct TwinSlot {
  static constexpr std::uint32_t free = 0xFFFFFFFF;
  std::uint32_t hash = 0;
  std::uint32_t index = free;
};

/// For each of `count` things the index of the first one that equals it: its own if there is none before.
/// `count` is below 2^32 - 1; `numbers_of(i)` gives thing i as an array of doubles without nan. One pass over a hash table,
/// so that a million things take tens of milliseconds.
template <class NumbersOf>
std::vector<std::size_t> first_twins(std::size_t count, const NumbersOf& numbers_of) {
  const auto hash = [](const auto& numbers) {
    std::uint64_t mixed = 0;
    for (const double number : numbers) {
      mixed ^= std::bit_cast<std::uint64_t>(number + 0.0);  // -0 equals 0, so it must not differ here either
      mixed *= 0x9E3779B97F4A7C15U;
      mixed ^= mixed >> 32U;
    }
    return mixed;
  };
  std::vector<TwinSlot> slots(std::bit_ceil(2 * count + 1));
  const std::size_t mask = slots.size() - 1;
  std::vector<std::size_t> first(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto numbers = numbers_of(i);
    const std::uint64_t mixed = hash(numbers);
    const TwinSlot own{static_cast<std::uint32_t>(mixed >> 32U), static_cast<std::uint32_t>(i)};
    std::size_t at = static_cast<std::size_t>(mixed) & mask;
    // The hashes first: the numbers of another thing are far away in memory.
    while (slots[at].index != TwinSlot::free && (slots[at].hash != own.hash || numbers_of(slots[at].index) != numbers))
      at = (at + 1) & mask;
    if (slots[at].index == TwinSlot::free) slots[at] = own;
    first[i] = slots[at].index;
  }
  return first;
}

}  // namespace raylab
