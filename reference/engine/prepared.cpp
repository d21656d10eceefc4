#include "reference/engine/prepared.hpp"

#include "reference/engine/parallel.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace raylab::fast {
namespace {

/// From so many spheres on a hierarchy is faster than asking each.
constexpr std::size_t least_for_hierarchy = 24;
/// Numbers beyond this stay out of a hierarchy: its boxes are floats.
constexpr double largest_in_hierarchy = 1e15;

template <class T>
Point<T> to(const Vec3& v) {
  return {static_cast<T>(v.x), static_cast<T>(v.y), static_cast<T>(v.z)};
}

double largest_component(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// Where positions are seen from. A camera far from zero sees, next to it, what a float has no bits for: then from the
/// camera. Else from zero: that takes nothing from numbers that are round as given, such as center and radius of a giant
/// floor.
template <class T>
Vec3 origin_of(const Camera& camera) {
  constexpr double far = 1024;
  return std::is_same_v<T, float> && largest_component(camera.position) > far ? camera.position : Vec3(0);
}

/// a b - c d to two roundings of the result, however close the products are (Kahan).
double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

Vec3 exact_cross(const Vec3& a, const Vec3& b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

/// tan(theta), by way of the smaller angle of the triangle: in radians a large one has lost what it is short of 90 degrees.
double tangent(double theta) {
  constexpr double degree = std::numbers::pi / 180;
  return theta > 45 ? 1 / std::tan((90 - theta) * degree) : std::tan(theta * degree);
}

/// The sign of a.b; 0 where rounding `a`, `b` and the sum may have made an exact zero into this.
std::int8_t sign_of_dot(const Vec3& a, const Vec3& b) {
  const double size = std::abs(a.x * b.x) + std::abs(a.y * b.y) + std::abs(a.z * b.z);
  const double margin = 4 * std::numeric_limits<double>::epsilon() * size;
  const double value = dot(a, b);
  return static_cast<std::int8_t>(value > margin ? 1 : value < -margin ? -1 : 0);
}

/// On which side of the plane a point is, and a light from far away: 1 where the normal points to, -1, or 0 in the plane.
int side_of(const Vec3& point, const Plane& plane) { return sign_of_dot(point - plane.point, unit(plane.normal)); }
int side_of(const PointLight& light, const Plane& plane) { return side_of(light.position, plane); }
int side_of(const DirectionalLight& light, const Plane& plane) {
  return sign_of_dot(-unit(light.direction), unit(plane.normal));
}

bool reaches_through(const Sphere& sphere, const Vec3& point_of_plane, const Vec3& n) {
  const Vec3 center = sphere.center - point_of_plane;
  const int side = sign_of_dot(center, n);
  return side == 0 || sign_of_dot(center - (side * sphere.radius) * n, n) == -side;
}

/// The side of a plane that all is on that can be seen: the camera's, since planes are opaque and have no end. 0: both,
/// where glass reaches through (what is inside is passed by, D15), or where the camera is in the plane.
int seen_side(const Plane& plane, const Scene& scene, bool glass) {
  if (glass) {
    const auto through = [&, n = unit(plane.normal)](const Sphere& sphere) {
      return reaches_through(sphere, plane.point, n);
    };
    for (const SphereObject& sphere : scene.spheres)
      if (sphere.material.transparent && through(sphere.shape)) return 0;
    for (const SphereCloud& cloud : scene.clouds)
      if (cloud.material.transparent && std::any_of(cloud.spheres.begin(), cloud.spheres.end(), through)) return 0;
  }
  return side_of(scene.camera.position, plane);
}

/// A light on the side that is seen is hidden from nothing there.
template <class Light>
std::vector<LightPlane> planes_of(const Light& light, const Scene& scene, std::span<const int> seen_sides) {
  std::vector<LightPlane> planes;
  for (std::size_t i = 0; i < scene.planes.size(); ++i) {
    const int side = side_of(light, scene.planes[i].shape);
    if (side == 0 || side != seen_sides[i]) planes.push_back({static_cast<int>(i), side});
  }
  return planes;
}

/// A run of the scene's spheres that share a material: one [[sphere]], or a cloud.
struct Batch {
  std::span<const Sphere> spheres;
  std::span<const Color> colors;  ///< one, or one for each
  GeometryId first_id;
  std::size_t finish;

  const Color& color(std::size_t i) const { return colors[colors.size() == 1 ? 0 : i]; }
};

/// The spheres of several batches as one list.
class SphereList {
 public:
  struct Place {
    const Batch& batch;
    std::size_t i;
  };

  explicit SphereList(std::vector<Batch> batches) : batches_(std::move(batches)) {
    for (const Batch& batch : batches_) {
      starts_.push_back(size_);
      size_ += batch.spheres.size();
    }
    if (batches_.size() == 1) return;
    joined_.reserve(size_);
    for (const Batch& batch : batches_) joined_.insert(joined_.end(), batch.spheres.begin(), batch.spheres.end());
  }

  std::size_t size() const { return size_; }
  std::span<const Sphere> spheres() const { return batches_.size() == 1 ? batches_[0].spheres : joined_; }

  Place operator[](std::size_t k) const {
    const auto next = batches_.size() == 1 ? starts_.end() : std::upper_bound(starts_.begin(), starts_.end(), k);
    const auto at = static_cast<std::size_t>(next - starts_.begin()) - 1;
    return {batches_[at], k - starts_[at]};
  }

 private:
  std::vector<Batch> batches_;
  std::vector<std::size_t> starts_;
  std::size_t size_ = 0;
  std::vector<Sphere> joined_;  // where one batch is not all
};

/// The spheres that a hierarchy should not have: those that floats cannot hold, and, up to eight of them, the largest whose
/// radius is beyond half of what all centers span: a box around such a ground would be a box around everything.
std::vector<std::uint32_t> giants_of(std::span<const Sphere> spheres) {
  constexpr std::size_t most = 8;
  Vec3 low(largest_in_hierarchy), high(-largest_in_hierarchy);
  for (const Sphere& sphere : spheres) {
    low = min(low, sphere.center);
    high = max(high, sphere.center);
  }
  const double half_span = 0.5 * largest_component(high - low);
  std::vector<std::uint32_t> unfit, large;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const double radius = spheres[i].radius;
    if (!(std::max(largest_component(spheres[i].center), radius) <= largest_in_hierarchy))
      unfit.push_back(static_cast<std::uint32_t>(i));
    else if (radius > half_span)
      large.push_back(static_cast<std::uint32_t>(i));
  }
  std::stable_sort(large.begin(), large.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return spheres[a].radius > spheres[b].radius; });
  unfit.insert(unfit.end(), large.begin(), large.begin() + static_cast<std::ptrdiff_t>(std::min(most, large.size())));
  std::sort(unfit.begin(), unfit.end());
  return unfit;
}

/// The order in which to keep the spheres of a group: first those that are looped over, then those of the hierarchy.
struct GroupOrder {
  std::vector<std::uint32_t> order;
  std::size_t looped = 0;
  std::optional<Hierarchy> hierarchy;
};

GroupOrder order_of(std::span<const Sphere> spheres, Hierarchy::Numbers numbers, const Vec3& origin, bool hierarchy,
                    unsigned threads) {
  GroupOrder result;
  if (hierarchy && spheres.size() >= least_for_hierarchy && spheres.size() <= Hierarchy::most_spheres)
    result.order = giants_of(spheres);
  const std::vector<std::uint32_t> giants = result.order;
  result.looped = giants.size();
  if (!hierarchy || spheres.size() - giants.size() < least_for_hierarchy || spheres.size() > Hierarchy::most_spheres) {
    result.order.resize(spheres.size());
    std::iota(result.order.begin(), result.order.end(), 0u);
    result.looped = spheres.size();
    return result;
  }
  if (giants.empty()) {
    result.hierarchy.emplace(spheres, numbers, origin, threads);
    result.order = result.hierarchy->take_order();
    return result;
  }
  std::vector<std::uint32_t> rest(spheres.size());
  std::iota(rest.begin(), rest.end(), 0u);
  for (auto giant = giants.rbegin(); giant != giants.rend(); ++giant) rest.erase(rest.begin() + *giant);
  std::vector<Sphere> without;
  for (const std::uint32_t i : rest) without.push_back(spheres[i]);
  result.hierarchy.emplace(without, numbers, origin, threads);
  for (const std::uint32_t k : result.hierarchy->take_order()) result.order.push_back(rest[k]);
  return result;
}

template <class T>
class Builder {
 public:
  /// Positions are seen from `origin`.
  Builder(Prepared<T>& out, const Scene& scene, const Vec3& origin, unsigned threads)
      : out_(out), scene_(scene), origin_(origin), threads_(threads) {}

