// Part of the kernel; kernel/parts.hpp says how the parts are put together.

namespace raylab::fast::RAYLAB_TARGET {

template <class V>
struct Ray {
  Vec3<V> origin;
  Vec3<V> direction;  ///< unit
  /// The place of the surface that the ray leaves, or -1, and whether it leaves a sphere inwards: this says whether the ray
  /// may meet its own surface again; no epsilon anywhere (D6).
  IndexOf<V> leaves;
  MaskOf<V> inwards;
};

/// The pixels that are traced together: a block, whose rays stay together longer than those of a row.
template <class V>
struct Tile {
  static constexpr int width = Lanes<V>::count >= 32 ? 8 : Lanes<V>::count >= 8 ? 4 : Lanes<V>::count >= 2 ? 2 : 1;
  static constexpr int height = Lanes<V>::count / width;
};

/// Of the primary rays through (x, y), in pixels from the image's center: unit vectors.
template <class V>
RAYLAB_INLINE Vec3<V> camera_direction(const PreparedCamera<NumberOf<V>>& camera, V x, V y) {
  const Vec3<V> towards = spread<V>(camera.forward) + x * spread<V>(camera.right) + y * spread<V>(camera.up);
  return (V(1) / square_root(dot(towards, towards))) * towards;
}

/// The nearest surface that a ray meets.
template <class V>
struct Nearest {
  V t;               ///< infinity: nothing
  IndexOf<V> place;  ///< of the surface; -1: nothing
};

/// A surface point that a ray has reached.
template <class V>
struct Hit {
  Vec3<V> point;
  Vec3<V> normal;  ///< unit, turned to the ray's side
  IndexOf<V> place;
  MaskOf<V> inside;  ///< met from the inside of a sphere
};

/// One lane's ray.
template <class T>
struct Alone {
  Point<T> origin, direction;
  WholeOf<T> leaves;
};

/// Takes rays out of their lanes.
template <class V>
class Singles {
 public:
  using T = NumberOf<V>;
  using Probes = raylab::fast::RAYLAB_TARGET::Probes<Lanes<V>::count>;

  explicit Singles(const Ray<V>& ray) {
    store(ray.origin.x, origin_[0].data());
    store(ray.origin.y, origin_[1].data());
    store(ray.origin.z, origin_[2].data());
    store(ray.direction.x, direction_[0].data());
    store(ray.direction.y, direction_[1].data());
    store(ray.direction.z, direction_[2].data());
    store(ray.leaves, leaves_.data());
  }

  Alone<T> ray(std::size_t lane) const {
    return {{origin_[0][lane], origin_[1][lane], origin_[2][lane]},
            {direction_[0][lane], direction_[1][lane], direction_[2][lane]},
            leaves_[lane]};
  }

  Probes probes(const Hierarchy& hierarchy) const { return {hierarchy, origin_, direction_, 0}; }

 private:
  typename Probes::template Vectors<T> origin_, direction_;
  std::array<WholeOf<V>, Lanes<V>::count> leaves_;
};

}  // namespace raylab::fast::RAYLAB_TARGET
