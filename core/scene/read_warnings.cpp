#include "core/scene/read_warnings.hpp"

#include "core/scene/twins.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace raylab {
namespace {

/// A sphere of either kind.
struct Ball {
  const Sphere* shape;
  const Material* material;
  const Color* color;
};

/// The balls that one table of the file stands for: one for a [[sphere]], a row of them for a [[sphere_cloud]].
struct Group {
  std::string key;
  Place place;
  std::size_t begin;
  std::size_t end;
  bool cloud;
};

/// How many balls share a surprise, and the first of them.
struct Tally {
  std::size_t count = 0;
  std::size_t first = 0;

  void add(std::size_t ball) {
    if (count++ == 0) first = ball;
  }
};

std::string indexed(const std::string& key, std::size_t index) { return key + "[" + std::to_string(index) + "]"; }

std::string and_more(std::size_t count) { return count > 1 ? " and " + std::to_string(count - 1) + " more" : ""; }

double largest(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// What merely touches in the file's decimals may overlap by this much in doubles.
double rounding(const Vec3& a, const Vec3& b, double radii) { return 1e-12 * (largest(a) + largest(b) + radii); }

bool cuts(const Sphere& sphere, const Plane& plane) {
  const double distance = std::abs(dot(unit(plane.normal), sphere.center - plane.point));
  return distance < sphere.radius - rounding(sphere.center, plane.point, sphere.radius);
}

bool holds(const Sphere& outer, const Sphere& inner) {
  const double slack = rounding(outer.center, inner.center, outer.radius + inner.radius);
  return distance(outer.center, inner.center) + inner.radius <= outer.radius + slack;
}

bool overlap(const Sphere& a, const Sphere& b) {
  const double radii = a.radius + b.radius;
  return distance(a.center, b.center) < radii - rounding(a.center, b.center, radii);
}

class Surprises {
 public:
  Surprises(const Scene& scene, const ScenePlaces& places, Report& report)
      : scene_(scene), places_(places), report_(report) {
    balls_.reserve(geometry_count(scene));
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
      const SphereObject& sphere = scene.spheres[i];
      groups_.push_back({indexed("sphere", i), places.spheres[i], balls_.size(), balls_.size() + 1, false});
      balls_.push_back({&sphere.shape, &sphere.material, &sphere.material.color});
    }
    for (std::size_t i = 0; i < scene.clouds.size(); ++i) add_cloud(i);
  }

  void find_camera_inside() const {
    Tally around;
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      if (distance(scene_.camera.position, balls_[i].shape->center) < balls_[i].shape->radius) around.add(i);
    }
    if (around.count == 0) return;
    report_.warning(places_.camera_position, "camera.position", "inside " + name(around.first) + and_more(around.count));
  }