  /// After the spheres: their places come first.
  void add_planes() {
    out_.surfaces.numbers.resize((out_.first_plane() + scene_.planes.size()) * surface_columns);
    for (const PlaneObject& plane : scene_.planes) {
      out_.planes.push_back({to<T>(plane.shape.point - origin_), to<T>(unit(plane.shape.normal))});
      add_finish(plane.material);
      set_surface(out_.first_plane() + out_.planes.size() - 1, plane.material.color, finish_count() - 1);
    }
  }

  void add_spheres(bool hierarchy) {
    std::vector<Batch> opaque, glass;
    GeometryId id = static_cast<GeometryId>(scene_.planes.size());
    const auto add = [&](std::span<const Sphere> spheres, std::span<const Color> colors, const Material& material) {
      add_finish(material);
      (material.transparent ? glass : opaque).push_back({spheres, colors, id, finish_count() - 1});
      id += static_cast<GeometryId>(spheres.size());
    };
    for (const SphereObject& sphere : scene_.spheres) add({&sphere.shape, 1}, {&sphere.material.color, 1}, sphere.material);
    for (const SphereCloud& cloud : scene_.clouds)
      add(cloud.spheres, cloud.colors.empty() ? std::span(&cloud.material.color, 1) : std::span(cloud.colors),
          cloud.material);
    add_group(SphereList(std::move(opaque)), hierarchy, out_.spheres.opaque);
    add_group(SphereList(std::move(glass)), hierarchy, out_.spheres.glass);
    resize(out_.spheres.radius.size() + Spheres<T>::padding);
  }

