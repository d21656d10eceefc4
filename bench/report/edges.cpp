#include "bench/report/edges.hpp"

#include "core/render/render.hpp"
#include "reference/engine/engine.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <numbers>

namespace raylab::bench {
namespace {

constexpr std::array patterns{AntiAliasing::none,   AntiAliasing::grid4,  AntiAliasing::rotated4,
                              AntiAliasing::grid16, AntiAliasing::grid64, AntiAliasing::adaptive};
constexpr ImageSize size{32, 32};
constexpr double half_field_of_view = 1;  // degrees

/// The line a x + b y = c in pixels from the middle of the image, x to the right and y up. (a, b) is a unit vector; the
/// plane is where a x + b y < c.
struct Edge {
  double a, b, c;
};

/// The edge that runs at `degrees` to the rows, `c` pixels from the middle.
Edge edge_at(double degrees, double c) {
  const double angle = degrees * std::numbers::pi / 180;
  return {-std::sin(angle), std::cos(angle), c};
}

double pixel_width() { return 2 * std::tan(half_field_of_view * std::numbers::pi / 180) / size.width; }

/// A white plane below the camera, whose horizon is the edge. Along the direction facing + s (x right + y up), y in the
/// world is facing.y + s (x right.y + y up.y): 0 on the line, if right.y, up.y are in the ratio of a and b.
Scene horizon(const Edge& edge) {
  const double tilt = std::atan(edge.c * pixel_width());  // downwards, to raise the horizon
  Scene scene;
  scene.camera.position = {0, 1, 0};
  scene.camera.facing = {0, -std::sin(tilt), -std::cos(tilt)};
  // Right and up before the roll are x and (0, cos, -sin); the roll turns them.
  const Vec3 right(1, 0, 0), up(0, std::cos(tilt), -std::sin(tilt));
  scene.camera.up = edge.b * up - edge.a * right;
  scene.camera.half_field_of_view = half_field_of_view;
  scene.planes.push_back({{{0, 0, 0}, {0, 1, 0}}, {.color = Color(1)}});
  return scene;
}

/// The part of the unit square around (x, y) where a x + b y < c: how far a line in direction (a, b) sweeps over it, as an
/// integral of the piecewise linear width, in closed form.
double covered(const Edge& edge, double x, double y) {
  const double p = std::abs(edge.a), q = std::abs(edge.b);
  const double least = std::min(p, q), most = std::max(p, q);
  const double d = edge.c - edge.a * x - edge.b * y;  // from the pixel's center to the line
  const double beyond = std::abs(d);
  if (beyond >= (p + q) / 2) return d > 0 ? 1 : 0;
  double part;  // on the center's side of the line
  if (beyond <= (most - least) / 2)
    part = 0.5 + beyond / most;
  else
    part = 1 - std::pow((p + q) / 2 - beyond, 2) / (2 * p * q);
  return d > 0 ? part : 1 - part;
}

/// Squared errors of the pixels that an edge runs through.
struct Sum {
  double squares = 0;
  long pixels = 0;

  double rmse() const { return pixels == 0 ? 0 : std::sqrt(squares / static_cast<double>(pixels)); }
};

void add_errors(Sum& sum, const Image& image, const Edge& edge) {
  for (int row = 0; row < size.height; ++row)
    for (int column = 0; column < size.width; ++column) {
      const double x = column + 0.5 - size.width / 2.0, y = size.height / 2.0 - row - 0.5;
      const double right = covered(edge, x, y);
      if (right <= 0 || right >= 1) continue;
      const double error = image.at(column, row).r - right;
      sum.squares += error * error;
      ++sum.pixels;
    }
}

/// Over edges at this angle whose places in a pixel are spread evenly, by the golden ratio.
double rmse_at(double degrees, AntiAliasing aa, int places, const std::atomic<bool>& cancel) {
  Sum sum;
  for (int k = 0; k < places; ++k) {
    if (cancel) throw Cancelled{};
    const Edge edge = edge_at(degrees, std::fmod((k + 0.5) * (std::numbers::phi - 1), 1) - 0.5);
    const Scene scene = horizon(edge);
    const Image image = render_image(*make_fast(scene, {2, size, 0, aa}, {}), size, 1);
    add_errors(sum, image, edge);
  }
  return sum.rmse();
}

Json measure_pattern(const Plan& plan, AntiAliasing aa, const std::atomic<bool>& cancel) {
  Json points = Json::array();
  const double step = plan.quick ? 7.5 : 2.5;
  for (double degrees = 0; degrees <= 90; degrees += step)
    points.push_back({{"degrees", degrees}, {"rmse", rmse_at(degrees, aa, plan.quick ? 8 : 32, cancel)}});
  // The rotated grid's own direction, where its samples lie in rows.
  const double worst = std::atan(0.5) * 180 / std::numbers::pi;
  points.push_back({{"degrees", worst}, {"rmse", rmse_at(worst, aa, plan.quick ? 8 : 32, cancel)}});
  std::sort(points.begin(), points.end(), [](const Json& a, const Json& b) { return a["degrees"] < b["degrees"]; });
  return {{"aa", aa_name(aa)}, {"samples", sample_offsets(aa).size()}, {"points", points}};
}

std::string unit_name(AntiAliasing aa) { return "edges/" + std::string(aa_name(aa)); }

double rmse_near(const Json& pattern, double degrees) {
  const Json& points = pattern["points"];
  return (*std::min_element(points.begin(), points.end(), [&](const Json& a, const Json& b) {
    return std::abs(a["degrees"].get<double>() - degrees) < std::abs(b["degrees"].get<double>() - degrees);
  }))["rmse"];
}

/// What the rotated grid does beside the straight one of as many samples.
std::string sentence(const Json& grid, const Json& rotated) {
  char text[240];
  std::snprintf(text, sizeof text,
                "Of four samples, the rotated grid has %.2f times the straight grid's error on an edge along the rows, %.2f "
                "times at 26.6 degrees, and %.2f times at 45.",
                rmse_near(rotated, 0) / rmse_near(grid, 0), rmse_near(rotated, 26.565) / rmse_near(grid, 26.565),
                rmse_near(rotated, 45) / rmse_near(grid, 45));
  return text;
}

}  // namespace

std::vector<Unit> edge_units(const Plan& plan) {
  std::vector<Unit> units;
  for (const AntiAliasing aa : patterns)
    units.push_back({unit_name(aa), plan.quick ? 0.1 : 1.5,
                     [plan, aa](const std::atomic<bool>& cancel) { return measure_pattern(plan, aa, cancel); }});
  return units;
}

Json edge_report(const Results& results) {
  Json all = Json::array();
  for (const AntiAliasing aa : patterns)
    if (const auto found = results.find(unit_name(aa)); found != results.end()) all.push_back(found->second);
  if (all.size() != patterns.size()) return nullptr;
  const auto of = [&](AntiAliasing aa) -> const Json& { return results.at(unit_name(aa)); };
  return {{"patterns", all}, {"sentence", sentence(of(AntiAliasing::grid4), of(AntiAliasing::rotated4))}};
}

}  // namespace raylab::bench
