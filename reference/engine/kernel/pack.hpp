// Part of the kernel; kernel/parts.hpp says how the parts are put together.

/// Packs: as many numbers as a vector register of the target holds, by Google Highway. What is written for one number runs
/// on a pack as it stands: operators work lane by lane, comparisons give a mask, and select() takes the place of a branch.
/// Every operation here is rounded as IEEE 754 says, so that a lane holds what a single number would hold, to the bit.
namespace raylab::fast::RAYLAB_TARGET {

namespace hn = hwy::HWY_NAMESPACE;

template <class T>
using Tag = hn::ScalableTag<T>;
template <class T>
using IndexTag = hn::RebindToSigned<Tag<T>>;

template <class T>
struct PackMask {
  hn::Mask<Tag<T>> raw;

  friend HWY_INLINE PackMask operator&(PackMask a, PackMask b) { return {hn::And(a.raw, b.raw)}; }
  friend HWY_INLINE PackMask operator|(PackMask a, PackMask b) { return {hn::Or(a.raw, b.raw)}; }
  friend HWY_INLINE PackMask operator!(PackMask a) { return {hn::Not(a.raw)}; }
};

/// Places in arrays: whole numbers as wide as T.
template <class T>
class PackIndex {
 public:
  using Raw = hn::Vec<IndexTag<T>>;
  using Whole = hn::TFromD<IndexTag<T>>;

  Raw raw;

  PackIndex() = default;
  HWY_INLINE PackIndex(Whole a) : raw(hn::Set(IndexTag<T>(), a)) {}
  HWY_INLINE explicit PackIndex(Raw a) : raw(a) {}

  friend HWY_INLINE PackIndex operator+(PackIndex a, PackIndex b) { return PackIndex(hn::Add(a.raw, b.raw)); }
  friend HWY_INLINE PackIndex operator-(PackIndex a, PackIndex b) { return PackIndex(hn::Sub(a.raw, b.raw)); }
  friend HWY_INLINE PackMask<T> operator==(PackIndex a, PackIndex b) {
    return {hn::RebindMask(Tag<T>(), hn::Eq(a.raw, b.raw))};
  }
  friend HWY_INLINE PackMask<T> operator<(PackIndex a, PackIndex b) {
    return {hn::RebindMask(Tag<T>(), hn::Lt(a.raw, b.raw))};
  }
  friend HWY_INLINE PackMask<T> operator>=(PackIndex a, PackIndex b) { return !(a < b); }
};

template <class T>
class Pack {
 public:
  using Raw = hn::Vec<Tag<T>>;

  Raw raw;

  Pack() = default;
  HWY_INLINE Pack(T a) : raw(hn::Set(Tag<T>(), a)) {}
  HWY_INLINE explicit Pack(Raw a) : raw(a) {}

