#include "core/calls/plain_json.hpp"
#include "core/explain/explanation.hpp"
#include "core/report/page_parts.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace raylab {
namespace {

constexpr double panel_width = 560, panel_height = 420, margin = 24, head = 64, foot = 64;

/// A line of sight onto the scene: what of a point goes to the right and what up, in scene units.
struct View {
  const char* title;
  Vec3 right, up;

  double x(const Vec3& p) const { return dot(p, right); }
  double y(const Vec3& p) const { return dot(p, up); }
};

/// One stroke: a ray's way, or a shadow ray's.
struct Stroke {
  Vec3 from, to;
  std::string style;
  std::string label;  ///< what stands beside it
  bool ends_nowhere = false;
  bool blocked = false;
};

/// What a point of the picture is called.
struct Name {
  Vec3 at;
  std::string text;
};

/// All that is drawn of a pixel.
struct Sketch {
  std::vector<Stroke> strokes;
  std::vector<Name> names;  ///< of what the rays meet, and of the lights that they go to
};

struct Box {
  double left = std::numeric_limits<double>::infinity(), right = -left, bottom = left, top = -left;

  void add(double x, double y) {
    left = std::min(left, x), right = std::max(right, x), bottom = std::min(bottom, y), top = std::max(top, y);
  }
};

/// How far the rays go that meet something: those that meet nothing are drawn a part of that.
double reach(const RayNode& node) {
  double longest = node.t.value_or(0);
  for (const RayNode& child : node.children) longest = std::max(longest, reach(child));
  return longest;
}

void add_shadow_rays(const Scene& scene, const RayNode& node, const Vec3& point, double far, Sketch& sketch) {
  for (const LightTerm& term : node.lights) {
    if (!term.distance) continue;
    const bool has_place = term.kind == LightTerm::Kind::point;
    const Vec3 to_light = has_place ? scene.point_lights[term.number].position - point
                                    : -far * unit(scene.directional_lights[term.number].direction);
    double length_drawn = std::min(*term.distance, length(to_light));
    for (const Crossing& crossing : term.crossings)
      if (term.blocked && !crossing.transparent) length_drawn = std::min(length_drawn, crossing.t);
    sketch.strokes.push_back({point, point + length_drawn * unit(to_light), "shadow", "to " + light_name(term),
                              !std::isfinite(*term.distance), term.blocked});
    if (has_place) sketch.names.push_back({point + to_light, light_name(term)});
  }
}

void add_rays(const Scene& scene, const RayNode& node, double far, Sketch& sketch) {
  const Vec3 end = node.ray.origin + node.t.value_or(far) * node.ray.direction;
  const std::string kind = kind_name(node.kind);
  sketch.strokes.push_back({node.ray.origin, end, kind, kind + " ray", !node.t.has_value()});
  if (node.t) {
    sketch.names.push_back({end, geometry_name(scene, node.geometry)});
    add_shadow_rays(scene, node, end, far, sketch);
  }
  for (const RayNode& child : node.children) {
    if (child.ray.origin != end) sketch.strokes.push_back({end, child.ray.origin, "inside", "", true});  // through glass
    add_rays(scene, child, far, sketch);
  }
}

/// The rays of an answer, whatever its form: those that bring nothing are left out.
std::vector<Ray> rays_in(const JsonValue& value) {
  const auto* const object = std::get_if<JsonObject>(&value.data);
  if (!object) return {};
  const auto member = [&](std::string_view key) -> const JsonValue* {
    const auto found = std::find_if(object->begin(), object->end(), [&](const JsonMember& m) { return m.key == key; });
    return found == object->end() ? nullptr : &found->value;
  };
  if (const JsonValue* const weight = member("weight"); weight && std::get_if<double>(&weight->data))
    if (std::get<double>(weight->data) == 0) return {};
  std::vector<Ray> rays;
  if (member("origin") && member("direction")) PlainJson<Ray>::read(value, rays.emplace_back(), JsonPlace{});
  for (const JsonMember& m : *object)
    for (const Ray& ray : rays_in(m.value)) rays.push_back(ray);
  return rays;
}

/// Where the submission's answer to the first call that it answers differently is a ray, or several, those.
void add_other_rays(const OtherView& other, double far, Sketch& sketch) {
  if (!other.difference || !other.difference->error.empty()) return;
  for (const Ray& ray : rays_in(parse_json(other.difference->got)))
    if (is_finite(ray.origin) && is_finite(ray.direction))
      sketch.strokes.push_back({ray.origin, ray.origin + far * ray.direction, "other",
                                "by " + std::string(other.difference->call.task->label) + " of " + other.with, true});
}

class Panel {
 public:
  Panel(const View& view, const std::vector<Stroke>& strokes, double left) : view_(view), left_(left) {
    Box box;
    for (const Stroke& stroke : strokes)
      for (const Vec3& p : {stroke.from, stroke.to}) box.add(view.x(p), view.y(p));
    const double span = std::max({box.right - box.left, box.top - box.bottom, 1e-9});
    const double room = 0.12 * span;
    scale_ = std::min(panel_width / (box.right - box.left + 2 * room), panel_height / (box.top - box.bottom + 2 * room));
    middle_x_ = (box.left + box.right) / 2, middle_y_ = (box.bottom + box.top) / 2;
  }

