#include "core/image/diff.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raylab {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int square = 5;  // pixels a side, in which the density is measured
constexpr std::size_t shown = 10;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// An image that came through 8 bits has no finer steps, whatever file it is in now.
NumberFormat effective_format(const Image& image, NumberFormat format) {
  constexpr double rounding = 1e-7;  // of a float beside 1
  const auto is_level = [](double x) { return std::abs(x - std::round(255 * x) / 255) <= rounding; };
  const auto all_levels = [&](const Color& c) { return is_level(c.r) && is_level(c.g) && is_level(c.b); };
  return std::all_of(image.pixels.begin(), image.pixels.end(), all_levels) ? NumberFormat::uint8 : format;
}

class Comparer {
 public:
  Comparer(const Image& image, NumberFormat format, const Reference& reference, const PixelRanges& ranges)
      : image_(image), format_(format), reference_(reference), ranges_(ranges) {}

  Comparison run() {
    result_.knows_decisions = reference_.has_word();
    result_.width = image_.width;
    result_.height = image_.height;
    for (std::size_t k = 0; k < image_.pixels.size(); ++k) judge(k);
    finish_errors();
    result_.densest = densest();
    decide();
    return std::move(result_);
  }

 private:
  /// Where a decision is near, the sensitivity may be that of the decision, and allow any color.
  bool is_near(std::size_t k) const { return reference_.margin[k] <= calibrated.near_margin; }

  /// What a right renderer's rounding may do to the pixel, and the file's to the number: tau in docs/tolerance.md.
  double tolerance(std::size_t k, double value) const {
    return (is_near(k) ? 0 : calibrated.gain * reference_.sensitivity[k]) + calibrated.floor + half_step(format_, value) +
           half_step(reference_.format, value);
  }

  /// How far pixel k lies beyond its range, in its worst channel; 0 within.
  double distance(std::size_t k) const {
    const Color& pixel = image_.pixels[k];
    if (!is_finite(pixel)) return infinity;
    double most = 0;
    for (int channel = 0; channel < 3; ++channel) {
      const double least = ranges_.least.pixels[k][channel], greatest = ranges_.greatest.pixels[k][channel];
      const double tau = tolerance(k, greatest);
      most = std::max({most, least - tau - pixel[channel], pixel[channel] - greatest - tau});
    }
    return most;
  }

  void judge(std::size_t k) {
    const bool number = is_finite(image_.pixels[k]);
    const double beyond = distance(k);
    const bool near = is_near(k);
    const PixelVerdict verdict = beyond == 0      ? PixelVerdict::within
                                 : number && near ? PixelVerdict::at_decision
                                                  : PixelVerdict::outside;
    result_.verdict.push_back(verdict);
    result_.non_finite += number ? 0 : 1;
    result_.at_decision += verdict == PixelVerdict::at_decision ? 1 : 0;
    if (verdict == PixelVerdict::outside) {
      ++result_.outside;
      keep_if_worst(k, beyond);
    }
    result_.error.push_back(number ? add_errors(k, near) : infinity);
  }

  /// Returns the largest of the channels.
  double add_errors(std::size_t k, bool near) {
    const Color off = image_.pixels[k] - ranges_.value.pixels[k];
    const double largest = std::max({std::abs(off.r), std::abs(off.g), std::abs(off.b)});
    const double squared = off.r * off.r + off.g * off.g + off.b * off.b;
    result_.max_error = std::max(result_.max_error, largest);
    sum_ += std::abs(off.r) + std::abs(off.g) + std::abs(off.b);
    sum_of_squares_ += squared;
    sum_at_decisions_ += near ? squared : 0;
    return largest;
  }

  void finish_errors() {
    const auto components = 3 * static_cast<double>(image_.pixels.size() - result_.non_finite);
    if (components == 0) result_.max_error = not_a_number;
    result_.mean_error = sum_ / components;
    result_.rmse = std::sqrt(sum_of_squares_ / components);
    result_.psnr = -20 * std::log10(result_.rmse);
    result_.share_at_decisions = sum_of_squares_ > 0 ? sum_at_decisions_ / sum_of_squares_ : 0;
  }

  /// The most pixels outside in any square, by a table of sums over all rectangles from the top left corner.
  std::size_t densest() const {
    const auto width = static_cast<std::size_t>(image_.width);
    const auto height = static_cast<std::size_t>(image_.height);
    std::vector<std::size_t> sums((width + 1) * (height + 1), 0);
    const auto at = [&](std::size_t column, std::size_t row) -> std::size_t& { return sums[row * (width + 1) + column]; };
    std::size_t most = 0;
    for (std::size_t row = 1; row <= height; ++row)
      for (std::size_t column = 1; column <= width; ++column) {
        const bool outside = result_.verdict[(row - 1) * width + column - 1] == PixelVerdict::outside;
        at(column, row) = at(column - 1, row) + at(column, row - 1) - at(column - 1, row - 1) + (outside ? 1 : 0);
        const std::size_t left = column - std::min<std::size_t>(column, square);
        const std::size_t top = row - std::min<std::size_t>(row, square);
        most = std::max(most, at(column, row) + at(left, top) - at(left, row) - at(column, top));
      }
    return most;
  }

  void decide() {
    result_.allowed = static_cast<std::size_t>(calibrated.outside * static_cast<double>(image_.pixels.size()));
    result_.densest_allowed = std::min(calibrated.densest, result_.allowed);
    const auto share = [](std::size_t found, std::size_t allowed) {
      return found == 0 ? 0.0 : allowed == 0 ? infinity : static_cast<double>(found) / static_cast<double>(allowed);
    };
    result_.score = result_.non_finite > 0
                        ? infinity
                        : std::max(share(result_.outside, result_.allowed), share(result_.densest, result_.densest_allowed));
    result_.same = result_.score <= 1;
  }

  /// The list stays sorted, and short however large the image is.
  void keep_if_worst(std::size_t k, double beyond) {
    std::vector<OutsidePixel>& worst = result_.worst;
    const auto nearer = [](double distance, const OutsidePixel& pixel) { return distance > pixel.distance; };
    const auto place = std::upper_bound(worst.begin(), worst.end(), beyond, nearer);
    if (place == worst.end() && worst.size() == shown) return;
    const int number = static_cast<int>(k);
    worst.insert(place, {number % image_.width, number / image_.width, image_.pixels[k], ranges_.least.pixels[k],
                         ranges_.greatest.pixels[k], beyond});
    if (worst.size() > shown) worst.pop_back();
  }

  const Image& image_;
  const NumberFormat format_;
  const Reference& reference_;
  const PixelRanges& ranges_;
  Comparison result_;
  double sum_ = 0, sum_of_squares_ = 0, sum_at_decisions_ = 0;
};

}  // namespace

Comparison compare(const Image& image, NumberFormat format, const Reference& reference) {
  const NumberFormat steps = effective_format(image, format);
  Comparison together = Comparer(image, steps, reference, reference).run();
  if (together.score == 0 || !reference.each) return together;
  Comparison each = Comparer(image, steps, reference, *reference.each).run();
  each.clamped_each = true;
  return each.score < together.score ? each : together;
}

}  // namespace raylab
