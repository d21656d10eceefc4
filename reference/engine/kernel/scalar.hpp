// Part of the kernel; kernel/parts.hpp says how the parts are put together.

/// A single number seen as a pack of one lane: the functions that pack.hpp has for packs, with the same meaning to the bit.
namespace raylab::fast::RAYLAB_TARGET {

template <class T>
concept Number = std::is_floating_point_v<T>;

template <class V>
struct Lanes;

template <Number T>
struct Lanes<T> {
  using Number = T;
  using Mask = bool;
  using Whole = std::conditional_t<sizeof(T) == sizeof(std::int32_t), std::int32_t, std::int64_t>;
  using Index = Whole;
  using Single = T;  ///< of two packs side by side, one; else the thing itself
  static constexpr int count = 1;
};

template <class V>
using NumberOf = typename Lanes<V>::Number;
template <class V>
using MaskOf = typename Lanes<V>::Mask;
template <class V>
using IndexOf = typename Lanes<V>::Index;
template <class V>
using WholeOf = typename Lanes<V>::Whole;
template <class V>
using SingleOf = typename Lanes<V>::Single;

template <Number T>
T select(bool condition, T yes, T no) {
  return condition ? yes : no;
}
inline bool select(bool condition, bool yes, bool no) { return condition ? yes : no; }
inline std::int32_t select(bool condition, std::int32_t yes, std::int32_t no) { return condition ? yes : no; }
inline std::int64_t select(bool condition, std::int64_t yes, std::int64_t no) { return condition ? yes : no; }

/// Those of `lanes` that are not `others`.
inline bool without(bool lanes, bool others) { return lanes && !others; }

/// Bit i is lane i.
inline std::uint32_t bits(bool mask) { return mask ? 1 : 0; }
inline std::size_t count(bool mask) { return mask ? 1 : 0; }
inline bool any(bool mask) { return mask; }
inline bool none(bool mask) { return !mask; }

template <Number T>
T square_root(T a) {
  return std::sqrt(a);
}

/// a < b ? a : b, and so b where either is no number.
template <Number T>
T least(T a, T b) {
  return select(a < b, a, b);
}
/// a > b ? a : b.
template <Number T>
T greatest(T a, T b) {
  return select(a > b, a, b);
}

/// |a| with its sign bit cleared.
template <Number T>
T magnitude(T a) {
  return std::abs(a);
}

template <Number V>
bool mask_of(std::uint32_t bits) {
  return bits != 0;
}

/// numbers[i], numbers[i + 1] and so on, one in each lane.
template <Number V>
V load(const V* numbers) {
  return *numbers;
}
template <Number V>
IndexOf<V> load_index(const WholeOf<V>* numbers) {
  return *numbers;
}

template <Number T>
void store(T a, T* numbers) {
  *numbers = a;
}
inline void store(std::int32_t a, std::int32_t* numbers) { *numbers = a; }
inline void store(std::int64_t a, std::int64_t* numbers) { *numbers = a; }

/// numbers[place] of each lane's place.
inline float gather(const float* numbers, std::int32_t place) { return numbers[place]; }
inline double gather(const double* numbers, std::int64_t place) { return numbers[place]; }

/// 0, 1, 2, ... in the lanes.
template <Number V>
IndexOf<V> lane_numbers() {
  return 0;
}

/// `a` as m 2^k with m about as large as `b`: 2/3 b < m < 3/2 b. For normal a > 0, and b from twice the smallest of these
/// numbers to 4.
///
/// The bits of a number, taken as a whole number, are the exponent and behind its point the rest: nearly the logarithm.
template <Number T>
void split_ratio(T a, T b, T& m, T& k) {
  using Int = IndexOf<T>;
  constexpr int mantissa_bits = std::numeric_limits<T>::digits - 1;
  const Int exponent = (std::bit_cast<Int>(a) - std::bit_cast<Int>(b) + (Int(1) << (mantissa_bits - 1))) >> mantissa_bits;
  k = static_cast<T>(exponent);
  m = std::bit_cast<T>(static_cast<Int>(std::bit_cast<Int>(a) - (exponent << mantissa_bits)));
}

/// 2^k for a whole number k that is given as k + magic<T>.
template <Number T>
T power_of_two(T k_and_magic) {
  using Unsigned = std::make_unsigned_t<IndexOf<T>>;
  constexpr int mantissa_bits = std::numeric_limits<T>::digits - 1;
  constexpr Unsigned bias = std::numeric_limits<T>::max_exponent - 1;
  return std::bit_cast<T>(static_cast<Unsigned>((std::bit_cast<Unsigned>(k_and_magic) + bias) << mantissa_bits));
}

template <Number T>
void store_interleaved(T x, T y, T z, double* numbers) {
  numbers[0] = x;
  numbers[1] = y;
  numbers[2] = z;
}

template <Number T>
T greatest_lane(T a) {
  return a;
}

inline std::int32_t whole(float a) { return static_cast<std::int32_t>(a); }
inline std::int64_t whole(double a) { return static_cast<std::int64_t>(a); }

template <int bits>
std::int32_t shifted_left(std::int32_t a) {
  return a << bits;
}
template <int bits>
std::int64_t shifted_left(std::int64_t a) {
  return a << bits;
}

#ifndef RAYLAB_PACKS
/// Eight floats, one for each child of a node.
class Eight {
 public:
  Eight() = default;
  explicit Eight(float a) { numbers_.fill(a); }