  double x(const Vec3& p) const { return left_ + panel_width / 2 + scale_ * (view_.x(p) - middle_x_); }
  double y(const Vec3& p) const { return head + panel_height / 2 - scale_ * (view_.y(p) - middle_y_); }
  double scale() const { return scale_; }
  double left() const { return left_; }
  const View& view() const { return view_; }

  bool shows(const Sphere& sphere) const {
    const double radius = scale_ * sphere.radius;
    return x(sphere.center) + radius > left_ && x(sphere.center) - radius < left_ + panel_width &&
           y(sphere.center) + radius > head && y(sphere.center) - radius < head + panel_height;
  }

 private:
  View view_;
  double left_, scale_, middle_x_, middle_y_;
};

std::string color_text(const Color& color) {
  const auto part = [](double c) { return std::to_string(static_cast<int>(255 * std::clamp(c, 0.0, 1.0))); };
  return "rgb(" + part(color.r) + "," + part(color.g) + "," + part(color.b) + ")";
}

/// The words of a panel: each beside its point where there is room, and left out where there is none.
class Labels {
 public:
  explicit Labels(double left) : left_(left) {}

  /// The element, or nothing.
  std::string at(double x, double y, const std::string& text, const std::string& style) {
    const double width = 6.6 * static_cast<double>(text.size()), height = 14;
    for (const auto& [dx, dy] : {std::pair{8.0, -6.0}, {8.0, 16.0}, {-8 - width, -6.0}, {-8 - width, 16.0}}) {
      Box box;
      box.add(x + dx, y + dy - height), box.add(x + dx + width, y + dy + 3);
      if (!is_free(box)) continue;
      taken_.push_back(box);
      std::ostringstream out;
      out << std::fixed << std::setprecision(2) << "<text class='label " << style << "' x='" << x + dx << "' y='" << y + dy
          << "'>" << html_escaped(text) << "</text>\n";
      return out.str();
    }
    return {};
  }

 private:
  bool is_free(const Box& box) const {
    if (box.left < left_ || box.right > left_ + panel_width || box.bottom < head || box.top > head + panel_height)
      return false;
    return std::none_of(taken_.begin(), taken_.end(), [&](const Box& other) {
      return box.left < other.right && other.left < box.right && box.bottom < other.top && other.bottom < box.top;
    });
  }

  double left_;
  std::vector<Box> taken_;
};

class Drawing {
 public:
  explicit Drawing(const Scene& scene) : scene_(scene) { out_ << std::fixed << std::setprecision(2); }

  void panel(const Panel& panel, const Sketch& sketch) {
    out_ << "<text class='title' x='" << panel.left() << "' y='" << head - 12 << "'>" << panel.view().title << "</text>\n"
         << "<svg x='0' y='0' width='100%' height='100%' clip-path='url(#panel" << (panel.left() > margin) << ")'>\n";
    for (const PlaneObject& plane : scene_.planes) draw_plane(panel, plane.shape);
    for (const SphereObject& sphere : scene_.spheres) draw_sphere(panel, sphere.shape, sphere.material);
    for (const SphereCloud& cloud : scene_.clouds)
      for (const Sphere& sphere : cloud.spheres) draw_sphere(panel, sphere, cloud.material);
    for (const PointLight& light : scene_.point_lights)
      out_ << "<circle class='light' r='6' cx='" << panel.x(light.position) << "' cy='" << panel.y(light.position)
           << "'/>\n";
    for (const Stroke& stroke : sketch.strokes) draw_stroke(panel, stroke);
    draw_labels(panel, sketch);
    out_ << "</svg>\n<rect class='frame' x='" << panel.left() << "' y='" << head << "' width='" << panel_width
         << "' height='" << panel_height << "'/>\n";
  }