  void find_glass_around_others() const {
    constexpr std::size_t most_pairs = 100'000'000;  // about 0.3 s: a warning is not worth a longer wait
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < scene_.spheres.size(); ++i) {
      if (!scene_.spheres[i].material.transparent) continue;
      pairs += balls_.size() + scene_.planes.size();
      if (pairs > most_pairs) {
        return warn(groups_[i], "this glass and what follows was not searched for geometry in it: there are too many");
      }
      find_inside_glass(i);
    }
  }

  void find_identical_planes() const {
    const auto numbers = [&](std::size_t i) {
      const auto& [shape, material] = scene_.planes[i];
      const auto& [point, normal] = shape;
      return std::array{point.x,  point.y,          point.z,          normal.x,         normal.y,
                        normal.z, material.color.r, material.color.g, material.color.b, material.shininess};
    };
    const std::vector<std::size_t> first = first_twins(scene_.planes.size(), numbers);
    for (std::size_t i = 0; i < first.size(); ++i) {
      if (first[i] != i) {
        report_.warning(places_.planes[i], indexed("plane", i), "identical to " + indexed("plane", first[i]));
      }
    }
  }

  void find_identical_balls() const {
    const auto numbers = [&](std::size_t i) {
      const auto& [center, radius] = *balls_[i].shape;
      const Material& material = *balls_[i].material;
      const Color& color = *balls_[i].color;
      const double index = material.transparent ? material.refractive_index : 0;
      return std::array{center.x, center.y, center.z, radius, color.r, color.g, color.b, material.shininess, index};
    };
    const std::vector<std::size_t> first = first_twins(balls_.size(), numbers);
    for (const Group& group : groups_) {
      Tally again;
      for (std::size_t i = group.begin; i < group.end; ++i) {
        if (first[i] != i) again.add(i);
      }
      if (again.count == 0) continue;
      const std::string line = group.cloud ? "line " + std::to_string(line_of(group, again.first)) + " is " : "";
      const std::string more = again.count > 1 ? ", and " + std::to_string(again.count - 1) + " more lines are twins" : "";
      warn(group, line + "identical to " + name(first[again.first]) + more);
    }
  }

 private:
  void add_cloud(std::size_t index) {
    const SphereCloud& cloud = scene_.clouds[index];
    const std::size_t begin = balls_.size();
    for (std::size_t i = 0; i < cloud.spheres.size(); ++i) {
      const Color& color = cloud.colors.empty() ? cloud.material.color : cloud.colors[i];
      balls_.push_back({&cloud.spheres[i], &cloud.material, &color});
    }
    groups_.push_back({indexed("sphere_cloud", index), places_.clouds[index], begin, balls_.size(), true});
  }

  void find_inside_glass(std::size_t glass) const {
    const Sphere& shape = *balls_[glass].shape;
    Tally inside;
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      if (i != glass && is_inside_glass(glass, i)) inside.add(i);
    }
    std::size_t planes = 0;
    std::size_t first_plane = 0;
    for (std::size_t i = scene_.planes.size(); i-- > 0;) {
      if (!cuts(shape, scene_.planes[i].shape)) continue;
      ++planes;
      first_plane = i;
    }
    if (planes + inside.count == 0) return;
    const std::string first = planes > 0 ? indexed("plane", first_plane) : name(inside.first);
    warn(groups_[glass], "transparent, but it holds or cuts " + first + and_more(planes + inside.count));
  }

  bool is_inside_glass(std::size_t glass, std::size_t other) const {
    const Sphere& a = *balls_[glass].shape;
    const Sphere& b = *balls_[other].shape;
    if (!overlap(a, b)) return false;
    if (holds(a, b)) return true;
    const bool said_before = other < glass && balls_[other].material->transparent;  // glass that cuts glass, seen from there
    return !holds(b, a) && !said_before;
  }

  const Group& group_of(std::size_t ball) const {
    return *(std::upper_bound(groups_.begin(), groups_.end(), ball,
                              [](std::size_t b, const Group& group) { return b < group.begin; }) -
             1);
  }

  static std::size_t line_of(const Group& cloud, std::size_t ball) { return ball - cloud.begin + 2; }  // after the header

  /// "sphere[3]" or "sphere_cloud[0] line 13".
  std::string name(std::size_t ball) const {
    const Group& group = group_of(ball);
    return group.cloud ? group.key + " line " + std::to_string(line_of(group, ball)) : group.key;
  }

  void warn(const Group& group, std::string text) const { report_.warning(group.place, group.key, std::move(text)); }

  const Scene& scene_;
  const ScenePlaces& places_;
  Report& report_;
  std::vector<Ball> balls_;  ///< every [[sphere]], then those of the clouds
  std::vector<Group> groups_;
};

}  // namespace

void warn_of_surprises(const Scene& scene, const ScenePlaces& places, Report& report) {
  const Surprises surprises(scene, places, report);
  surprises.find_camera_inside();
  surprises.find_glass_around_others();
  surprises.find_identical_planes();
  surprises.find_identical_balls();
}

}  // namespace raylab
