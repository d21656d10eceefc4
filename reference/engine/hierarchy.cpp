#include "reference/engine/hierarchy.hpp"

#include "reference/engine/parallel.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace raylab::fast {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr std::size_t shares = 16;  // of work that is divided; the tree must not depend on the number of threads

/// The fourth number is there for compilers, which do four at a time.
using Float4 = std::array<float, 4>;

struct Box {
  Float4 low{infinity, infinity, infinity, infinity};
  Float4 high{-infinity, -infinity, -infinity, -infinity};

  void add(const Box& other) {
    for (std::size_t i = 0; i < 4; ++i) {
      low[i] = other.low[i] < low[i] ? other.low[i] : low[i];
      high[i] = other.high[i] > high[i] ? other.high[i] : high[i];
    }
  }

  void add(const Float4& point) { add(Box{point, point}); }

  std::array<float, 3> size() const { return {high[0] - low[0], high[1] - low[1], high[2] - low[2]}; }

  /// Half the surface. In double: the square of 1e15 leaves a float's range soon.
  double area() const {
    const auto [x, y, z] = size();
    return x < 0 ? 0 : double{x} * y + double{y} * z + double{z} * x;
  }
};

using Double3 = std::array<double, 3>;

Double3 components(const Vec3& v) { return {v.x, v.y, v.z}; }

float rounded_down(double a) {
  const float rounded = static_cast<float>(a);
  return rounded <= a ? rounded : std::nextafter(rounded, -infinity);
}

/// Spheres as the engine has them, and where their boxes are measured from.
struct Frame {
  std::span<const Sphere> spheres;
  Hierarchy::Numbers numbers;
  Double3 origin;
  Double3 middle;

  double rounded(double a) const { return numbers == Hierarchy::Numbers::floats ? static_cast<float>(a) : a; }

  Box box(std::size_t i) const {
    const Double3 center = components(spheres[i].center);
    const double radius = rounded(spheres[i].radius);
    Box box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      // c - m and then - R round twice: the widening is more than both of them.
      const double c = rounded(center[axis] - origin[axis]) - middle[axis];
      const double wider = 4 * std::numeric_limits<double>::epsilon() * (std::abs(center[axis] - origin[axis]) + radius);
      box.low[axis] = rounded_down(c - radius - wider);
      box.high[axis] = -rounded_down(-(c + radius + wider));
    }
    return box;
  }
};

// ---- Spheres in the order of a space-filling curve ---------------------------------------------------------------------

/// The corners of the box of the spheres' centers.
struct Bounds {
  Double3 low, high;
};

Bounds bounds_of_centers(std::span<const Sphere> spheres, unsigned threads) {
  std::array<Bounds, shares> parts;
  in_parallel(shares, threads, [&](std::size_t i) {
    const Share share(spheres.size(), i, shares);
    Bounds& part = parts[i];
    part.low.fill(std::numeric_limits<double>::infinity());
    part.high.fill(-std::numeric_limits<double>::infinity());
    for (const Sphere& sphere : spheres.subspan(share.begin, share.end - share.begin)) {
      const Double3 center = components(sphere.center);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        part.low[axis] = std::min(part.low[axis], center[axis]);
        part.high[axis] = std::max(part.high[axis], center[axis]);
      }
    }
  });
  Bounds all = parts[0];
  for (const Bounds& part : parts)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      all.low[axis] = std::min(all.low[axis], part.low[axis]);
      all.high[axis] = std::max(all.high[axis], part.high[axis]);
    }
  return all;
}

/// A sphere's place on the Morton curve, 10 bits an axis, above its number.
using Key = std::uint64_t;

constexpr std::uint32_t curve_place(Key key) { return static_cast<std::uint32_t>(key >> 32); }
constexpr std::uint32_t sphere_number(Key key) { return static_cast<std::uint32_t>(key); }

/// The ten bits of `a` with two zeros between any two of them.
constexpr std::uint32_t spread_bits(std::uint32_t a) {
  a = (a * 0x00010001u) & 0xFF0000FFu;
  a = (a * 0x00000101u) & 0x0F00F00Fu;
  a = (a * 0x00000011u) & 0xC30C30C3u;
  return (a * 0x00000005u) & 0x49249249u;
}

