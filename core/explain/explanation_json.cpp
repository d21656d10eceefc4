#include "core/explain/difference_json.hpp"
#include "core/explain/explanation.hpp"
#include "core/explain/formulas.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace raylab {

using Json = nlohmann::ordered_json;

namespace {

Json vector(const Vec3& v) { return {v.x, v.y, v.z}; }

Json light_json(const LightTerm& term) {
  Json crossings = Json::array();
  for (const Crossing& crossing : term.crossings)
    crossings.push_back({{"t", crossing.t}, {"transparent", crossing.transparent}});
  Json json{{"light", light_name(term)}, {"color", vector(term.color)}, {"in_shadow", term.blocked}};
  if (term.distance) {
    json["shadow_ray"] = {{"crossings", crossings},
                          {"distance", std::isfinite(*term.distance) ? Json(*term.distance) : "inf"}};
  }
  return json;
}

Json node_json(const Scene& scene, const RayNode& node, bool traced = true) {
  Json json{{"kind", kind_name(node.kind)},
            {"bounce", node.bounce},
            {"weight", node.weight},
            {"traced", traced},
            {"origin", vector(node.ray.origin)},
            {"direction", vector(node.ray.direction)}};
  if (!traced) return json;
  json["color"] = vector(node.color);
  json["meets"] = node.t ? Json(geometry_name(scene, node.geometry)) : Json(nullptr);
  json["t"] = node.t ? Json(*node.t) : Json(nullptr);
  if (node.t) json["point"] = vector(node.ray.origin + *node.t * node.ray.direction);
  if (node.normal) json["normal"] = vector(*node.normal);
  json["lights"] = Json::array();
  for (const LightTerm& term : node.lights) json["lights"].push_back(light_json(term));
  json["rays"] = Json::array();
  for (const RayNode& child : node.children) json["rays"].push_back(node_json(scene, child));
  for (const RayNode& child : node.ended) json["rays"].push_back(node_json(scene, child, false));
  return json;
}

}  // namespace

Json difference_json(const Difference& difference) {
  const TaskInfo& task = *difference.call.task;
  const Formula formula = formula_of(task.label);
  Json json{{"task", task.label},
            {"name", task.name},
            {"arguments", Json::parse(difference.call.arguments)},
            {"expected", Json::parse(difference.call.result)},
            {"formula", formula.formula},
            {"handout", formula.handout}};
  if (difference.error.empty())
    json["got"] = Json::parse(difference.got);
  else
    json["error"] = difference.error;
  return json;
}

namespace {

Json other_json(const OtherView& other) {
  Json json{{"with", other.with}, {"color", other.color ? vector(*other.color) : Json(nullptr)}};
  if (!other.error.empty()) json["error"] = other.error;
  json["calls"] = other.calls;
  json["first_difference"] = other.difference ? difference_json(*other.difference) : Json(nullptr);
  return json;
}

}  // namespace

std::string explanation_json(const Scene& scene, const Explanation& explanation) {
  const Settings& settings = explanation.settings;
  Json json{{"scene", explanation.scene},
            {"stage", stage_info(settings.stage).name},
            {"width", settings.size.width},
            {"height", settings.size.height},
            {"pixel", {explanation.column, explanation.row}},
            {"color", vector(explanation.color)},
            {"samples", Json::array()}};
  for (const RayNode& tree : explanation.trees) json["samples"].push_back(node_json(scene, tree));
  if (explanation.other) json["other"] = other_json(*explanation.other);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace raylab
