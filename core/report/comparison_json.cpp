#include "core/report/comparison_json.hpp"

#include <cmath>

namespace raylab {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0 ? "Infinity" : "-Infinity";
  return value;
}

Json color(const Color& c) { return Json::array({number(c.r), number(c.g), number(c.b)}); }

Json worst(const Comparison& comparison) {
  Json pixels = Json::array();
  for (const OutsidePixel& pixel : comparison.worst)
    pixels.push_back({{"column", pixel.column},
                      {"row", pixel.row},
                      {"image", color(pixel.image)},
                      {"least", color(pixel.least)},
                      {"greatest", color(pixel.greatest)},
                      {"distance", number(pixel.distance)}});
  return pixels;
}

Json findings(const Comparison& comparison) {
  Json all = Json::array();
  for (const Finding& finding : comparison.findings) all.push_back({{"kind", finding.kind}, {"text", finding.text}});
  return all;
}

}  // namespace

Json comparison_json(const Comparison& c) {
  return {{"verdict", c.same ? "same" : "differs"},
          {"width", c.width},
          {"height", c.height},
          {"score", number(c.score)},
          {"outside", c.outside},
          {"allowed", c.allowed},
          {"densest", c.densest},
          {"densest_allowed", c.densest_allowed},
          {"at_decision", c.at_decision},
          {"non_finite", c.non_finite},
          {"clamped_each", c.clamped_each},
          {"max_error", number(c.max_error)},
          {"mean_error", number(c.mean_error)},
          {"rmse", number(c.rmse)},
          {"psnr", number(c.psnr)},
          {"share_at_decisions", number(c.share_at_decisions)},
          {"findings", findings(c)},
          {"worst", worst(c)}};
}

}  // namespace raylab