  void add_lights() {
    double ambient = 0;
    for (const AmbientLight& light : scene_.ambient_lights) ambient += light.intensity;
    out_.ambient = static_cast<T>(ambient);
    std::vector<int> seen_sides;
    for (const PlaneObject& plane : scene_.planes) seen_sides.push_back(seen_side(plane.shape, scene_, out_.features.glass));
    for (const PointLight& light : scene_.point_lights)
      out_.point_lights.push_back(
          {to<T>(light.position - origin_), static_cast<T>(light.intensity), planes_of(light, scene_, seen_sides)});
    for (const DirectionalLight& light : scene_.directional_lights)
      out_.directional_lights.push_back(
          {to<T>(-unit(light.direction)), static_cast<T>(light.intensity), planes_of(light, scene_, seen_sides)});
  }

  void note_features() {
    Features& features = out_.features;
    features.shadows = out_.settings.stage >= 4;
    for (std::size_t row = 0; row < finish_count(); ++row) {
      const T* const finish = &out_.finishes.numbers[row * finish_columns];
      features.highlights = features.highlights || finish[strength] > 0;
      features.mirrors = features.mirrors || finish[mirror] > 0;
      features.glass = features.glass || finish[is_glass] > 0;
    }
  }

 private:
  std::size_t finish_count() const { return out_.finishes.rows(); }

  void add_finish(const Material& material) {
    for (const T number : finish_of<T>(material, out_.settings.stage)) out_.finishes.numbers.push_back(number);
  }

  void set_surface(std::size_t place, const Color& color, std::size_t finish_row) {
    T* const row = &out_.surfaces.numbers[place * surface_columns];
    row[red] = static_cast<T>(color.r);
    row[green] = static_cast<T>(color.g);
    row[blue] = static_cast<T>(color.b);
    row[finish] = static_cast<T>(finish_row);
  }

  void add_group(const SphereList& list, bool hierarchy, SphereGroup& group) {
    const auto start = std::chrono::steady_clock::now();
    constexpr auto numbers = std::is_same_v<T, float> ? Hierarchy::Numbers::floats : Hierarchy::Numbers::doubles;
    GroupOrder order = order_of(list.spheres(), numbers, origin_, hierarchy, threads_);
    if (order.hierarchy) {
      EngineFacts& facts = out_.facts;
      facts.hierarchy_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      facts.hierarchy_spheres += list.size() - order.looped;
      facts.hierarchy_bytes += order.hierarchy->nodes().size() * sizeof(Hierarchy::Node) + list.size() * sizeof(GeometryId);
    }
    Spheres<T>& spheres = out_.spheres;
    group.begin = spheres.radius.size();
    group.loop_end = group.begin + order.looped;
    spheres.count += list.size();
    resize(group.begin + list.size() + (order.hierarchy ? Spheres<T>::padding : 0));
    group.hierarchy = std::move(order.hierarchy);
    constexpr std::size_t shares = 16;
    in_parallel(shares, threads_, [&](std::size_t i) {
      const Share share(list.size(), i, shares);
      for (std::size_t k = share.begin; k < share.end; ++k) set_sphere(group.begin + k, list, order.order[k]);
    });
  }

  /// New places hold no sphere.
  void resize(std::size_t count) {
    constexpr T none = std::numeric_limits<T>::quiet_NaN();
    Spheres<T>& spheres = out_.spheres;
    for (std::vector<T>* numbers :
         {&spheres.center.x, &spheres.center.y, &spheres.center.z, &spheres.radius, &spheres.reach})
      numbers->resize(count, none);
    spheres.id.resize(count, no_geometry);
    out_.surfaces.numbers.resize(count * surface_columns);
  }