std::vector<Key> curve_keys(std::span<const Sphere> spheres, const Bounds& bounds, unsigned threads) {
  Double3 scale{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double size = bounds.high[axis] - bounds.low[axis];
    scale[axis] = size > 0 ? 1023.999 / size : 0;
  }
  std::vector<Key> keys(spheres.size());
  in_parallel(shares, threads, [&](std::size_t i) {
    const Share share(spheres.size(), i, shares);
    for (std::size_t k = share.begin; k < share.end; ++k) {
      const Double3 center = components(spheres[k].center);
      std::uint32_t place = 0;
      for (std::size_t axis = 0; axis < 3; ++axis)
        place |= spread_bits(static_cast<std::uint32_t>((center[axis] - bounds.low[axis]) * scale[axis])) << axis;
      keys[k] = Key{place} << 32 | k;
    }
  });
  return keys;
}

/// Radix sort by the place on the curve, 10 bits a pass.
void sort_keys(std::vector<Key>& keys, unsigned threads) {
  constexpr std::size_t digits = 1024;
  std::vector<Key> other(keys.size());
  std::vector<std::array<std::uint32_t, digits>> starts(shares);
  for (int shift = 32; shift < 62; shift += 10) {
    const auto digit = [shift](Key key) { return (key >> shift) & (digits - 1); };
    in_parallel(shares, threads, [&](std::size_t i) {
      starts[i].fill(0);
      const Share share(keys.size(), i, shares);
      for (std::size_t k = share.begin; k < share.end; ++k) ++starts[i][digit(keys[k])];
    });
    std::uint32_t start = 0;
    for (std::size_t d = 0; d < digits; ++d)
      for (auto& of_share : starts) start += std::exchange(of_share[d], start);
    in_parallel(shares, threads, [&](std::size_t i) {
      const Share share(keys.size(), i, shares);
      for (std::size_t k = share.begin; k < share.end; ++k) other[starts[i][digit(keys[k])]++] = keys[k];
    });
    keys.swap(other);
  }
}

// ---- Leaves -----------------------------------------------------------------------------------------------------------

/// A run of spheres that becomes a leaf.
struct Leaf {
  Box box;
  std::uint32_t begin, count;

  Float4 center() const {
    Float4 point;
    for (std::size_t i = 0; i < 4; ++i) point[i] = 0.5f * box.low[i] + 0.5f * box.high[i];
    return point;
  }
};

/// Cuts sorted keys into leaves where the curve leaves a cell.
class LeafCutter {
 public:
  LeafCutter(const Frame& frame, std::vector<Key>& keys) : frame_(frame), keys_(keys) {}

  void cut(std::size_t begin, std::size_t end, std::vector<Leaf>& leaves) {
    if (end - begin <= Hierarchy::largest_leaf)
      leaves.push_back(leaf(begin, end));
    else {
      const std::size_t half = middle_of(begin, end);
      cut(begin, half, leaves);
      cut(half, end, leaves);
    }
  }

  /// Where the highest bit changes in which the first and the last place on the curve differ.
  std::size_t middle_of(std::size_t begin, std::size_t end) {
    const std::uint32_t first = curve_place(keys_[begin]), last = curve_place(keys_[end - 1]);
    if (first == last) return middle_of_cell(begin, end);
    const std::uint32_t half = last & ~(std::bit_floor(first ^ last) - 1);
    const auto at = std::partition_point(keys_.begin() + offset(begin), keys_.begin() + offset(end),
                                         [half](Key key) { return curve_place(key) < half; });
    return static_cast<std::size_t>(at - keys_.begin());
  }

 private:
  static std::ptrdiff_t offset(std::size_t i) { return static_cast<std::ptrdiff_t>(i); }

  /// The curve is not fine enough here: half of the spheres to either side, along the longest axis.
  std::size_t middle_of_cell(std::size_t begin, std::size_t end) {
    Box centers;
    for (std::size_t k = begin; k < end; ++k) centers.add(center(keys_[k]));
    const auto size = centers.size();
    const std::size_t axis = static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
    const std::size_t half = begin + (end - begin) / 2;
    std::nth_element(keys_.begin() + offset(begin), keys_.begin() + offset(half), keys_.begin() + offset(end),
                     [&](Key a, Key b) { return std::pair(center(a)[axis], a) < std::pair(center(b)[axis], b); });
    return half;
  }

  Float4 center(Key key) const {
    const Double3 c = components(frame_.spheres[sphere_number(key)].center);
    Float4 point{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      point[axis] = static_cast<float>(c[axis] - frame_.origin[axis] - frame_.middle[axis]);
    return point;
  }

  Leaf leaf(std::size_t begin, std::size_t end) const {
    Box box;
    for (std::size_t k = begin; k < end; ++k) box.add(frame_.box(sphere_number(keys_[k])));
    return {box, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end - begin)};
  }

  const Frame& frame_;
  std::vector<Key>& keys_;
};

