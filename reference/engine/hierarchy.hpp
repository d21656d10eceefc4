#pragma once

#include "core/math/shapes.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace raylab::fast {

/// A bounding volume hierarchy over spheres: each node has up to eight children, in arrays that a vector register loads
/// whole. Boxes are floats rounded outwards, whatever type the engine computes in: a box only has to hold its spheres.
class Hierarchy {
 public:
  static constexpr int width = 8;
  static constexpr std::size_t largest_leaf = 8;
  static constexpr int deepest = 48;  ///< more levels than any hierarchy has
  static constexpr std::size_t most_spheres = std::size_t{1} << 27;

  /// Where a child is: another node, or a run of places in the order of the leaves.
  class Child {
   public:
    static Child node(std::size_t number) { return Child(static_cast<std::uint32_t>(number)); }
    static Child leaf(std::size_t begin, std::size_t count) {
      return Child(leaf_flag | static_cast<std::uint32_t>(begin << count_bits | count));
    }

    static Child nothing() { return Child(leaf_flag); }  ///< a leaf without spheres

    Child() = default;  ///< not set: stacks of children are made often
    bool is_leaf() const { return (word_ & leaf_flag) != 0; }
    std::size_t number() const { return word_; }
    std::size_t begin() const { return (word_ & ~leaf_flag) >> count_bits; }
    std::size_t count() const { return word_ & ((1u << count_bits) - 1); }

   private:
    static constexpr std::uint32_t leaf_flag = 1u << 31;
    static constexpr int count_bits = 4;

    explicit Child(std::uint32_t word) : word_(word) {}

    std::uint32_t word_;
  };

  /// Six planes around each child: planes[0][axis] is where its box begins, planes[1][axis] where it ends. Those of a child
  /// that is not there are NaN: no ray meets them, whichever comes first.
  struct alignas(32) Node {
    std::array<std::array<std::array<float, width>, 3>, 2> planes;
    std::array<Child, width> child;
  };

  Hierarchy() = default;

  /// What the spheres' numbers are rounded to before anything asks for them: the boxes hold the rounded spheres.
  enum class Numbers { floats, doubles };

  /// Over 1 to `most_spheres` spheres, with coordinates and radii up to 1e15, as the engine has them: seen from `origin`.
  /// The same tree for any number of threads.
  Hierarchy(std::span<const Sphere> spheres, Numbers numbers, const Vec3& origin, unsigned threads);

  const std::vector<Node>& nodes() const { return nodes_; }  ///< the root comes first

  /// The spheres in the order of the leaves: place k of a leaf is spheres[take_order()[k]]. To be taken once.
  std::vector<std::uint32_t> take_order() { return std::move(order_); }

  /// Boxes are relative to this point, itself seen from the origin: far from zero a float has few bits left for the size of
  /// a scene.
  const std::array<double, 3>& middle() const { return middle_; }

  float extent() const { return extent_; }  ///< no box reaches further from the middle along any axis

 private:
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
  std::array<double, 3> middle_{};
  float extent_ = 0;
};

}  // namespace raylab::fast