  void set_sphere(std::size_t place, const SphereList& list, std::size_t i) {
    // |perp|^2 has the rounding errors of |o - c|^2 where the ray starts near, and from afar the edge is anybody's guess.
    constexpr T wider = 1 + 32 * std::numeric_limits<T>::epsilon();
    const auto [batch, at] = list[i];
    const Sphere& sphere = batch.spheres[at];
    Spheres<T>& spheres = out_.spheres;
    spheres.center.x[place] = static_cast<T>(sphere.center.x - origin_.x);
    spheres.center.y[place] = static_cast<T>(sphere.center.y - origin_.y);
    spheres.center.z[place] = static_cast<T>(sphere.center.z - origin_.z);
    spheres.radius[place] = static_cast<T>(sphere.radius);
    spheres.reach[place] = wider * (spheres.radius[place] * spheres.radius[place]);
    spheres.id[place] = batch.first_id + static_cast<GeometryId>(at);
    set_surface(place, batch.color(at), batch.finish);
  }

  Prepared<T>& out_;
  const Scene& scene_;
  const Vec3 origin_;
  unsigned threads_;
};

}  // namespace

template <class T>
PreparedCamera<T> prepare_camera(const Camera& camera, const Vec3& origin, const ImageSize& size) {
  const Vec3 forward = unit(camera.facing);
  // From the vectors as given, not from their rounded unit vectors: where `up` is almost along `facing`, that rounding would
  // turn the picture.
  const Vec3 right = unit(exact_cross(scaled(camera.facing), scaled(camera.up)));
  const Vec3 up = exact_cross(right, forward);
  const double pixel = 2 * tangent(camera.half_field_of_view) / std::max(size.width, size.height);
  return {to<T>(camera.position - origin), to<T>(forward), to<T>(pixel * right), to<T>(pixel * up)};
}

template <class T>
std::array<T, finish_columns> finish_of(const Material& material, int stage) {
  const double k_s = std::tanh(material.shininess / 400);  // the handout's quotient, free of cancellation at small alpha
  const double n = material.refractive_index;
  const double r = (1 - n) / (1 + n);
  const bool perfect = std::isinf(material.shininess);
  const bool glass = stage >= 6 && material.transparent;
  std::array<T, finish_columns> row{};
  row[alpha] = static_cast<T>(perfect ? 0 : material.shininess);
  row[strength] = static_cast<T>(perfect ? 0 : k_s);
  row[mirror] = static_cast<T>(stage >= 5 && !glass ? k_s : 0);
  row[is_glass] = glass ? 1 : 0;
  row[ior] = static_cast<T>(n);
  row[ior_squared_minus_1] = static_cast<T>((n - 1) * (n + 1));
  row[r0] = static_cast<T>(r * r);
  return row;
}

template <class T>
Prepared<T> prepare(const Scene& scene, const Settings& settings, bool hierarchy, unsigned threads) {
  if (settings.max_bounces > static_cast<int>(most_bounces))
    throw std::invalid_argument("max_bounces: " + std::to_string(settings.max_bounces) + " is more than 100");
  if constexpr (std::is_same_v<T, float>) check_float_range(scene);
  const AntiAliasing by_stage = settings.stage >= 7 ? AntiAliasing::rotated4 : AntiAliasing::none;
  Prepared<T> out;
  out.settings = settings;
  out.samples = sample_offsets(settings.aa.value_or(by_stage));
  out.adaptive = settings.aa == AntiAliasing::adaptive;
  const Vec3 origin = origin_of<T>(scene.camera);
  out.camera = prepare_camera<T>(scene.camera, origin, settings.size);
  out.background = to<T>(scene.background);
  Builder<T> builder(out, scene, origin, threads);
  builder.add_spheres(hierarchy);
  builder.add_planes();
  builder.note_features();
  builder.add_lights();
  return out;
}

template PreparedCamera<float> prepare_camera(const Camera&, const Vec3&, const ImageSize&);
template PreparedCamera<double> prepare_camera(const Camera&, const Vec3&, const ImageSize&);
template std::array<float, finish_columns> finish_of(const Material&, int);
template std::array<double, finish_columns> finish_of(const Material&, int);
template Prepared<float> prepare(const Scene&, const Settings&, bool, unsigned);
template Prepared<double> prepare(const Scene&, const Settings&, bool, unsigned);

}  // namespace raylab::fast
