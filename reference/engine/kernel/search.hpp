// Part of the kernel; kernel/parts.hpp says how the parts are put together.

namespace raylab::fast::RAYLAB_TARGET {

/// Tests rays against the boxes of a node, all eight at once. For one ray or a bundle of them: then a box is left out only
/// if certainly none of the rays meets it.
///
/// The boxes are wider by what rounding can do to the ray, to the box and to the sphere test together, as far from the
/// middle as the ray starts: whatever the sphere test would have called a hit, a box never hides. So the picture is the
/// same, to the bit, with the hierarchy and without it.
class Probe {
 public:
  /// Component by component, the bounds of where the rays start and of their directions.
  struct Bounds {
    std::array<double, 3> low_origin, high_origin;
    std::array<double, 3> low_direction, high_direction;
  };

  Probe(const Hierarchy& hierarchy, const Bounds& rays) {
    constexpr float rounding = 0x1p-19f;
    std::array<float, 3> low{}, high{};
    float farthest = hierarchy.extent();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = static_cast<float>(rays.low_origin[axis] - hierarchy.middle()[axis]);
      high[axis] = static_cast<float>(rays.high_origin[axis] - hierarchy.middle()[axis]);
      farthest = std::max(farthest, std::max(std::abs(low[axis]), std::abs(high[axis])));
    }
    const float wider = 2 * rounding * farthest;
    for (std::size_t axis = 0; axis < 3; ++axis)
      set_axis(axis, low[axis] - wider, high[axis] + wider, static_cast<float>(rays.low_direction[axis]),
               static_cast<float>(rays.high_direction[axis]));
  }

  /// Bit i: may a ray meet something in the box of child i at up to `limit`? `near` gets the distances of the boxes.
  std::uint32_t boxes_met(const Hierarchy::Node& node, float limit, std::array<float, 8>& near) const {
    Eight from(0.0f), to(limit);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Axis& a = axes_[axis];
      const Eight entry = Eight::load(a.negative ? node.high[axis] : node.low[axis]) - a.entry_origin;
      const Eight exit = Eight::load(a.negative ? node.low[axis] : node.high[axis]) - a.exit_origin;
      from = greater(from, lesser(entry * a.low_inverse, entry * a.high_inverse));
      to = lesser(to, greater(exit * a.low_inverse, exit * a.high_inverse));
    }
    from.store(near);
    return at_most(from, to);
  }

 private:
  struct Axis {
    Eight entry_origin, exit_origin, low_inverse, high_inverse;
    bool negative = false;
  };

  /// A direction's component of 0, which has no reciprocal, is as good as 1e-18.
  static float reciprocal(float a, bool negative) { return (negative ? -1 : 1) / std::max(std::abs(a), 1e-18f); }

  void set_axis(std::size_t axis, float low, float high, float low_direction, float high_direction) {
    Axis& a = axes_[axis];
    if (low_direction < 0 && high_direction > 0) {  // towards both ends: this axis excludes nothing
      constexpr float all = 1e18f;
      a = {Eight(all), Eight(-all), Eight(all), Eight(all), false};
      return;
    }
    a.negative = low_direction < 0;
    a.entry_origin = Eight(a.negative ? low : high);
    a.exit_origin = Eight(a.negative ? high : low);
    a.low_inverse = Eight(reciprocal(high_direction, a.negative));
    a.high_inverse = Eight(reciprocal(low_direction, a.negative));
  }

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
      const std::size_t first = size;
      for (std::uint32_t met = probe.boxes_met(node, limit, near); met != 0; met &= met - 1) {
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