  static Eight load(const float* numbers) {
    Eight result;
    std::copy_n(numbers, 8, result.numbers_.begin());
    return result;
  }

  friend Eight multiply_subtract(const Eight& a, const Eight& b, const Eight& c) {
    Eight result;
    for (std::size_t i = 0; i < 8; ++i) result.numbers_[i] = a.numbers_[i] * b.numbers_[i] - c.numbers_[i];
    return result;
  }
  friend Eight lesser(const Eight& a, const Eight& b) {
    return each(a, b, [](float x, float y) { return x < y ? x : y; });
  }
  friend Eight greater(const Eight& a, const Eight& b) {
    return each(a, b, [](float x, float y) { return x > y ? x : y; });
  }
  /// Bit i: is number i of `a` at most that of `b`?
  friend std::uint32_t at_most(const Eight& a, const Eight& b) {
    std::uint32_t mask = 0;
    for (std::size_t i = 0; i < 8; ++i) mask |= static_cast<std::uint32_t>(a.numbers_[i] <= b.numbers_[i]) << i;
    return mask;
  }

 private:
  friend class Met;
  friend class MetInOrder;

  template <class Function>
  static Eight each(const Eight& a, const Eight& b, Function function) {
    Eight result;
    for (std::size_t i = 0; i < 8; ++i) result.numbers_[i] = function(a.numbers_[i], b.numbers_[i]);
    return result;
  }

  std::array<float, 8> numbers_;
};

/// Which children of a node rays meet: for each child the rays, as bits.
class Met {
 public:
  /// A ray, which is a bit, meets the children whose number of `from` is at most that of `to`.
  void add(std::uint32_t ray, const Eight& from, const Eight& to) {
    for (std::size_t i = 0; i < 8; ++i)
      if (from.numbers_[i] <= to.numbers_[i]) rays_[i] |= static_cast<std::int32_t>(ray);
  }

  /// Writes the numbers of the children that are met. Returns how many these are.
  std::size_t store(const std::array<std::int32_t, 8>& children, std::int32_t* rays, std::int32_t* child) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      if (rays_[i] == 0) continue;
      rays[count] = rays_[i];
      child[count] = children[i];
      ++count;
    }
    return count;
  }

 private:
  friend class MetInOrder;

  std::array<std::int32_t, 8> rays_{};
};

/// The same, and for each child how far the nearest of its rays has to go.
class MetInOrder {
 public:
  MetInOrder() { near_.fill(std::numeric_limits<float>::infinity()); }

  void add(std::uint32_t ray, const Eight& from, const Eight& to) {
    met_.add(ray, from, to);
    for (std::size_t i = 0; i < 8; ++i)
      if (from.numbers_[i] <= to.numbers_[i]) near_[i] = std::min(near_[i], from.numbers_[i]);
  }

  /// They stand in order, the nearest last.
  std::size_t store(const std::array<std::int32_t, 8>& children, float* near, std::int32_t* rays,
                    std::int32_t* child) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      if (met_.rays_[i] == 0) continue;
      std::size_t at = count++;
      for (; at > 0 && near[at - 1] < near_[i]; --at) {
        near[at] = near[at - 1];
        rays[at] = rays[at - 1];
        child[at] = child[at - 1];
      }
      near[at] = near_[i];
      rays[at] = met_.rays_[i];
      child[at] = children[i];
    }
    return count;
  }

 private:
  Met met_;
  std::array<float, 8> near_;
};
#endif

}  // namespace raylab::fast::RAYLAB_TARGET
