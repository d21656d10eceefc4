#include "bench/report/image_errors.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace raylab::bench {
namespace {

/// Errors of some pixels, as far as they have been added.
struct Errors {
  std::size_t pixels = 0;
  double squares = 0;
  double greatest = 0;

  void add(const Color& error, double most) {
    ++pixels;
    squares += dot(error, error);
    greatest = std::max(greatest, most);
  }

  double rmse() const { return pixels == 0 ? 0 : std::sqrt(squares / (3 * static_cast<double>(pixels))); }
};

}  // namespace

Json image_error(const Image& image, const Image& right) {
  Errors all, rest;
  std::size_t non_finite = 0;
  for (std::size_t k = 0; k < right.pixels.size(); ++k) {
    if (!is_finite(right.pixels[k])) continue;
    const Color error = image.pixels[k] - right.pixels[k];
    if (!is_finite(error)) {
      ++non_finite;
      continue;
    }
    const double most = std::max({std::abs(error.r), std::abs(error.g), std::abs(error.b)});
    all.add(error, most);
    if (most <= flipped_by) rest.add(error, most);
  }
  const std::size_t flipped = all.pixels - rest.pixels;
  const bool few = static_cast<double>(flipped) <= most_flipped * static_cast<double>(all.pixels);
  return {{"rmse", all.rmse()},
          {"max", all.greatest},
          {"psnr", all.squares > 0 ? Json(-20 * std::log10(all.rmse())) : Json()},
          {"flipped", flipped},
          {"non_finite", non_finite},
          {"pixels", all.pixels + non_finite},
          {"rmse_rest", rest.rmse()},
          {"max_rest", rest.greatest},
          {"rmse_judged", few ? rest.rmse() : all.rmse()}};
}

}  // namespace raylab::bench
