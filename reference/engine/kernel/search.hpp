// Part of the kernel; kernel/parts.hpp says how the parts are put together.

namespace raylab::fast::RAYLAB_TARGET {

/// Tests rays, or all that is within `radius` of one, against the boxes of a node, all eight at once.
///
/// The boxes are widened by the radius, and by what rounding can do to the ray, to the box and to the sphere test together,
/// as far from the middle as the ray starts: whatever the sphere test would have called a hit, a box never hides. So the
/// picture is the same, to the bit, with the hierarchy and without it.
template <std::size_t rays>
class Probes {
 public:
  template <class T>
  using Vectors = std::array<std::array<T, rays>, 3>;  // x, y and z of all

  template <class T>
  Probes(const Hierarchy& hierarchy, const Vectors<T>& origin, const Vectors<T>& direction, double radius) {
    constexpr float rounding = 0x1p-18f;
    std::array<float, rays> farthest;
    farthest.fill(hierarchy.extent());
    std::array<std::array<float, rays>, 3> from;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < rays; ++i) {
        from[axis][i] = static_cast<float>(origin[axis][i] - hierarchy.middle()[axis]);
        farthest[i] = std::max(farthest[i], std::abs(from[axis][i]));
      }
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < rays; ++i) {
        const float wider = static_cast<float>(radius) * (1 + rounding) + rounding * farthest[i];
        const float along = static_cast<float>(direction[axis][i]);
        // A component of 0, which has no reciprocal, is as good as 1e-18.
        const float inverse = 1 / std::copysign(std::max(std::abs(along), 1e-18f), along);
        const float entry = std::copysign(wider, along);
        Axis& a = axes_[axis];
        a.inverse[i] = inverse;
        a.entry_start[i] = (from[axis][i] + entry) * inverse;
        a.exit_start[i] = (from[axis][i] - entry) * inverse;
        a.backwards[i] = std::bit_cast<std::uint32_t>(along) >> 31;
      }
  }

  /// Bit k: may there be something in the box of child k, at up to `limit` along ray i? `near` becomes the distance of that
  /// box, if it was further.
  RAYLAB_INLINE std::uint32_t boxes_met(std::size_t i, const Hierarchy::Node& node, float limit, Eight& near) const {
    Eight from(0.0f), to(limit);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Axis& a = axes_[axis];
      const Eight inverse(a.inverse[i]);
      const std::size_t far = a.backwards[i];
      from = greater(from, multiply_subtract(Eight::load(node.planes[far][axis]), inverse, Eight(a.entry_start[i])));
      to = lesser(to, multiply_subtract(Eight::load(node.planes[1 - far][axis]), inverse, Eight(a.exit_start[i])));
    }
    near = lesser(near, where_at_most(from, to, from));
    return at_most(from, to);
  }

 private:
  struct Axis {
    std::array<float, rays> inverse, entry_start, exit_start;
    std::array<std::uint32_t, rays> backwards;  ///< 1: the ray crosses the planes where boxes end first
  };

  std::array<Axis, 3> axes_;
};

/// How far the ray of each lane is to be followed; below 0: no further.
template <std::size_t lanes>
class Limits {
 public:
  Limits() { eights_.fill({-1, -1, -1, -1, -1, -1, -1, -1}); }

  float& operator[](std::size_t lane) { return eights_[lane / 8][lane % 8]; }

  /// Bit i: does that of lane i reach as far as `distance`?
  RAYLAB_INLINE std::uint32_t reaching(float distance) const {
    std::uint32_t mask = 0;
    for (std::size_t i = 0; i < eights_.size(); ++i) mask |= at_most(Eight(distance), Eight::load(eights_[i])) << (8 * i);
    return mask;
  }

 private:
  alignas(64) std::array<std::array<float, 8>, (lanes + 7) / 8> eights_;
};

/// What waits in a search: a node or a leaf, how far it is at least, and the rays, by lane, that may meet something there.
struct Waiting {
  float near;
  std::uint32_t lanes;
  Hierarchy::Child child;
};

/// The nearest one is at the top, but for those that were put below it earlier.
class Stack {
 public:
  bool empty() const { return size_ == 0; }

  Waiting pop() {
    --size_;
    return {near_[size_], lanes_[size_], child_[size_]};
  }