  friend HWY_INLINE Pack operator+(Pack a, Pack b) { return Pack(hn::Add(a.raw, b.raw)); }
  friend HWY_INLINE Pack operator-(Pack a, Pack b) { return Pack(hn::Sub(a.raw, b.raw)); }
  friend HWY_INLINE Pack operator*(Pack a, Pack b) { return Pack(hn::Mul(a.raw, b.raw)); }
  friend HWY_INLINE Pack operator/(Pack a, Pack b) { return Pack(hn::Div(a.raw, b.raw)); }
  friend HWY_INLINE Pack operator-(Pack a) { return Pack(hn::Neg(a.raw)); }
  friend HWY_INLINE PackMask<T> operator<(Pack a, Pack b) { return {hn::Lt(a.raw, b.raw)}; }
  friend HWY_INLINE PackMask<T> operator>(Pack a, Pack b) { return {hn::Gt(a.raw, b.raw)}; }
  friend HWY_INLINE PackMask<T> operator<=(Pack a, Pack b) { return {hn::Le(a.raw, b.raw)}; }
  friend HWY_INLINE PackMask<T> operator>=(Pack a, Pack b) { return {hn::Ge(a.raw, b.raw)}; }
  friend HWY_INLINE PackMask<T> operator==(Pack a, Pack b) { return {hn::Eq(a.raw, b.raw)}; }
};

template <class V>
concept IsPack = std::is_same_v<V, Pack<NumberOf<V>>>;

template <class T>
struct Lanes<Pack<T>> {
  using Number = T;
  using Mask = PackMask<T>;
  using Index = PackIndex<T>;
  using Whole = typename PackIndex<T>::Whole;
  using Single = Pack<T>;
  static constexpr int count = static_cast<int>(hn::MaxLanes(Tag<T>()));
};

template <class T>
HWY_INLINE Pack<T> select(PackMask<T> condition, Pack<T> yes, Pack<T> no) {
  return Pack<T>(hn::IfThenElse(condition.raw, yes.raw, no.raw));
}
template <class T>
HWY_INLINE PackMask<T> select(PackMask<T> condition, PackMask<T> yes, PackMask<T> no) {
  return {hn::Or(hn::And(condition.raw, yes.raw), hn::AndNot(condition.raw, no.raw))};
}
template <class T>
HWY_INLINE PackIndex<T> select(PackMask<T> condition, PackIndex<T> yes, PackIndex<T> no) {
  return PackIndex<T>(hn::IfThenElse(hn::RebindMask(IndexTag<T>(), condition.raw), yes.raw, no.raw));
}

template <class T>
HWY_INLINE PackMask<T> without(PackMask<T> lanes, PackMask<T> others) {
  return {hn::AndNot(others.raw, lanes.raw)};
}

template <class T>
HWY_INLINE std::uint32_t bits(PackMask<T> mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(Tag<T>(), mask.raw, bytes);
  std::uint32_t word;
  std::memcpy(&word, bytes, sizeof word);
  return word;
}
template <class T>
HWY_INLINE std::size_t count(PackMask<T> mask) {
  return hn::CountTrue(Tag<T>(), mask.raw);
}
template <class T>
HWY_INLINE bool any(PackMask<T> mask) {
  return !hn::AllFalse(Tag<T>(), mask.raw);
}
template <class T>
HWY_INLINE bool none(PackMask<T> mask) {
  return hn::AllFalse(Tag<T>(), mask.raw);
}
template <IsPack V>
HWY_INLINE MaskOf<V> mask_of(std::uint32_t bits) {
  std::uint8_t bytes[8] = {};
  std::memcpy(bytes, &bits, sizeof bits);
  return {hn::LoadMaskBits(Tag<NumberOf<V>>(), bytes)};
}

template <class T>
HWY_INLINE Pack<T> square_root(Pack<T> a) {
  return Pack<T>(hn::Sqrt(a.raw));
}
/// By one instruction where its result is the same for NaN and for zeros, too.
template <class T>
HWY_INLINE Pack<T> least(Pack<T> a, Pack<T> b) {
#if HWY_ARCH_X86
  return Pack<T>(hn::Min(a.raw, b.raw));
#else
  return select(a < b, a, b);
#endif
}
template <class T>
HWY_INLINE Pack<T> greatest(Pack<T> a, Pack<T> b) {
#if HWY_ARCH_X86
  return Pack<T>(hn::Max(a.raw, b.raw));
#else
  return select(a > b, a, b);
#endif
}
template <class T>
HWY_INLINE Pack<T> magnitude(Pack<T> a) {
  return Pack<T>(hn::Abs(a.raw));
}

template <IsPack V>
HWY_INLINE V load(const NumberOf<V>* numbers) {
  return V(hn::LoadU(Tag<NumberOf<V>>(), numbers));
}
template <IsPack V>
HWY_INLINE IndexOf<V> load_index(const WholeOf<V>* numbers) {
  return IndexOf<V>(hn::LoadU(IndexTag<NumberOf<V>>(), numbers));
}
template <class T>
HWY_INLINE void store(Pack<T> a, T* numbers) {
  hn::StoreU(a.raw, Tag<T>(), numbers);
}
template <class T>
HWY_INLINE void store(PackIndex<T> a, typename PackIndex<T>::Whole* numbers) {
  hn::StoreU(a.raw, IndexTag<T>(), numbers);
}
template <class T>
HWY_INLINE Pack<T> gather(const T* numbers, PackIndex<T> place) {
  return Pack<T>(hn::GatherIndex(Tag<T>(), numbers, place.raw));
}
template <IsPack V>
HWY_INLINE IndexOf<V> lane_numbers() {
  return IndexOf<V>(hn::Iota(IndexTag<NumberOf<V>>(), 0));
}

template <class T>
HWY_INLINE void split_ratio(Pack<T> a, Pack<T> b, Pack<T>& m, Pack<T>& k) {
  constexpr int mantissa_bits = std::numeric_limits<T>::digits - 1;
  const IndexTag<T> whole;
  const auto bits_of = [whole](Pack<T> number) HWY_ATTR { return hn::BitCast(whole, number.raw); };
  // AVX2 shifts no signed 64-bit numbers to the right: the bits of 4 lift the exponent above 0, those of 1/2 of them round.
  const auto half = hn::Set(whole, WholeOf<Pack<T>>(1) << (mantissa_bits - 1));
  const auto lift = bits_of(Pack<T>(T(4)));
  const auto lifted = hn::Add(hn::Sub(bits_of(a), bits_of(b)), hn::Add(lift, half));
  const auto exponent =
      hn::Sub(hn::BitCast(whole, hn::ShiftRight<mantissa_bits>(hn::BitCast(hn::RebindToUnsigned<Tag<T>>(), lifted))),
              hn::ShiftRight<mantissa_bits>(lift));
  k = Pack<T>(hn::BitCast(Tag<T>(), hn::Add(exponent, bits_of(Pack<T>(magic<T>))))) - Pack<T>(magic<T>);
  m = Pack<T>(hn::BitCast(Tag<T>(), hn::Sub(bits_of(a), hn::ShiftLeft<mantissa_bits>(exponent))));
}

template <class T>
HWY_INLINE Pack<T> power_of_two(Pack<T> k_and_magic) {
  constexpr int mantissa_bits = std::numeric_limits<T>::digits - 1;
  const IndexTag<T> whole;
  const auto biased = hn::Add(hn::BitCast(whole, k_and_magic.raw), hn::Set(whole, std::numeric_limits<T>::max_exponent - 1));
  return Pack<T>(hn::BitCast(Tag<T>(), hn::ShiftLeft<mantissa_bits>(biased)));
}

/// x, y and z of the first lane, then of the next, as doubles.
HWY_INLINE void store_interleaved(Pack<float> x, Pack<float> y, Pack<float> z, double* numbers) {
  using Wide = hn::RepartitionToWide<Tag<float>>;
  const hn::Half<Tag<float>> half;
  const auto low = [half](Pack<float> a) HWY_ATTR { return hn::PromoteTo(Wide(), hn::LowerHalf(half, a.raw)); };
  const auto high = [half](Pack<float> a) HWY_ATTR { return hn::PromoteTo(Wide(), hn::UpperHalf(half, a.raw)); };
  hn::StoreInterleaved3(low(x), low(y), low(z), Wide(), numbers);
  hn::StoreInterleaved3(high(x), high(y), high(z), Wide(), numbers + 3 * hn::MaxLanes(Wide()));
}
HWY_INLINE void store_interleaved(Pack<double> x, Pack<double> y, Pack<double> z, double* numbers) {
  hn::StoreInterleaved3(x.raw, y.raw, z.raw, Tag<double>(), numbers);
}

/// The greatest number of all lanes.
template <class T>
HWY_INLINE T greatest_lane(Pack<T> a) {
  return hn::GetLane(hn::MaxOfLanes(Tag<T>(), a.raw));
}

/// Whole numbers that are held as T.
template <class T>
HWY_INLINE PackIndex<T> whole(Pack<T> a) {
  return PackIndex<T>(hn::ConvertTo(IndexTag<T>(), a.raw));
}
template <int bits, class T>
HWY_INLINE PackIndex<T> shifted_left(PackIndex<T> a) {
  return PackIndex<T>(hn::ShiftLeft<bits>(a.raw));
}

/// Eight floats, one for each child of a node, in as many registers as that takes.
class Eight {
 public:
  Eight() = default;
  HWY_INLINE explicit Eight(float a) {
    for (auto& part : raw_) part = hn::Set(PartTag(), a);
  }

