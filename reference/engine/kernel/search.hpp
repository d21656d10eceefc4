// Part of the kernel; kernel/parts.hpp says how the parts are put together.

namespace raylab::fast::RAYLAB_TARGET {

/// Tests a ray, or all that is within `radius` of it, against the boxes of a node, all eight at once.
///
/// The boxes are widened by the radius, and by what rounding can do to the ray, to the box and to the sphere test together,
/// as far from the middle as the ray starts: whatever the sphere test would have called a hit, a box never hides. So the
/// picture is the same, to the bit, with the hierarchy and without it.
class Probe {
 public:
  template <class T>
  Probe(const Hierarchy& hierarchy, const Point<T>& origin, const Point<T>& direction, double radius) {
    constexpr float rounding = 0x1p-18f;
    const std::array<double, 3>& middle = hierarchy.middle();
    const std::array<float, 3> from = {static_cast<float>(origin.x - middle[0]), static_cast<float>(origin.y - middle[1]),
                                       static_cast<float>(origin.z - middle[2])};
    const std::array<float, 3> along = {static_cast<float>(direction.x), static_cast<float>(direction.y),
                                        static_cast<float>(direction.z)};
    const float farthest = std::max({hierarchy.extent(), std::abs(from[0]), std::abs(from[1]), std::abs(from[2])});
    const float wider = static_cast<float>(radius) * (1 + rounding) + rounding * farthest;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Axis& a = axes_[axis];
      a.negative = along[axis] < 0;
      // A component of 0, which has no reciprocal, is as good as 1e-18.
      const float inverse = (a.negative ? -1 : 1) / std::max(std::abs(along[axis]), 1e-18f);
      a.inverse = Eight(inverse);
      a.entry_start = Eight((a.negative ? from[axis] - wider : from[axis] + wider) * inverse);
      a.exit_start = Eight((a.negative ? from[axis] + wider : from[axis] - wider) * inverse);
    }
  }

  /// Bit i: may there be something in the box of child i, at up to `limit`? `near` gets the distances of the boxes.
  std::uint32_t boxes_met(const Hierarchy::Node& node, float limit, std::array<float, 8>& near) const {
    Eight from(0.0f), to(limit);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Axis& a = axes_[axis];
      const Eight entry = Eight::load(a.negative ? node.high[axis] : node.low[axis]);
      const Eight exit = Eight::load(a.negative ? node.low[axis] : node.high[axis]);
      from = greater(from, multiply_subtract(entry, a.inverse, a.entry_start));
      to = lesser(to, multiply_subtract(exit, a.inverse, a.exit_start));
    }
    from.store(near);
    return at_most(from, to);
  }

 private:
  struct Axis {
    Eight inverse, entry_start, exit_start;
    bool negative;
  };

  std::array<Axis, 3> axes_;
};

/// Calls leaf(begin, count), near ones first, for each leaf in whose box there may be something at up to the distance that
/// the last call returned; at first `limit`. Ends when that is below 0.
template <class Leaf>
void search(const Hierarchy& hierarchy, const Probe& probe, float limit, Leaf leaf) {
  struct Waiting {
    float near;
    Hierarchy::Child child;
  };
  std::array<Waiting, Hierarchy::deepest * (Hierarchy::width - 1) + Hierarchy::width> stack;
  std::size_t size = 0;
  Hierarchy::Child next = Hierarchy::Child::node(0);
  while (limit >= 0) {
    if (next.is_leaf())
      limit = leaf(next.begin(), next.count());
    else {
      const Hierarchy::Node& node = hierarchy.nodes()[next.number()];
      std::array<float, 8> near;
      std::uint32_t met = probe.boxes_met(node, limit, near);
      if (std::has_single_bit(met)) {
        next = node.child[static_cast<std::size_t>(std::countr_zero(met))];
        continue;
      }
      for (const std::size_t first = size; met != 0; met &= met - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(met));
        std::size_t at = size++;
        for (; at > first && stack[at - 1].near < near[i]; --at) stack[at] = stack[at - 1];
        stack[at] = {near[i], node.child[i]};
      }
    }
    do {
      if (size == 0) return;
      --size;
    } while (stack[size].near > limit && limit >= 0);
    next = stack[size].child;
  }
}

/// A distance as a float that is not less, and by more than a box's own distance may be off.
template <class T>
float as_limit(T t) {
  return static_cast<float>(t) * (1 + 0x1p-19f);
}

}  // namespace raylab::fast::RAYLAB_TARGET