  /// The children of `met`, the nearest last. All eight are written, each in its place in that order, and those not met
  /// behind it: a loop over few children would end in a surprise for the machine each time.
  RAYLAB_INLINE void push(const Hierarchy::Node& node, const Eight& distances, const std::array<std::uint32_t, 8>& lanes,
                          std::uint32_t met) {
    std::array<float, 8> near;
    std::array<std::int32_t, 8> place;
    distances.store(near);
    places_by_distance(distances, met, place);
    for (std::size_t i = 0; i < Hierarchy::width; ++i) {
      const std::size_t at = size_ + static_cast<std::size_t>(place[i]);
      near_[at] = near[i];
      lanes_[at] = lanes[i];
      child_[at] = node.child[i];
    }
    size_ += static_cast<std::size_t>(std::popcount(met));
  }

 private:
  static constexpr std::size_t most = Hierarchy::deepest * (Hierarchy::width - 1) + 2 * Hierarchy::width;

  std::array<float, most> near_;
  std::array<std::uint32_t, most> lanes_;
  std::array<Hierarchy::Child, most> child_;
  std::size_t size_ = 0;
};

/// For a beam. Calls leaf(begin, count), near ones first, for each leaf in whose box there may be something at up to the
/// distance that the last call returned; at first `limit`. Ends when that is below 0.
template <class Leaf>
void search_together(const Hierarchy& hierarchy, const Probes<1>& probe, float limit, Leaf leaf) {
  constexpr std::array<std::uint32_t, 8> lanes{};
  Stack stack;
  Hierarchy::Child next = Hierarchy::Child::node(0);
  while (limit >= 0) {
    if (next.is_leaf())
      limit = leaf(next.begin(), next.count());
    else {
      const Hierarchy::Node& node = hierarchy.nodes()[next.number()];
      Eight near(std::numeric_limits<float>::infinity());
      const std::uint32_t met = probe.boxes_met(0, node, limit, near);
      stack.push(node, near, lanes, met);
    }
    float distance;
    do {
      if (stack.empty()) return;
      const Waiting top = stack.pop();
      distance = top.near;
      next = top.child;
    } while (distance > limit && limit >= 0);
  }
}

/// For many rays that go different ways: each node is tested for one after the other, which keeps the machine busy where
/// the way of a single ray would be one long wait. Calls leaf(begin, count, lane) for each leaf in whose box the ray of
/// `lane` may meet something at up to limits[lane], which that call may lower; below 0 the ray is done.
template <std::size_t most_lanes, class Leaf>
void search_each(const Hierarchy& hierarchy, const Probes<most_lanes>& probes, std::uint32_t lanes,
                 Limits<most_lanes>& limits, Leaf leaf) {
  constexpr std::size_t rows = std::max<std::size_t>(16, most_lanes);  // what the smallest register holds

  Stack stack;
  Waiting next = {0, lanes, Hierarchy::Child::node(0)};
  for (;;) {
    if (next.child.is_leaf()) {
      for (std::uint32_t rest = next.lanes; rest != 0; rest &= rest - 1)
        leaf(next.child.begin(), next.child.count(), static_cast<std::size_t>(std::countr_zero(rest)));
    } else {
      const Hierarchy::Node& node = hierarchy.nodes()[next.child.number()];
      Eight near(std::numeric_limits<float>::infinity());
      std::array<std::uint8_t, rows> boxes{};
      std::uint32_t met = 0;
      for (std::uint32_t rest = next.lanes; rest != 0; rest &= rest - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
        const std::uint32_t here = probes.boxes_met(lane, node, limits[lane], near);
        boxes[lane] = static_cast<std::uint8_t>(here);
        met |= here;
      }
      if (met != 0) stack.push(node, near, transposed(boxes), met);
    }
    do {
      if (stack.empty()) return;
      next = stack.pop();
      next.lanes &= limits.reaching(next.near);
    } while (next.lanes == 0);
  }
}

/// A distance as a float that is not less, and by more than a box's own distance may be off.
template <class T>
float as_limit(T t) {
  return static_cast<float>(t) * (1 + 0x1p-19f);
}

/// Those of `lanes`, bit by bit; the others end at once.
template <class T, std::size_t count>
Limits<count> limits_of(std::uint32_t lanes, const std::array<T, count>& lengths) {
  Limits<count> limits;
  for (std::size_t lane = 0; lane < lengths.size(); ++lane)
    limits[lane] = (lanes >> lane & 1) != 0 ? as_limit(lengths[lane]) : -1.0f;
  return limits;
}

}  // namespace raylab::fast::RAYLAB_TARGET