  std::string text() const { return out_.str(); }

 private:
  void draw_sphere(const Panel& panel, const Sphere& sphere, const Material& material) {
    if (!panel.shows(sphere)) return;
    out_ << "<circle class='" << (material.transparent ? "glass" : "sphere") << "' cx='" << panel.x(sphere.center)
         << "' cy='" << panel.y(sphere.center) << "' r='" << panel.scale() * sphere.radius << "' fill='"
         << color_text(material.color) << "'/>\n";
  }

  /// A plane that is seen edge on is a line.
  void draw_plane(const Panel& panel, const Plane& plane) {
    const Vec3 n = unit(plane.normal), along = cross(panel.view().right, panel.view().up);
    if (std::abs(dot(n, along)) > 1e-6) return;
    const Vec3 way = cross(n, along), middle = plane.point;
    const double far = 4 * (panel_width + panel_height) / panel.scale();
    const Vec3 a = middle - far * way, b = middle + far * way;
    out_ << "<line class='plane' x1='" << panel.x(a) << "' y1='" << panel.y(a) << "' x2='" << panel.x(b) << "' y2='"
         << panel.y(b) << "'/>\n";
  }

  void draw_stroke(const Panel& panel, const Stroke& stroke) {
    const double x = panel.x(stroke.to), y = panel.y(stroke.to);
    out_ << "<line class='" << stroke.style << "' x1='" << panel.x(stroke.from) << "' y1='" << panel.y(stroke.from)
         << "' x2='" << x << "' y2='" << y << "'" << (stroke.ends_nowhere ? "" : " marker-end='url(#end)'") << "/>\n";
    if (stroke.blocked) out_ << "<path class='blocked' d='M" << x - 5 << ' ' << y - 5 << "l10 10m0 -10l-10 10'/>\n";
  }

  /// Each name once, rays before what they meet, and ways to lights last: those there are most of.
  void draw_labels(const Panel& panel, const Sketch& sketch) {
    Labels labels(panel.left());
    std::set<std::string> said;
    const auto say = [&](const Vec3& at, const std::string& text, const std::string& style) {
      if (text.empty() || said.contains(text)) return;
      const std::string element = labels.at(panel.x(at), panel.y(at), text, style);
      if (!element.empty()) said.insert(text);
      out_ << element;
    };
    const auto middle = [](const Stroke& stroke) { return (stroke.from + stroke.to) / 2.0; };
    for (const Stroke& stroke : sketch.strokes)
      if (stroke.style != "shadow") say(middle(stroke), stroke.label, "on-" + stroke.style);
    for (const Name& name : sketch.names) say(name.at, name.text, "");
    for (const Stroke& stroke : sketch.strokes)
      if (stroke.style == "shadow") say(middle(stroke), stroke.label, "on-shadow");
  }