std::vector<Leaf> cut_leaves(const Frame& frame, std::vector<Key>& keys, unsigned threads) {
  LeafCutter cutter(frame, keys);
  std::vector<std::size_t> cuts = {0, keys.size()};
  for (std::size_t i = 0; i + 1 < cuts.size();) {
    if (cuts[i + 1] - cuts[i] > std::max<std::size_t>(keys.size() / shares, Hierarchy::largest_leaf))
      cuts.insert(cuts.begin() + static_cast<std::ptrdiff_t>(i) + 1, cutter.middle_of(cuts[i], cuts[i + 1]));
    else
      ++i;
  }
  std::vector<std::vector<Leaf>> parts(cuts.size() - 1);
  in_parallel(parts.size(), threads, [&](std::size_t i) { cutter.cut(cuts[i], cuts[i + 1], parts[i]); });
  std::vector<Leaf> leaves;
  for (const std::vector<Leaf>& part : parts) leaves.insert(leaves.end(), part.begin(), part.end());
  return leaves;
}

// ---- Nodes ------------------------------------------------------------------------------------------------------------

/// Leaves that will be below one child of a node.
struct Group {
  std::span<Leaf> leaves;
  Box box;

  explicit Group(std::span<Leaf> all) : leaves(all) {
    for (const Leaf& leaf : all) box.add(leaf.box);
  }
};

/// Where to divide a group: its leaves with centers in bins up to `bin` along `axis` go to the left.
struct Cut {
  double cost = std::numeric_limits<double>::infinity();
  std::size_t axis = 0;
  std::size_t bin = 0;
};

/// Divides groups of leaves by the surface area heuristic: the chance that a ray meets a box is as its surface.
class Divider {
 public:
  explicit Divider(std::span<Leaf> leaves) : leaves_(leaves), bins_(std::min(leaves.size(), most_bins)) {
    for (const Leaf& leaf : leaves) centers_.add(leaf.center());
  }

  /// The number of leaves on the left, at least one and not all; they stand first then.
  std::size_t divide() {
    if (leaves_.size() == 2) return 1;
    Cut best;
    for (std::size_t axis = 0; axis < 3; ++axis) best_cut(axis, best);
    if (best.cost == std::numeric_limits<double>::infinity()) return leaves_.size() / 2;
    const float scale = bins_a_length(best.axis);
    const auto right = std::partition(leaves_.begin(), leaves_.end(),
                                      [&](const Leaf& leaf) { return bin(leaf, best.axis, scale) <= best.bin; });
    return static_cast<std::size_t>(right - leaves_.begin());
  }

 private:
  static constexpr std::size_t most_bins = 16;

  float bins_a_length(std::size_t axis) const {
    return static_cast<float>(bins_) / (centers_.high[axis] - centers_.low[axis]);
  }

  std::size_t bin(const Leaf& leaf, std::size_t axis, float bins_a_length) const {
    const float place = (leaf.center()[axis] - centers_.low[axis]) * bins_a_length;
    return std::min(bins_ - 1, static_cast<std::size_t>(place));
  }

  void best_cut(std::size_t axis, Cut& best) const {
    if (!(centers_.high[axis] - centers_.low[axis] > 0x1p-100f)) return;  // else bins_a_length() might be infinite
    const float scale = bins_a_length(axis);
    std::array<Box, most_bins> boxes;
    std::array<std::size_t, most_bins> counts{};
    for (const Leaf& leaf : leaves_) {
      const std::size_t at = bin(leaf, axis, scale);
      boxes[at].add(leaf.box);
      ++counts[at];
    }
    std::array<double, most_bins> right_cost{};
    Box box;
    std::size_t count = 0;
    for (std::size_t at = bins_ - 1; at > 0; --at) {
      box.add(boxes[at]);
      count += counts[at];
      right_cost[at - 1] = box.area() * static_cast<double>(count);
    }
    box = {};
    count = 0;
    for (std::size_t at = 0; at + 1 < bins_; ++at) {
      box.add(boxes[at]);
      count += counts[at];
      const double cost = box.area() * static_cast<double>(count) + right_cost[at];
      if (count > 0 && count < leaves_.size() && cost < best.cost) best = {cost, axis, at};
    }
  }

  std::span<Leaf> leaves_;
  std::size_t bins_;
  Box centers_;
};

/// Builds nodes from the top down. What is large is left as a task for others, and put in when they are done.
class NodeBuilder {
 public:
  /// Groups of up to `small` leaves become tasks.
  NodeBuilder(std::vector<Hierarchy::Node>& nodes, std::size_t small) : nodes_(nodes), small_(small) {}

