#include "core/explain/explanation.hpp"

#include "core/calls/json_value.hpp"
#include "core/explain/formulas.hpp"
#include "core/explain/handbook.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>
#include <utility>

namespace raylab {
namespace {

std::string number(double value) {
  std::ostringstream stream;
  stream << std::setprecision(6) << (value == 0 ? 0.0 : value);
  return stream.str();
}

std::string vector(const Vec3& v) { return "(" + number(v.x) + ", " + number(v.y) + ", " + number(v.z) + ")"; }

/// A value as it stands in JSON, for people: "{point: (0, 1.5, 0), k_s: 0.5}", with so many digits.
std::string readable(const JsonValue& value, int digits);

std::string readable(const JsonList& list, int digits) {
  std::string out;
  for (const JsonValue& element : list) out += (out.empty() ? "" : ", ") + readable(element, digits);
  return "(" + out + ")";
}

std::string readable(const JsonObject& object, int digits) {
  std::string out;
  for (const JsonMember& member : object)
    out += (out.empty() ? "" : ", ") + member.key + ": " + readable(member.value, digits);
  return "{" + out + "}";
}

std::string readable(const JsonValue& value, int digits) {
  if (const auto* list = std::get_if<JsonList>(&value.data)) return readable(*list, digits);
  if (const auto* object = std::get_if<JsonObject>(&value.data)) return readable(*object, digits);
  if (const auto* text = std::get_if<std::string>(&value.data)) return *text;
  if (const auto* flag = std::get_if<bool>(&value.data)) return *flag ? "true" : "false";
  if (const auto* number = std::get_if<double>(&value.data)) {
    std::ostringstream stream;
    stream << std::setprecision(digits) << (*number == 0 ? 0.0 : *number);
    return stream.str();
  }
  return "nothing";
}

/// Both with as few digits as show that they differ, six at least.
std::pair<std::string, std::string> readable_pair(const std::string& wanted, const std::string& got) {
  const JsonValue a = parse_json(wanted), b = parse_json(got);
  int digits = 6;
  while (digits < 17 && readable(a, digits) == readable(b, digits)) ++digits;
  return {readable(a, digits), readable(b, digits)};
}

void add_lines(const std::string& name, const JsonValue& value, std::vector<std::string>& lines) {
  constexpr std::size_t longest = 90;
  const std::string text = readable(value, 6);
  const auto* const object = std::get_if<JsonObject>(&value.data);
  if (!object || (!name.empty() && text.size() <= longest)) {
    lines.push_back(name.empty() ? text : name + " = " + text);
    return;
  }
  for (const JsonMember& member : *object)
    add_lines(name.empty() ? member.key : name + "." + member.key, member.value, lines);
}

class TreeText {
 public:
  explicit TreeText(const Scene& scene) : scene_(scene) {}

  std::string operator()(const RayNode& tree) {
    node(tree, "");
    return out_.str();
  }

 private:
  static std::string title(const RayNode& node) {
    std::string text = kind_name(node.kind) + " ray";
    if (node.bounce > 0) text += ", bounce " + std::to_string(node.bounce) + ", weight " + number(node.weight);
    return text;
  }

  void node(const RayNode& node, const std::string& indent) {
    out_ << indent << title(node) << ": color " << vector(node.color) << '\n';
    const std::string inner = indent + "    ";
    out_ << inner << "from " << vector(node.ray.origin) << " along " << vector(node.ray.direction) << '\n';
    surface(node, inner);
    for (const LightTerm& term : node.lights) light(term, inner);
    for (const RayNode& child : node.children) this->node(child, inner);
    for (const RayNode& child : node.ended)
      out_ << inner << title(child) << ": not traced ("
           << (child.weight == 0 ? "it would bring nothing" : "beyond the last bounce") << ")\n";
  }

  void surface(const RayNode& node, const std::string& indent) {
    if (!node.t) {
      out_ << indent << "meets nothing: the background\n";
      return;
    }
    out_ << indent << "meets " << geometry_name(scene_, node.geometry) << " at t = " << number(*node.t) << ", point "
         << vector(node.ray.origin + *node.t * node.ray.direction);
    if (node.normal) out_ << ", normal " << vector(*node.normal);
    out_ << '\n';
  }