  const Scene& scene_;
  std::ostringstream out_;
};

/// From above, and from the side that shows the way the camera looks.
std::vector<View> views(const Scene& scene) {
  Vec3 forward = scene.camera.facing;
  forward.y = 0;
  const Vec3 along = length(forward) > 1e-6 * length(scene.camera.facing) ? unit(forward) : Vec3(1, 0, 0);
  return {{"From above: the camera looks to the right", along, cross(Vec3(0, 1, 0), along)},
          {"From the side: the camera looks to the right", along, Vec3(0, 1, 0)}};
}

const char* const style = R"(<style>
text{font:14px sans-serif;fill:#1a1f24}.title{font-weight:600}.head{font-size:16px;font-weight:600}
.frame{fill:none;stroke:#8a939c}.sphere{stroke:#444;fill-opacity:.35}.glass{stroke:#3b7dd8;fill:#dcebff;fill-opacity:.5;stroke-dasharray:6 3}
.plane{stroke:#777;stroke-width:2.5}.light{fill:#ffd24a;stroke:#8a6500}line{fill:none;stroke-width:2}
.camera{stroke:#14396b}.reflected{stroke:#c2410c;stroke-dasharray:9 3}.refracted{stroke:#15803d;stroke-dasharray:2 3;stroke-width:2.6}
.inside{stroke:#15803d;stroke-width:1.2}.shadow{stroke:#6b7280;stroke-width:1.2;stroke-dasharray:4 4}.blocked{stroke:#b00020;stroke-width:2.4;fill:none}
.other{stroke:#a21caf;stroke-width:2.4;stroke-dasharray:12 4 2 4}.label{font-size:12px;paint-order:stroke;stroke:#fff;stroke-width:3px}
.on-camera{fill:#14396b}.on-reflected{fill:#c2410c}.on-refracted{fill:#15803d}.on-shadow{fill:#6b7280}.on-other{fill:#a21caf}
</style>)";

/// Of the kinds of rays that are there.
void legend(std::ostream& out, const Sketch& sketch, const std::string& other) {
  const struct {
    const char* style;
    std::string text;
  } rows[] = {{"camera", "camera ray"},
              {"reflected", "reflected ray"},
              {"refracted", "refracted ray"},
              {"shadow", "ray to a light; a cross where it is blocked"},
              {"other", "the ray that " + other + " has instead"}};
  double x = margin;
  const double y = head + panel_height + 34;
  for (const auto& row : rows) {
    if (std::none_of(sketch.strokes.begin(), sketch.strokes.end(), [&](const Stroke& s) { return s.style == row.style; }))
      continue;
    out << "<line class='" << row.style << "' x1='" << x << "' y1='" << y << "' x2='" << x + 36 << "' y2='" << y
        << "'/><text x='" << x + 44 << "' y='" << y + 5 << "'>" << html_escaped(row.text) << "</text>\n";
    x += 76 + 7 * static_cast<double>(row.text.size());
  }
}

}  // namespace

std::string explanation_svg(const Scene& scene, const Explanation& explanation) {
  double longest = 0;
  for (const RayNode& tree : explanation.trees) longest = std::max(longest, reach(tree));
  const double far = longest > 0 ? 0.35 * longest : 1;
  Sketch sketch;
  for (const RayNode& tree : explanation.trees) add_rays(scene, tree, far, sketch);
  if (explanation.other) add_other_rays(*explanation.other, far, sketch);

  const double width = 3 * margin + 2 * panel_width, height = head + panel_height + foot;
  std::ostringstream out;
  out << std::fixed << std::setprecision(2) << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 " << width << ' '
      << height << "' width='" << width << "' height='" << height << "' role='img'>\n";
  const std::string title = explanation.scene + ", stage " + std::to_string(explanation.settings.stage) +
                            ": the rays of pixel " + std::to_string(explanation.column) + "," +
                            std::to_string(explanation.row);
  out << "<title>" << html_escaped(title) << "</title>\n"
      << style << "<rect width='100%' height='100%' fill='#fff'/>\n"
      << "<defs><marker id='end' viewBox='0 0 8 8' refX='7' refY='4' markerWidth='6' markerHeight='6' orient='auto'>"
         "<path d='M0 0L8 4L0 8z' fill='context-stroke'/></marker>\n";
  for (int k = 0; k < 2; ++k)
    out << "<clipPath id='panel" << k << "'><rect x='" << margin + k * (margin + panel_width) << "' y='" << head
        << "' width='" << panel_width << "' height='" << panel_height << "'/></clipPath>";
  out << "</defs>\n<text class='head' x='" << margin << "' y='26'>" << html_escaped(title) << "</text>\n";
  Drawing drawing(scene);
  double left = margin;
  for (const View& view : views(scene)) {
    drawing.panel(Panel(view, sketch.strokes, left), sketch);
    left += margin + panel_width;
  }
  out << drawing.text();
  legend(out, sketch, explanation.other ? explanation.other->with : "");
  out << "</svg>\n";
  return out.str();
}

}  // namespace raylab