  static HWY_INLINE Eight load(const std::array<float, 8>& numbers) {
    Eight result;
    for (std::size_t i = 0; i < parts; ++i) result.raw_[i] = hn::Load(PartTag(), numbers.data() + i * lanes);
    return result;
  }
  HWY_INLINE void store(std::array<float, 8>& numbers) const {
    for (std::size_t i = 0; i < parts; ++i) hn::StoreU(raw_[i], PartTag(), numbers.data() + i * lanes);
  }

  /// a b - c. Fused where the target can: the bits may differ, so this is for nothing that a pixel's color depends on.
  friend HWY_INLINE Eight multiply_subtract(const Eight& a, const Eight& b, const Eight& c) {
    Eight result;
    for (std::size_t i = 0; i < parts; ++i) result.raw_[i] = hn::MulSub(a.raw_[i], b.raw_[i], c.raw_[i]);
    return result;
  }
  friend HWY_INLINE Eight lesser(const Eight& a, const Eight& b) {
    Eight result;
    for (std::size_t i = 0; i < parts; ++i) result.raw_[i] = hn::Min(a.raw_[i], b.raw_[i]);
    return result;
  }
  friend HWY_INLINE Eight greater(const Eight& a, const Eight& b) {
    Eight result;
    for (std::size_t i = 0; i < parts; ++i) result.raw_[i] = hn::Max(a.raw_[i], b.raw_[i]);
    return result;
  }
  /// Number i of `yes` where that of `a` is at most that of `b`, else infinity.
  friend HWY_INLINE Eight where_at_most(const Eight& a, const Eight& b, const Eight& yes) {
    Eight result;
    const auto no = hn::Set(PartTag(), std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < parts; ++i) result.raw_[i] = hn::IfThenElse(hn::Le(a.raw_[i], b.raw_[i]), yes.raw_[i], no);
    return result;
  }
  /// Bit i: is number i of `a` at most that of `b`?
  friend HWY_INLINE std::uint32_t at_most(const Eight& a, const Eight& b) {
    std::uint32_t mask = 0;
    for (std::size_t i = 0; i < parts; ++i) {
      std::uint8_t byte[8] = {};
      hn::StoreMaskBits(PartTag(), hn::Le(a.raw_[i], b.raw_[i]), byte);
      mask |= static_cast<std::uint32_t>(byte[0]) << (i * lanes);
    }
    return mask;
  }
  /// place[i] becomes the number of those of `met`, bit by bit, that are further than i, of nearly equal ones the later; for
  /// one that is not met some place behind them. For distances that are not negative.
  friend HWY_INLINE void places_by_distance(const Eight& distances, std::uint32_t met, std::array<std::int32_t, 8>& place) {
    const KeyTag tag;
    std::array<std::int32_t, 8> keys;
    hn::Vec<KeyTag> key[parts], further[parts];
    // The bits of a number as a whole number stand in the order of the numbers; the last three tell equal ones apart.
    for (std::size_t i = 0; i < parts; ++i) {
      const auto own = hn::Iota(tag, static_cast<std::int32_t>(i * lanes));
      const auto here = hn::TestBit(hn::Set(tag, static_cast<std::int32_t>(met)), hn::Shl(hn::Set(tag, 1), own));
      const auto rounded = hn::AndNot(hn::Set(tag, 7), hn::BitCast(tag, distances.raw_[i]));
      key[i] = hn::IfThenElse(here, hn::Or(rounded, own), hn::Not(own));
      hn::StoreU(key[i], tag, keys.data() + i * lanes);
      further[i] = hn::Zero(tag);
    }
    for (const std::int32_t other : keys)
      for (std::size_t i = 0; i < parts; ++i)
        further[i] = hn::Sub(further[i], hn::VecFromMask(tag, hn::Gt(hn::Set(tag, other), key[i])));
    for (std::size_t i = 0; i < parts; ++i) hn::StoreU(further[i], tag, place.data() + i * lanes);
  }

 private:
  using PartTag = hn::CappedTag<float, 8>;
  using KeyTag = hn::RebindToSigned<PartTag>;
  static constexpr std::size_t lanes = hn::MaxLanes(PartTag());
  static constexpr std::size_t parts = 8 / lanes;

  hn::Vec<PartTag> raw_[parts];
};

/// Bit j of number i of the result is bit i of number j.
template <std::size_t count>
HWY_INLINE std::array<std::uint32_t, 8> transposed(const std::array<std::uint8_t, count>& rows) {
  const hn::FixedTag<std::uint8_t, count> tag;
  const auto all = hn::LoadU(tag, rows.data());
  std::array<std::uint32_t, 8> columns;
  for (unsigned i = 0; i < 8; ++i) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(tag, hn::TestBit(all, hn::Set(tag, static_cast<std::uint8_t>(1u << i))), bytes);
    std::memcpy(&columns[i], bytes, sizeof columns[i]);
  }
  return columns;
}

}  // namespace raylab::fast::RAYLAB_TARGET