  void light(const LightTerm& term, const std::string& indent) {
    out_ << indent << light_name(term) << ": ";
    if (!term.blocked) {
      out_ << "+ " << vector(term.color) << '\n';
      return;
    }
    double nearest = INFINITY;
    for (const Crossing& crossing : term.crossings)
      if (!crossing.transparent) nearest = std::min(nearest, crossing.t);
    out_ << "in shadow, of something at t = " << number(nearest) << "; the light is "
         << (std::isfinite(*term.distance) ? "at " + number(*term.distance) : "infinitely far") << '\n';
  }

  const Scene& scene_;
  std::ostringstream out_;
};

void other_text(std::ostream& out, const OtherView& other) {
  out << '\n' << other.with << ": ";
  if (other.color)
    out << "color " << vector(*other.color) << '\n';
  else
    out << other.error << '\n';
  if (other.difference)
    out << "The first call that it answers differently:\n\n" << difference_text(*other.difference, other.with);
  else
    out << "It answers all " << other.calls << " calls of this pixel as the solution does, but for rounding.\n";
}

}  // namespace

std::string geometry_name(const Scene& scene, GeometryId id) {
  if (id < 0) return "nothing";
  auto index = static_cast<std::size_t>(id);
  if (index < scene.planes.size()) return "plane[" + std::to_string(index) + "]";
  index -= scene.planes.size();
  if (index < scene.spheres.size()) return "sphere[" + std::to_string(index) + "]";
  index -= scene.spheres.size();
  std::size_t cloud = 0;
  for (; index >= scene.clouds[cloud].spheres.size(); ++cloud) index -= scene.clouds[cloud].spheres.size();
  return "sphere " + std::to_string(index) + " of cloud[" + std::to_string(cloud) + "]";
}

std::string light_name(const LightTerm& light) {
  const char* const kinds[] = {"ambient_light", "point_light", "directional_light"};
  return std::string(kinds[static_cast<std::size_t>(light.kind)]) + "[" + std::to_string(light.number) + "]";
}

std::string kind_name(RayNode::Kind kind) {
  const char* const kinds[] = {"camera", "reflected", "refracted"};
  return kinds[static_cast<std::size_t>(kind)];
}

std::vector<std::string> value_lines(const std::string& json) {
  std::vector<std::string> lines;
  add_lines("", parse_json(json), lines);
  return lines;
}

std::string difference_text(const Difference& difference, const std::string& with) {
  const TaskInfo& task = *difference.call.task;
  std::ostringstream out;
  out << "  task      " << task.label << ' ' << task.name << ": " << task.summary << '\n';
  const char* before = "  asked     ";
  for (const std::string& line : value_lines(difference.call.arguments)) {
    out << before << line << '\n';
    before = "            ";
  }
  const auto [wanted, got] =
      readable_pair(difference.call.result, difference.error.empty() ? difference.got : json_string(difference.error));
  out << "  expected  " << wanted << "\n  got       " << got << '\n';
  if (const Formula formula = formula_of(task.label); !formula.formula.empty())
    out << "  formula   " << formula.formula << "\n  handout   " << formula.handout << '\n';
  out << "  contract  " << in_handbook(std::string(stage_info(stage_of(task.label)).folder) + "/stage.hpp") << '\n'
      << "  again     raylab call " << task.label << " '" << difference.call.arguments << "' " << with << '\n';
  return out.str();
}

std::string explanation_text(const Scene& scene, const Explanation& explanation) {
  std::ostringstream out;
  const Settings& settings = explanation.settings;
  out << explanation.scene << " up to " << stage_title(settings.stage) << ", " << settings.size.width << "x"
      << settings.size.height << ": pixel " << explanation.column << ',' << explanation.row << "\ncolor "
      << vector(explanation.color) << "\n\n";
  for (std::size_t k = 0; k < explanation.trees.size(); ++k) {
    if (explanation.trees.size() > 1) out << "sample " << k + 1 << " of " << explanation.trees.size() << ": ";
    out << TreeText(scene)(explanation.trees[k]);
  }
  if (explanation.other) other_text(out, *explanation.other);
  return out.str();
}

}  // namespace raylab