  struct Task {
    std::span<Leaf> leaves;
    std::size_t node;
    std::size_t slot;
    int level;
  };

  void build(std::span<Leaf> leaves, int level) {
    const std::size_t number = nodes_.size();
    nodes_.push_back(empty_node());
    const std::vector<Group> groups = divided(leaves, level);
    for (std::size_t slot = 0; slot < groups.size(); ++slot) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        nodes_[number].planes[0][axis][slot] = groups[slot].box.low[axis];
        nodes_[number].planes[1][axis][slot] = groups[slot].box.high[axis];
      }
      place(groups[slot].leaves, number, slot, level + 1);
    }
  }

  const std::vector<Task>& tasks() const { return tasks_; }

 private:
  static Hierarchy::Node empty_node() {
    Hierarchy::Node node;
    for (auto& of_all_axes : node.planes)
      for (auto& places : of_all_axes) places.fill(std::numeric_limits<float>::quiet_NaN());
    node.child.fill(Hierarchy::Child::nothing());
    return node;
  }

  void place(std::span<Leaf> leaves, std::size_t node, std::size_t slot, int level) {
    if (leaves.size() == 1)
      nodes_[node].child[slot] = Hierarchy::Child::leaf(leaves[0].begin, leaves[0].count);
    else if (leaves.size() <= small_)
      tasks_.push_back({leaves, node, slot, level});
    else {
      nodes_[node].child[slot] = Hierarchy::Child::node(nodes_.size());
      build(leaves, level);
    }
  }

  /// Up to eight groups: again and again the one with the largest box is divided.
  static std::vector<Group> divided(std::span<Leaf> leaves, int level) {
    std::vector<Group> groups = {Group(leaves)};
    while (groups.size() < Hierarchy::width) {
      const auto largest = std::max_element(groups.begin(), groups.end(), [](const Group& a, const Group& b) {
        return std::pair(a.leaves.size() > 1, a.box.area()) < std::pair(b.leaves.size() > 1, b.box.area());
      });
      const std::span<Leaf> all = largest->leaves;
      if (all.size() == 1) break;
      // Far down the heuristic has found nothing but crumbs to cut off; halves end soon.
      const std::size_t left = level < Hierarchy::deepest / 2 ? Divider(all).divide() : all.size() / 2;
      *largest = Group(all.first(left));
      groups.emplace_back(all.subspan(left));
    }
    return groups;
  }

  std::vector<Hierarchy::Node>& nodes_;
  std::size_t small_;
  std::vector<Task> tasks_;
};

std::vector<Hierarchy::Node> build_nodes(std::span<Leaf> leaves, unsigned threads) {
  std::vector<Hierarchy::Node> nodes;
  NodeBuilder top(nodes, std::max<std::size_t>(leaves.size() / (2 * shares), 64));
  top.build(leaves, 0);
  std::vector<std::vector<Hierarchy::Node>> parts(top.tasks().size());
  in_parallel(parts.size(), threads,
              [&](std::size_t i) { NodeBuilder(parts[i], 0).build(top.tasks()[i].leaves, top.tasks()[i].level); });
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t start = nodes.size();
    nodes[top.tasks()[i].node].child[top.tasks()[i].slot] = Hierarchy::Child::node(start);
    for (Hierarchy::Node& node : parts[i])
      for (Hierarchy::Child& child : node.child)
        if (!child.is_leaf()) child = Hierarchy::Child::node(start + child.number());
    nodes.insert(nodes.end(), parts[i].begin(), parts[i].end());
  }
  return nodes;
}

}  // namespace

Hierarchy::Hierarchy(std::span<const Sphere> spheres, Numbers numbers, const Vec3& origin, unsigned threads)
    : order_(spheres.size()) {
  const Bounds bounds = bounds_of_centers(spheres, threads);
  const Double3 from = components(origin);
  for (std::size_t axis = 0; axis < 3; ++axis) middle_[axis] = 0.5 * bounds.low[axis] + 0.5 * bounds.high[axis] - from[axis];
  std::vector<Key> keys = curve_keys(spheres, bounds, threads);
  sort_keys(keys, threads);
  std::vector<Leaf> leaves = cut_leaves({spheres, numbers, from, middle_}, keys, threads);
  for (std::size_t k = 0; k < keys.size(); ++k) order_[k] = sphere_number(keys[k]);
  nodes_ = build_nodes(leaves, threads);
  for (const auto& side : nodes_[0].planes)
    for (const auto& plane : side)
      for (const float place : plane)
        if (std::abs(place) < infinity) extent_ = std::max(extent_, std::abs(place));
}

}  // namespace raylab::fast
