#pragma once

#include "core/render/engine.hpp"
#include "reference/engine/hierarchy.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace raylab::fast {

/// Three numbers at rest: the kernels compute with vectors of packs.
template <class T>
struct Point {
  T x{}, y{}, z{};
};

/// One array a coordinate.
template <class T>
struct PointArray {
  std::vector<T> x, y, z;

  Point<T> operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
  std::size_t size() const { return x.size(); }
  void push_back(const Point<T>& p) {
    x.push_back(p.x);
    y.push_back(p.y);
    z.push_back(p.z);
  }
};

template <class T>
struct PreparedPlane {
  Point<T> point;
  Point<T> normal;  ///< unit, as given
};

/// Spheres that are searched together. From `begin` up to `loop_end` each is asked; from there the hierarchy says which.
struct SphereGroup {
  std::size_t begin = 0;
  std::size_t loop_end = 0;
  std::optional<Hierarchy> hierarchy;  ///< over the spheres from `loop_end` on, in their order
};

/// All spheres: first the opaque ones, which alone block light, then those of glass. A group with a hierarchy ends with
/// `padding` places where there is no sphere: numbers that are none, which no ray meets. So does the array as a whole: a
/// pack may be loaded at every place, and what stands behind a leaf are spheres of its group, or none.
template <class T>
struct Spheres {
  static constexpr std::size_t padding = 16;

  PointArray<T> center;
  std::vector<T> radius;
  std::vector<T> reach;  ///< the square of the radius, and more than rounding may take from the square of a distance
  std::vector<GeometryId> id;
  SphereGroup opaque, glass;
  std::size_t count = 0;  ///< without the padding
};

/// A table of T for kernels that read from a different row in each lane. Its columns are named by an enumeration.
template <class T, int columns>
struct Table {
  std::vector<T> numbers;

  std::size_t rows() const { return numbers.size() / columns; }
};

/// A surface's own color, and the row of its finish.
enum SurfaceColumn { red, green, blue, finish, surface_columns };

/// What a surface does with light, at the stage that is rendered.
enum FinishColumn {
  alpha,                ///< of the highlight
  strength,             ///< of the highlight: k_s, or 0 where there is none: at alpha = 0 and at alpha = infinity (D10)
  mirror,               ///< k_s, the weight of the reflected ray; 0 before stage 5
  is_glass,             ///< 1: refracts; 0 before stage 6
  ior,                  ///< glass: the refractive index n
  ior_squared_minus_1,  ///< glass: (n - 1)(n + 1), free of cancellation at n close to 1
  r0,                   ///< glass: what it reflects at normal incidence
  finish_columns = 8
};

/// What a plane means to a light: on which side of it that is was worked out once, from the numbers as given. A plane shades
/// the points on its other side, so a lamp in a ceiling shines on all below: comparing the rounded distances of lamp and
/// ceiling would be a toss-up.
struct LightPlane {
  int plane;
  int side;  ///< that the light is on: the sign of (light - c).n; 0: the light is in the plane, and does not light it
};

template <class T>
struct PreparedPointLight {
  Point<T> position;
  T intensity;
  std::vector<LightPlane> planes;  ///< that may keep the light from a point that is seen
};

template <class T>
struct PreparedDirectionalLight {
  Point<T> l;  ///< unit, towards the light
  T intensity;
  std::vector<LightPlane> planes;  ///< that may keep the light from a point that is seen
};

/// Where primary rays come from: the ray through (x, y), in pixels from the image's center, runs along
/// forward + x right + y up.
template <class T>
struct PreparedCamera {
  Point<T> position, forward, right, up;  ///< `right` and `up` are one pixel long
};

/// Which of the kernels' parts the scene needs at the stage that is rendered. What it lacks is never asked for.
struct Features {
  bool highlights = false;
  bool mirrors = false;
  bool glass = false;
  bool shadows = false;
};

/// More bounces no render is asked for.
inline constexpr std::size_t most_bounces = 100;

/// A scene made ready for tracing in T at one stage. All that needs a transcendental function or a unit vector is computed
/// here, in double. A surface's *place* is that of its sphere in `spheres`, which stand in an order that is good for
/// searching (only `id` knows the scene's own), or its plane's, with all of `spheres` before it.
template <class T>
struct Prepared {
  Settings settings;
  std::vector<SampleOffset> samples;
  bool adaptive = false;  ///< only the deciding ones of the samples where these agree
  PreparedCamera<T> camera;
  Point<T> background;
  std::vector<PreparedPlane<T>> planes;
  Spheres<T> spheres;
  Table<T, surface_columns> surfaces;  ///< by place
  Table<T, finish_columns> finishes;
  std::vector<PreparedPointLight<T>> point_lights;
  std::vector<PreparedDirectionalLight<T>> directional_lights;
  T ambient{};  ///< all ambient lights together
  Features features;
  EngineFacts facts;

  /// Its place.
  std::size_t first_plane() const { return spheres.radius.size(); }
};

/// A camera as it is seen from `origin`.
template <class T>
PreparedCamera<T> prepare_camera(const Camera& camera, const Vec3& origin, const ImageSize& size);

/// The row of a material in the table of finishes.
template <class T>
std::array<T, finish_columns> finish_of(const Material& material, int stage);

/// `hierarchy` false: none, however many spheres there are. `threads` build it. Throws std::invalid_argument if T is float
/// and the scene is out of its range (see make_fast).
template <class T>
Prepared<T> prepare(const Scene& scene, const Settings& settings, bool hierarchy, unsigned threads);

extern template Prepared<float> prepare(const Scene&, const Settings&, bool, unsigned);
extern template Prepared<double> prepare(const Scene&, const Settings&, bool, unsigned);

/// Throws std::invalid_argument, naming the first number that a render in float cannot take.
void check_float_range(const Scene& scene);

}  // namespace raylab::fast
