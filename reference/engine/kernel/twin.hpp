// Part of the kernel; kernel/parts.hpp says how the parts are put together.

/// Two packs side by side, in every operation one after the other: the lanes of `first`, then those of `second`. A result
/// takes the machine several cycles, and what is worked out for a ray is a chain of them; a second chain fills the gaps.
/// What is done once for a pack, such as finding out which spheres its rays may reach at all, is then done half as often.
namespace raylab::fast::RAYLAB_TARGET {

template <class P>
struct TwinMask {
  MaskOf<P> first, second;

  friend HWY_INLINE TwinMask operator&(TwinMask a, TwinMask b) { return {a.first & b.first, a.second & b.second}; }
  friend HWY_INLINE TwinMask operator|(TwinMask a, TwinMask b) { return {a.first | b.first, a.second | b.second}; }
  friend HWY_INLINE TwinMask operator!(TwinMask a) { return {!a.first, !a.second}; }
};

template <class P>
class TwinIndex {
 public:
  IndexOf<P> first, second;

  TwinIndex() = default;
  HWY_INLINE TwinIndex(WholeOf<P> a) : first(a), second(a) {}
  HWY_INLINE TwinIndex(IndexOf<P> a, IndexOf<P> b) : first(a), second(b) {}

  friend HWY_INLINE TwinIndex operator+(TwinIndex a, TwinIndex b) { return {a.first + b.first, a.second + b.second}; }
  friend HWY_INLINE TwinIndex operator-(TwinIndex a, TwinIndex b) { return {a.first - b.first, a.second - b.second}; }
  friend HWY_INLINE TwinMask<P> operator==(TwinIndex a, TwinIndex b) { return {a.first == b.first, a.second == b.second}; }
  friend HWY_INLINE TwinMask<P> operator<(TwinIndex a, TwinIndex b) { return {a.first < b.first, a.second < b.second}; }
  friend HWY_INLINE TwinMask<P> operator>=(TwinIndex a, TwinIndex b) { return {a.first >= b.first, a.second >= b.second}; }
};

template <class P>
class Twin {
 public:
  P first, second;

  Twin() = default;
  HWY_INLINE Twin(NumberOf<P> a) : first(a), second(a) {}
  HWY_INLINE Twin(P a, P b) : first(a), second(b) {}

