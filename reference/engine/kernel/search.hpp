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
        Axis& a = axes_[axis];
        a.inverse[i] = inverse;
        a.low_start[i] = (from[axis][i] + wider) * inverse;
        a.high_start[i] = (from[axis][i] - wider) * inverse;
      }
  }

  /// Adds ray i, as bit i, to those children of a node in whose boxes there may be something at up to `limit` along it.
  template <class Children>
  RAYLAB_INLINE void meet_boxes(std::size_t i, const Hierarchy::Node& node, float limit, Children& met) const {
    Eight from(0.0f), to(limit);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Axis& a = axes_[axis];
      const Eight inverse(a.inverse[i]);
      const Eight low = multiply_subtract(Eight::load(node.planes[0][axis].data()), inverse, Eight(a.low_start[i]));
      const Eight high = multiply_subtract(Eight::load(node.planes[1][axis].data()), inverse, Eight(a.high_start[i]));
      from = greater(from, lesser(low, high));
      to = lesser(to, greater(low, high));
    }
    met.add(std::uint32_t{1} << i, from, to);
  }

 private:
  struct Axis {
    std::array<float, rays> inverse, low_start, high_start;
  };

  std::array<Axis, 3> axes_;
};

/// What waits in a search: a node or a leaf, how far it is at least (0: nobody knows), and the rays, by lane, that may meet
/// something there.
struct Waiting {
  float near;
  std::uint32_t lanes;
  Hierarchy::Child child;
};

/// With MetInOrder the nearest one is at the top, but for those that were put below it earlier. With Met they stand in any
/// order, without their distances.
template <class Children>
class Stack {
 public:
  bool empty() const { return size_ == 0; }

  Waiting pop() {
    --size_;
    return {in_order ? near_[size_] : 0, static_cast<std::uint32_t>(lanes_[size_]),
            std::bit_cast<Hierarchy::Child>(child_[size_])};
  }

  /// Those children of the node that rays meet.
  RAYLAB_INLINE void push(const Hierarchy::Node& node, const Children& met) {
    const auto children = std::bit_cast<std::array<std::int32_t, Hierarchy::width>>(node.child);
    if constexpr (in_order)
      size_ += met.store(children, &near_[size_], &lanes_[size_], &child_[size_]);
    else
      size_ += met.store(children, &lanes_[size_], &child_[size_]);
  }

 private:
  static constexpr bool in_order = std::is_same_v<Children, MetInOrder>;
  static constexpr std::size_t most = Hierarchy::deepest * (Hierarchy::width - 1) + 2 * Hierarchy::width;

  std::array<float, most> near_;
  std::array<std::int32_t, most> lanes_, child_;
  std::size_t size_ = 0;
};

/// For a beam. Calls leaf(begin, count) for each leaf in whose box there may be something at up to the distance that the
/// last call returned; at first `limit`. Ends when that is below 0.
template <class Children, class Leaf>
void search_together(const Hierarchy& hierarchy, const Probes<1>& probe, float limit, Leaf leaf) {
  Stack<Children> stack;
  Hierarchy::Child next = Hierarchy::Child::node(0);
  while (limit >= 0) {
    if (next.is_leaf())
      limit = leaf(next.begin(), next.count());
    else {
      const Hierarchy::Node& node = hierarchy.nodes()[next.number()];
      Children met;
      probe.meet_boxes(0, node, limit, met);
      stack.push(node, met);
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
/// the way of a single ray would be one long wait. Calls leaf(begin, count, lanes) for each leaf in whose box rays may meet
/// something as far as `limits` allow, which that call may shorten.
template <std::size_t most_lanes, class Limits, class Leaf>
void search_each(const Hierarchy& hierarchy, const Probes<most_lanes>& probes, const Limits& limits, Leaf leaf) {
  Stack<typename Limits::Children> stack;
  Waiting next = {0, limits.lanes_at(0), Hierarchy::Child::node(0)};
  for (;;) {
    if (next.child.is_leaf()) {
      leaf(next.child.begin(), next.child.count(), next.lanes);
    } else {
      const Hierarchy::Node& node = hierarchy.nodes()[next.child.number()];
      typename Limits::Children met;
      for (std::uint32_t rest = next.lanes; rest != 0; rest &= rest - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
        probes.meet_boxes(lane, node, limits[lane], met);
      }
      stack.push(node, met);
    }
    do {
      if (stack.empty()) return;
      next = stack.pop();
      next.lanes &= limits.lanes_at(next.near);
    } while (next.lanes == 0);
  }
}

/// A distance as a float that is not less, and by more than a box's own distance may be off.
template <class T>
float as_limit(T t) {
  return static_cast<float>(t) * (1 + 0x1p-19f);
}

/// How far the ray of each lane is to be followed that looks for the nearest thing: less far with each that it finds.
template <std::size_t count>
class NearestLimits {
 public:
  using Children = MetInOrder;

  /// Only those of `lanes`, bit by bit.
  template <class T>
  NearestLimits(std::uint32_t lanes, const std::array<T, count>& lengths) {
    limits_.fill(-1);
    for (std::size_t lane = 0; lane < count; ++lane)
      if ((lanes >> lane & 1) != 0) shorten(lane, lengths[lane]);
  }

  float operator[](std::size_t lane) const { return limits_[lane]; }

  template <class T>
  void shorten(std::size_t lane, T length) {
    limits_[lane] = as_limit(length);
  }

  /// Bit i: does the ray of lane i get as far as `distance`?
  RAYLAB_INLINE std::uint32_t lanes_at(float distance) const {
    std::uint32_t lanes = 0;
    for (std::size_t i = 0; i < limits_.size(); i += 8) lanes |= at_most(Eight(distance), Eight::load(&limits_[i])) << i;
    return lanes;
  }

 private:
  alignas(64) std::array<float, (count + 7) / 8 * 8> limits_;
};

/// The same for rays that look for anything at all: then they are not followed any further. It does not matter to them what
/// they find first, so nothing has to stand in order.
template <std::size_t count>
class AnyLimits {
 public:
  using Children = Met;

  template <class T>
  AnyLimits(std::uint32_t lanes, const std::array<T, count>& lengths) : lanes_(lanes) {
    for (std::size_t lane = 0; lane < count; ++lane) limits_[lane] = as_limit(lengths[lane]);
  }

  float operator[](std::size_t lane) const { return limits_[lane]; }
  void stop(std::size_t lane) { lanes_ &= ~(std::uint32_t{1} << lane); }
  std::uint32_t lanes_at(float) const { return lanes_; }
  std::uint32_t lanes() const { return lanes_; }  ///< that have found nothing

 private:
  std::array<float, count> limits_;
  std::uint32_t lanes_;
};

}  // namespace raylab::fast::RAYLAB_TARGET
