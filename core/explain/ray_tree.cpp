#include "core/explain/ray_tree.hpp"

#include "core/calls/call_function.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace raylab {
namespace {

/// Reads the events in the order in which the driver makes them: core/render/driver.hpp.
class Reader {
 public:
  Reader(const Scene& scene, const std::vector<Event>& events) : scene_(scene), events_(events) {}

  std::vector<RayNode> trees() {
    std::vector<RayNode> trees;
    while (skip_to("camera_ray")) {
      RayNode node;
      node.ray = result<Ray>(take());
      follow(node);
      trees.push_back(node);
    }
    return trees;
  }

 private:
  const RecordedCall* next() const { return at_ < events_.size() ? std::get_if<RecordedCall>(&events_[at_]) : nullptr; }
  bool next_is(std::string_view name) const { return next() && next()->task->name == name; }
  const RecordedCall& take() { return std::get<RecordedCall>(events_[at_++]); }

  bool skip_to(std::string_view name) {
    while (at_ < events_.size() && !next_is(name)) ++at_;
    return at_ < events_.size();
  }

  template <class T>
  static T result(const RecordedCall& call) {
    T value{};
    PlainJson<T>::read(parse_json(call.result), value, JsonPlace{});
    return value;
  }

  template <class T>
  static T argument(const RecordedCall& call, const char* name) {
    T value{};
    const JsonValue arguments = parse_json(call.arguments);
    read_argument(std::get<JsonObject>(arguments.data), name, value);
    return value;
  }

  void skip_hits() {
    while (next_is("plane_hit") || next_is("sphere_hit")) ++at_;
  }

  /// From the ray's first question to the event that it has been followed.
  void follow(RayNode& node) {
    skip_hits();
    if (next_is("nearest_hit")) nearest(node);
    while (next()) {
      if (next_is("sphere_normal"))
        normal(node);
      else if (is_light())
        light(node);
      else if (next_is("mirror_bounce"))
        mirror(node);
      else if (next_is("glass_bounces"))
        glass(node);
      else
        ++at_;
    }
    if (at_ == events_.size()) throw std::logic_error("the recording of a pixel ends within a ray");
    node.color = std::get<Seen>(events_[at_++]).color;
  }

  void nearest(RayNode& node) {
    const RecordedCall& call = take();
    const auto index = result<std::optional<std::size_t>>(call);
    if (!index) return;
    const Candidate met = argument<std::vector<Candidate>>(call, "candidates").at(*index);
    node.t = met.t;
    node.geometry = met.geometry;
    if (static_cast<std::size_t>(met.geometry) < scene_.planes.size())
      turn(node, unit(scene_.planes[static_cast<std::size_t>(met.geometry)].shape.normal));
  }

  void normal(RayNode& node) { turn(node, result<Vec3>(take())); }

  /// Normals face the ray, as the driver turns them.
  static void turn(RayNode& node, const Vec3& normal) {
    node.normal = dot(node.ray.direction, normal) > 0 ? -normal : normal;
  }

  bool is_light() const {
    return next_is("ambient_light") || next_is("plane_hit") || next_is("sphere_hit") || next_is("blocked") ||
           next_is("point_light") || next_is("directional_light");
  }

  /// One light: a shadow ray, if there was need for one, and the light's part, unless it was blocked.
  void light(RayNode& node) {
    LightTerm term = first_light(node.lights.size());
    skip_hits();
    if (next_is("blocked")) {
      const RecordedCall& call = take();
      term.crossings = argument<std::vector<Crossing>>(call, "crossings");
      term.distance = argument<double>(call, "distance");
      term.blocked = result<bool>(call);
    }
    if (!term.blocked) term.color = result<Color>(take());
    node.lights.push_back(term);
  }

  /// The kind and number of the light that the driver asks about after `before` others.
  LightTerm first_light(std::size_t before) const {
    using Kind = LightTerm::Kind;
    const std::size_t ambient = scene_.ambient_lights.size(), point = scene_.point_lights.size();
    if (before < ambient) return {Kind::ambient, before, false, Color(0), {}, {}};
    if (before < ambient + point) return {Kind::point, before - ambient, false, Color(0), {}, {}};
    return {Kind::directional, before - ambient - point, false, Color(0), {}, {}};
  }

  void mirror(RayNode& node) { child(node, RayNode::Kind::reflected, result<Bounce>(take())); }

  void glass(RayNode& node) {
    const auto both = result<GlassBounces>(take());
    child(node, RayNode::Kind::reflected, both.reflected);
    child(node, RayNode::Kind::refracted, both.refracted);
  }

  void child(RayNode& node, RayNode::Kind kind, const Bounce& bounce) {
    RayNode next;
    next.kind = kind;
    next.bounce = node.bounce + 1;
    next.weight = bounce.weight;
    next.ray = bounce.ray;
    // Tasks that other tasks ask within themselves are not recorded; go_on is the driver's.
    if (!next_is("go_on")) return;
    if (!result<bool>(take())) {
      node.ended.push_back(next);
      return;
    }
    follow(next);
    node.children.push_back(next);
  }

  const Scene& scene_;
  const std::vector<Event>& events_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<RayNode> ray_trees(const Scene& scene, const Recording& recording) {
  return Reader(scene, recording.events).trees();
}

}  // namespace raylab