  friend HWY_INLINE Twin operator+(Twin a, Twin b) { return {a.first + b.first, a.second + b.second}; }
  friend HWY_INLINE Twin operator-(Twin a, Twin b) { return {a.first - b.first, a.second - b.second}; }
  friend HWY_INLINE Twin operator*(Twin a, Twin b) { return {a.first * b.first, a.second * b.second}; }
  friend HWY_INLINE Twin operator/(Twin a, Twin b) { return {a.first / b.first, a.second / b.second}; }
  friend HWY_INLINE Twin operator-(Twin a) { return {-a.first, -a.second}; }
  friend HWY_INLINE TwinMask<P> operator<(Twin a, Twin b) { return {a.first < b.first, a.second < b.second}; }
  friend HWY_INLINE TwinMask<P> operator>(Twin a, Twin b) { return {a.first > b.first, a.second > b.second}; }
  friend HWY_INLINE TwinMask<P> operator<=(Twin a, Twin b) { return {a.first <= b.first, a.second <= b.second}; }
  friend HWY_INLINE TwinMask<P> operator>=(Twin a, Twin b) { return {a.first >= b.first, a.second >= b.second}; }
  friend HWY_INLINE TwinMask<P> operator==(Twin a, Twin b) { return {a.first == b.first, a.second == b.second}; }
};

template <class P>
struct Lanes<Twin<P>> {
  using Number = NumberOf<P>;
  using Mask = TwinMask<P>;
  using Index = TwinIndex<P>;
  using Whole = WholeOf<P>;
  using Single = P;
  static constexpr int count = 2 * Lanes<P>::count;
};

template <class V>
concept IsTwin = std::is_same_v<V, Twin<SingleOf<V>>>;

template <class P>
HWY_INLINE Twin<P> select(TwinMask<P> condition, Twin<P> yes, Twin<P> no) {
  return {select(condition.first, yes.first, no.first), select(condition.second, yes.second, no.second)};
}
template <class P>
HWY_INLINE TwinMask<P> select(TwinMask<P> condition, TwinMask<P> yes, TwinMask<P> no) {
  return {select(condition.first, yes.first, no.first), select(condition.second, yes.second, no.second)};
}
template <class P>
HWY_INLINE TwinIndex<P> select(TwinMask<P> condition, TwinIndex<P> yes, TwinIndex<P> no) {
  return {select(condition.first, yes.first, no.first), select(condition.second, yes.second, no.second)};
}

template <class P>
HWY_INLINE TwinMask<P> without(TwinMask<P> lanes, TwinMask<P> others) {
  return {without(lanes.first, others.first), without(lanes.second, others.second)};
}

template <class P>
HWY_INLINE std::uint32_t bits(TwinMask<P> mask) {
  return bits(mask.first) | bits(mask.second) << Lanes<P>::count;
}
template <class P>
HWY_INLINE std::size_t count(TwinMask<P> mask) {
  return count(mask.first) + count(mask.second);
}
template <class P>
HWY_INLINE bool any(TwinMask<P> mask) {
  return any(mask.first | mask.second);
}
template <class P>
HWY_INLINE bool none(TwinMask<P> mask) {
  return none(mask.first | mask.second);
}
template <IsTwin V>
HWY_INLINE MaskOf<V> mask_of(std::uint32_t bits) {
  constexpr int half = Lanes<SingleOf<V>>::count;
  return {mask_of<SingleOf<V>>(bits & ((1u << half) - 1)), mask_of<SingleOf<V>>(bits >> half)};
}

template <class P>
HWY_INLINE Twin<P> square_root(Twin<P> a) {
  return {square_root(a.first), square_root(a.second)};
}
template <class P>
HWY_INLINE Twin<P> least(Twin<P> a, Twin<P> b) {
  return {least(a.first, b.first), least(a.second, b.second)};
}
template <class P>
HWY_INLINE Twin<P> greatest(Twin<P> a, Twin<P> b) {
  return {greatest(a.first, b.first), greatest(a.second, b.second)};
}
template <class P>
HWY_INLINE Twin<P> magnitude(Twin<P> a) {
  return {magnitude(a.first), magnitude(a.second)};
}

template <IsTwin V>
HWY_INLINE V load(const NumberOf<V>* numbers) {
  return {load<SingleOf<V>>(numbers), load<SingleOf<V>>(numbers + Lanes<SingleOf<V>>::count)};
}
template <IsTwin V>
HWY_INLINE IndexOf<V> load_index(const WholeOf<V>* numbers) {
  return {load_index<SingleOf<V>>(numbers), load_index<SingleOf<V>>(numbers + Lanes<SingleOf<V>>::count)};
}
template <class P>
HWY_INLINE void store(Twin<P> a, NumberOf<P>* numbers) {
  store(a.first, numbers);
  store(a.second, numbers + Lanes<P>::count);
}
template <class P>
HWY_INLINE void store(TwinIndex<P> a, WholeOf<P>* numbers) {
  store(a.first, numbers);
  store(a.second, numbers + Lanes<P>::count);
}
template <class P>
HWY_INLINE Twin<P> gather(const NumberOf<P>* numbers, TwinIndex<P> place) {
  return {gather(numbers, place.first), gather(numbers, place.second)};
}

template <class P>
HWY_INLINE void split_ratio(Twin<P> a, Twin<P> b, Twin<P>& m, Twin<P>& k) {
  split_ratio(a.first, b.first, m.first, k.first);
  split_ratio(a.second, b.second, m.second, k.second);
}
template <class P>
HWY_INLINE Twin<P> power_of_two(Twin<P> k_and_magic) {
  return {power_of_two(k_and_magic.first), power_of_two(k_and_magic.second)};
}

template <class P>
HWY_INLINE void store_interleaved(Twin<P> x, Twin<P> y, Twin<P> z, double* numbers) {
  store_interleaved(x.first, y.first, z.first, numbers);
  store_interleaved(x.second, y.second, z.second, numbers + 3 * Lanes<P>::count);
}

template <class P>
HWY_INLINE NumberOf<P> greatest_lane(Twin<P> a) {
  return std::max(greatest_lane(a.first), greatest_lane(a.second));
}

template <class P>
HWY_INLINE TwinIndex<P> whole(Twin<P> a) {
  return {whole(a.first), whole(a.second)};
}
template <int bits, class P>
HWY_INLINE TwinIndex<P> shifted_left(TwinIndex<P> a) {
  return {shifted_left<bits>(a.first), shifted_left<bits>(a.second)};
}

}  // namespace raylab::fast::RAYLAB_TARGET
