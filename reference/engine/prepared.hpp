#pragma once

#include "core/render/engine.hpp"
#include "reference/engine/vec3.hpp"

#include <cstdint>
#include <vector>

namespace raylab::fast {

/// One array a coordinate.
template <class T>
struct Vec3Array {
  std::vector<T> x, y, z;

  Vec3<T> operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
  std::size_t size() const { return x.size(); }
  void push_back(const Vec3<T>& v) {
    x.push_back(v.x);
    y.push_back(v.y);
    z.push_back(v.z);
  }
};

/// From `begin` up to but not including `end`.
struct Run {
  std::size_t begin;
  std::size_t end;
};

template <class T>
struct Planes {
  Vec3Array<T> point;
  Vec3Array<T> normal;  ///< unit, as given
};

/// `[[sphere]]`s and clouds in one list, so that a sphere's place is its GeometryId less the number of planes.
template <class T>
struct Spheres {
  Vec3Array<T> center;
  std::vector<T> radius;
  std::vector<Run> opaque;  ///< all but the glass ones: what can block light
};

/// What a surface does with light, and at the stage that is rendered.
template <class T>
struct Finish {
  T alpha;              ///< of the highlight
  T highlight;          ///< k_s, or 0 where there is no highlight: at alpha = 0 and at alpha = infinity (D10)
  T mirror;             ///< k_s, the weight of the reflected ray; 0 before stage 5
  bool glass;           ///< refracts; false before stage 6
  T n;                  ///< glass: the refractive index
  T n_squared_minus_1;  ///< glass: (n - 1)(n + 1), free of cancellation at n close to 1
  T r0;                 ///< glass: what it reflects at normal incidence
};

/// On which side of each plane a light is: the sign of (c - light).n, worked out once. A plane shades the points on its
/// other side, so a lamp in a ceiling shines on all below: comparing the rounded distances of lamp and ceiling would be a
/// toss-up.
using Sides = std::vector<std::int8_t>;

template <class T>
struct PreparedPointLight {
  Vec3<T> position;
  T intensity;
  Sides sides;
};

template <class T>
struct PreparedDirectionalLight {
  Vec3<T> l;  ///< unit, towards the light
  T intensity;
  Sides sides;
};

/// Where primary rays come from: the ray through (x, y), in pixels from the image's centre, runs along
/// forward + x right + y up.
template <class T>
struct PreparedCamera {
  Vec3<T> position, forward, right, up;  ///< `right` and `up` are one pixel long
};

/// A scene made ready for tracing in T at one stage. All that needs a transcendental function or a unit vector is computed
/// here, in double.
template <class T>
struct Prepared {
  Settings settings;
  std::vector<SampleOffset> samples;
  PreparedCamera<T> camera;
  Vec3<T> background;
  Planes<T> planes;
  Spheres<T> spheres;
  std::vector<Vec3<T>> colors;           ///< by GeometryId
  std::vector<std::uint32_t> finish_of;  ///< by GeometryId
  std::vector<Finish<T>> finishes;
  std::vector<PreparedPointLight<T>> point_lights;
  std::vector<PreparedDirectionalLight<T>> directional_lights;
  T ambient{};  ///< all ambient lights together
};

/// Throws std::invalid_argument if T is float and the scene is out of its range (see make_fast).
template <class T>
Prepared<T> prepare(const Scene& scene, const Settings& settings);

extern template Prepared<float> prepare(const Scene&, const Settings&);
extern template Prepared<double> prepare(const Scene&, const Settings&);

/// Throws std::invalid_argument, naming the first number that a render in float cannot take.
void check_float_range(const Scene& scene);

}  // namespace raylab::fast
