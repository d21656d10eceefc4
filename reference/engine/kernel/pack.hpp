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

  static HWY_INLINE Eight load(const float* numbers) {
    Eight result;
    for (std::size_t i = 0; i < parts; ++i) result.raw_[i] = hn::Load(PartTag(), numbers + i * lanes);
    return result;
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

 private:
  friend class Met;
  friend class MetInOrder;
  using PartTag = hn::CappedTag<float, 8>;
  static constexpr std::size_t lanes = hn::MaxLanes(PartTag());
  static constexpr std::size_t parts = 8 / lanes;

  hn::Vec<PartTag> raw_[parts];
};

/// Which children of a node rays meet: for each child the rays, as bits.
class Met {
 public:
  HWY_INLINE Met() {
    for (auto& part : rays_) part = hn::Zero(WordTag());
  }

  /// A ray, which is a bit, meets the children whose number of `from` is at most that of `to`.
  HWY_INLINE void add(std::uint32_t ray, const Eight& from, const Eight& to) {
    const auto word = hn::Set(WordTag(), static_cast<std::int32_t>(ray));
    for (std::size_t i = 0; i < parts; ++i) {
      const auto met = hn::RebindMask(WordTag(), hn::Le(from.raw_[i], to.raw_[i]));
      rays_[i] = hn::Or(rays_[i], hn::IfThenElseZero(met, word));
    }
  }

  /// Writes eight numbers to each place: first those of the children that are met. Returns how many these are.
  HWY_INLINE std::size_t store(const std::array<std::int32_t, 8>& children, std::int32_t* rays, std::int32_t* child) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < parts; ++i) {
      const auto met = hn::Ne(rays_[i], hn::Zero(WordTag()));
      hn::StoreU(hn::Compress(rays_[i], met), WordTag(), rays + count);
      hn::StoreU(hn::Compress(hn::LoadU(WordTag(), children.data() + i * lanes), met), WordTag(), child + count);
      count += hn::CountTrue(WordTag(), met);
    }
    return count;
  }

 private:
  friend class MetInOrder;
  using WordTag = hn::RebindToSigned<Eight::PartTag>;
  static constexpr std::size_t lanes = Eight::lanes, parts = Eight::parts;

  hn::Vec<WordTag> rays_[parts];
};

/// The same, and for each child how far the nearest of its rays has to go.
class MetInOrder {
 public:
  HWY_INLINE MetInOrder() {
    for (auto& part : near_) part = hn::Set(PartTag(), std::numeric_limits<float>::infinity());
  }

  HWY_INLINE void add(std::uint32_t ray, const Eight& from, const Eight& to) {
    met_.add(ray, from, to);
    for (std::size_t i = 0; i < parts; ++i)
      near_[i] = hn::IfThenElse(hn::Le(from.raw_[i], to.raw_[i]), hn::Min(near_[i], from.raw_[i]), near_[i]);
  }

  /// Those that are met stand in order, the nearest last.
  HWY_INLINE std::size_t store(const std::array<std::int32_t, 8>& children, float* near, std::int32_t* rays,
                               std::int32_t* child) const {
    const WordTag tag;
    const auto number = hn::Set(tag, 7), sign = hn::Set(tag, std::numeric_limits<std::int32_t>::min());
    hn::Vec<WordTag> key[parts], children_of[parts];
    std::size_t count = 0;
    // The bits of a number as a whole number stand in the order of the numbers; the last three say which child it is.
    for (std::size_t i = 0; i < parts; ++i) {
      const auto own = hn::Iota(tag, static_cast<std::int32_t>(i * lanes));
      const auto unmet = hn::Eq(met_.rays_[i], hn::Zero(tag));
      const auto distance = hn::AndNot(hn::Or(sign, number), hn::BitCast(tag, near_[i]));
      key[i] = hn::IfThenElse(unmet, hn::Or(sign, own), hn::Or(distance, own));
      children_of[i] = hn::LoadU(tag, children.data() + i * lanes);
      count += lanes - hn::CountTrue(tag, unmet);
    }
    sort(key);
    for (std::size_t i = 0; i < parts; ++i) {
      const auto own = hn::And(number, key[i]);
      hn::StoreU(hn::BitCast(PartTag(), hn::AndNot(number, key[i])), PartTag(), near + i * lanes);
      hn::StoreU(at(met_.rays_, own), tag, rays + i * lanes);
      hn::StoreU(at(children_of, own), tag, child + i * lanes);
    }
    return count;
  }

 private:
  using PartTag = Eight::PartTag;
  using WordTag = Met::WordTag;
  static constexpr std::size_t lanes = Eight::lanes, parts = Eight::parts;

  static HWY_INLINE hn::Vec<WordTag> at(const hn::Vec<WordTag> (&words)[parts], hn::Vec<WordTag> place) {
    const WordTag tag;
    if constexpr (parts == 1) {
      return hn::TableLookupLanes(words[0], hn::IndicesFromVec(tag, place));
    } else {
      const auto within = hn::IndicesFromVec(tag, hn::And(place, hn::Set(tag, static_cast<std::int32_t>(lanes - 1))));
      return hn::IfThenElse(hn::Lt(place, hn::Set(tag, static_cast<std::int32_t>(lanes))),
                            hn::TableLookupLanes(words[0], within), hn::TableLookupLanes(words[1], within));
    }
  }

  /// The largest first, by a bitonic network: each step compares each key with a partner, and the one that stands first
  /// becomes the larger of both.
  static HWY_INLINE void sort(hn::Vec<WordTag> (&key)[parts]) {
    const WordTag tag;
    const hn::RepartitionToWide<WordTag> pairs;
    const auto with_next = [](auto a) HWY_ATTR {
      const auto b = hn::Shuffle2301(a);
      return hn::OddEven(hn::Min(a, b), hn::Max(a, b));
    };
    const auto by_pairs = [tag, pairs](auto a, auto b) HWY_ATTR {
      return hn::BitCast(tag, hn::OddEven(hn::BitCast(pairs, hn::Min(a, b)), hn::BitCast(pairs, hn::Max(a, b))));
    };
    for (auto& part : key) {
      part = with_next(part);
      part = by_pairs(part, hn::Shuffle0123(part));
      part = with_next(part);
    }
    if constexpr (parts == 1) {
      const auto b = hn::Reverse(tag, key[0]);
      key[0] = hn::ConcatUpperLower(tag, hn::Min(key[0], b), hn::Max(key[0], b));
    } else {
      const auto b = hn::Shuffle0123(key[1]);
      key[1] = hn::Shuffle0123(hn::Min(key[0], b));
      key[0] = hn::Max(key[0], b);
    }
    for (auto& part : key) {
      part = by_pairs(part, hn::Shuffle1032(part));
      part = with_next(part);
    }
  }

  Met met_;
  hn::Vec<PartTag> near_[parts];
};

}  // namespace raylab::fast::RAYLAB_TARGET
