#include "core/image/diff_patterns.hpp"

#include "core/image/reference_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace raylab {
namespace {

// From which share on a statement holds: docs/tolerance.md.
constexpr double nearly_all = 0.9;
constexpr double most = 0.8;
constexpr double explained = 0.1;        // of the error, what may be left when a whole-image change explains it
constexpr double explained_half = 0.67;  // the same for half a pixel: between pixels the reference is only interpolated

std::string percent(double share) {
  char text[16];
  std::snprintf(text, sizeof text, "%.0f %%", 100 * share);
  return text;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

class Patterns {
 public:
  Patterns(const Image& image, const Reference& reference, const Comparison& comparison)
      : image_(image),
        reference_(reference),
        value_(comparison.clamped_each ? reference.each->value : reference.value),
        comparison_(comparison) {}

  std::vector<Finding> find() {
    if (comparison_.same) return {};
    if (comparison_.rmse > 0) {
      mirrored();
      shifted();
      brighter();
      transfer_curve();
    }
    everywhere();
    one_object();
    edges();
    return std::move(findings_);
  }

 private:
  void say(const std::string& kind, const std::string& text) { findings_.push_back({kind, text}); }

  double share(std::size_t part, std::size_t whole) const { return static_cast<double>(part) / static_cast<double>(whole); }

  bool is_outside(std::size_t k) const { return comparison_.verdict[k] == PixelVerdict::outside; }

  // The whole image, changed.

  struct Fit {
    double error = 0;    ///< root mean square of image - other(column, row), where there is such a color
    double before = 0;   ///< of image - reference, over the same pixels
    double overlap = 0;  ///< their share of the image
  };

  template <class Other>
  Fit fit_of(Other other) const {
    double sum = 0, sum_before = 0;
    std::size_t pixels = 0;
    for (int row = 0; row < image_.height; ++row)
      for (int column = 0; column < image_.width; ++column) {
        const std::optional<Color> expected = other(column, row);
        const Color& pixel = image_.at(column, row);
        if (!expected || !is_finite(pixel)) continue;
        sum += squared(pixel - *expected);
        sum_before += squared(pixel - value_.at(column, row));
        ++pixels;
      }
    return {std::sqrt(sum), std::sqrt(sum_before), share(pixels, image_.pixels.size())};
  }

  static double squared(const Color& off) { return dot(off, off); }

  bool explains(const Fit& fit, double left) const {
    return fit.overlap >= most && fit.before > 0 && fit.error <= left * fit.before;
  }

  void mirrored() {
    const int right = image_.width - 1;
    const int bottom = image_.height - 1;
    const auto left_to_right = [&](int x, int y) { return std::optional(value_.at(right - x, y)); };
    const auto upside_down = [&](int x, int y) { return std::optional(value_.at(x, bottom - y)); };
    const auto turned = [&](int x, int y) { return std::optional(value_.at(right - x, bottom - y)); };
    const auto transposed = [&](int x, int y) {
      return image_.width == image_.height ? std::optional(value_.at(y, x)) : std::nullopt;
    };
    const std::array candidates{std::pair{fit_of(left_to_right), "mirrored left to right"},
                                std::pair{fit_of(upside_down), "upside down"},
                                std::pair{fit_of(turned), "turned by half a turn: mirrored both ways"},
                                std::pair{fit_of(transposed), "with x and y exchanged"}};
    const auto left_of = [&](const Fit& fit) { return explains(fit, explained) ? fit.error / fit.before : 1; };
    const auto best = std::min_element(candidates.begin(), candidates.end(),
                                       [&](const auto& a, const auto& b) { return left_of(a.first) < left_of(b.first); });
    if (explains(best->first, explained)) say("mirrored", std::string("The image is the reference ") + best->second + ".");
  }

  /// The reference between pixels.
  std::optional<Color> reference_at(double x, double y) const {
    const auto column = static_cast<int>(std::floor(x));
    const auto row = static_cast<int>(std::floor(y));
    if (column < 0 || row < 0 || std::ceil(x) >= image_.width || std::ceil(y) >= image_.height) return {};
    const double right = x - column;
    const double down = y - row;
    const int next_column = right > 0 ? column + 1 : column;
    const int next_row = down > 0 ? row + 1 : row;
    return (1 - down) * ((1 - right) * value_.at(column, row) + right * value_.at(next_column, row)) +
           down * ((1 - right) * value_.at(column, next_row) + right * value_.at(next_column, next_row));
  }

  void shifted() {
    double best = 1;
    std::pair<double, double> by{0, 0};
    for (const double dx : {-1.0, -0.5, 0.0, 0.5, 1.0})
      for (const double dy : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
        const bool whole = dx == std::floor(dx) && dy == std::floor(dy);
        const Fit fit = fit_of([&](int column, int row) { return reference_at(column - dx, row - dy); });
        if (!explains(fit, whole ? explained : explained_half) || fit.error >= best * fit.before) continue;
        best = fit.error / fit.before;
        by = {dx, dy};
      }
    const auto [dx, dy] = by;
    if (dx == 0 && dy == 0) return;
    std::string text = "The image is the reference shifted";
    if (dx != 0) text += " by " + pixels(dx) + (dx > 0 ? " to the right" : " to the left");
    if (dx != 0 && dy != 0) text += " and";
    if (dy != 0) text += " by " + pixels(dy) + (dy > 0 ? " down" : " up");
    say("shifted", text + ".");
  }

  static std::string pixels(double distance) { return std::abs(distance) < 1 ? "half a pixel" : "one pixel"; }

  /// The least-squares factor over the components that neither image clamps, a third of all at least. It must explain the
  /// clamped ones, too.
  void brighter() {
    constexpr double black = 1e-3, white = 0.999;
    double products = 0, squares = 0;
    std::size_t free = 0;
    each_component([&](double mine, double theirs) {
      if (std::min(mine, theirs) <= black || std::max(mine, theirs) >= white) return;
      products += mine * theirs;
      squares += theirs * theirs;
      ++free;
    });
    if (free < image_.pixels.size()) return;
    const double factor = products / squares;
    const auto scaled = [&](int x, int y) { return std::optional(clamped(factor * value_.at(x, y))); };
    if (explains(fit_of(scaled), explained))
      say("brighter", std::string("The image is the reference made ") + (factor > 1 ? "brighter" : "darker") + ": times " +
                          number(factor) + ".");
  }

  static Color clamped(const Color& c) {
    return {std::clamp(c.r, 0.0, 1.0), std::clamp(c.g, 0.0, 1.0), std::clamp(c.b, 0.0, 1.0)};
  }

  /// sRGB's (IEC 61966-2-1), which many programs put on or take off when they convert an image.
  void transfer_curve() {
    const auto encode = [](double c) { return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055; };
    const auto decode = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    const auto mapped = [&](auto curve) {
      return [this, curve](int x, int y) {
        const Color& c = value_.at(x, y);
        return std::optional(Color(curve(c.r), curve(c.g), curve(c.b)));
      };
    };
    if (explains(fit_of(mapped(encode)), explained))
      say("transfer-curve", "The image is the reference with sRGB's curve put on: save the numbers as they are.");
    if (explains(fit_of(mapped(decode)), explained))
      say("transfer-curve", "The image is the reference with sRGB's curve taken off: save the numbers as they are.");
  }

  template <class Visit>
  void each_component(Visit visit) const {
    for (std::size_t k = 0; k < image_.pixels.size(); ++k)
      if (is_finite(image_.pixels[k]))
        for (int channel = 0; channel < 3; ++channel) visit(image_.pixels[k][channel], value_.pixels[k][channel]);
  }

  // Where the pixels outside lie.

  void everywhere() {
    const double part = share(comparison_.outside, image_.pixels.size());
    if (part >= nearly_all)
      say("everywhere", "The difference is everywhere: " + percent(part) + " of the pixels are outside.");
  }

  void one_object() {
    if (!knows_objects() || comparison_.outside == 0) return;
    std::map<GeometryId, std::size_t> outside, area;
    for (std::size_t k = 0; k < image_.pixels.size(); ++k) {
      ++area[reference_.object[k]];
      if (is_outside(k)) ++outside[reference_.object[k]];
    }
    const auto [object, pixels] =
        *std::max_element(outside.begin(), outside.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    const double part = share(pixels, comparison_.outside);
    if (part >= nearly_all && share(area[object], image_.pixels.size()) < 1 - explained)
      say("one-object", "The difference is on one object: " + percent(part) + " of the pixels outside show " +
                            object_name(reference_, object) + ".");
  }

  void edges() {
    if (!knows_objects() || comparison_.outside == 0) return;
    std::size_t at_edges = 0, outside_at_edges = 0;
    for (std::size_t k = 0; k < image_.pixels.size(); ++k) {
      if (!at_edge(k)) continue;
      ++at_edges;
      if (is_outside(k)) ++outside_at_edges;
    }
    const double part = share(outside_at_edges, comparison_.outside);
    if (part >= most && share(at_edges, image_.pixels.size()) < 1 - most)
      say("edges", "The difference is at edges: " + percent(part) + " of the pixels outside touch an object's outline.");
  }

  bool knows_objects() const { return reference_.has_word() && reference_.stage > 1; }

  /// Does one of the eight neighbors show another object?
  bool at_edge(std::size_t k) const {
    const int column = static_cast<int>(k) % image_.width;
    const int row = static_cast<int>(k) / image_.width;
    for (int y = std::max(row - 1, 0); y <= std::min(row + 1, image_.height - 1); ++y)
      for (int x = std::max(column - 1, 0); x <= std::min(column + 1, image_.width - 1); ++x)
        if (reference_.object[static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) +
                              static_cast<std::size_t>(x)] != reference_.object[k])
          return true;
    return false;
  }

  const Image& image_;
  const Reference& reference_;
  const Image& value_;
  const Comparison& comparison_;
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> find_patterns(const Image& image, const Reference& reference, const Comparison& comparison) {
  return Patterns(image, reference, comparison).find();
}

}  // namespace raylab
