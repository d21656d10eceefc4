#include "reference/oracle/oracle.hpp"

#include "reference/oracle/rounding.hpp"
#include "reference/oracle/witness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace raylab {
namespace oracle {

std::vector<Object> all_objects(const Scene& scene) {
  std::vector<Object> objects;
  objects.reserve(geometry_count(scene));
  for (const PlaneObject& plane : scene.planes)
    objects.push_back({&plane.shape, nullptr, &plane.material, &plane.material.color});
  for (const SphereObject& sphere : scene.spheres)
    objects.push_back({nullptr, &sphere.shape, &sphere.material, &sphere.material.color});
  for (const SphereCloud& cloud : scene.clouds)
    for (std::size_t i = 0; i < cloud.spheres.size(); ++i)
      objects.push_back(
          {nullptr, &cloud.spheres[i], &cloud.material, cloud.colors.empty() ? &cloud.material.color : &cloud.colors[i]});
  return objects;
}

namespace {

/// Do both colors say the same, to 1e-25? They are clamped already: what lies beyond white need not be known to as many
/// places.
template <class T, class Finer>
bool agree(const Vec3<T>& coarse, const Vec3<Finer>& fine) {
  static const Finer tolerance("1e-25");
  const auto close = [](const T& a, const Finer& b) { return abs(Finer(a) - b) <= tolerance; };
  return close(coarse.x, fine.x) && close(coarse.y, fine.y) && close(coarse.z, fine.z);
}

template <class T>
Color rounded(const Vec3<T>& color) {
  return {color.x.template convert_to<double>(), color.y.template convert_to<double>(),
          color.z.template convert_to<double>()};
}

const Color undecided(std::numeric_limits<double>::quiet_NaN());

std::vector<SampleOffset> samples_of(const Settings& settings) {
  const AntiAliasing by_stage = settings.stage >= 7 ? AntiAliasing::rotated4 : AntiAliasing::none;
  return sample_offsets(settings.aa.value_or(by_stage));
}

struct Place {
  int column;
  int row;
};

/// The scene at every precision, and a pixel of it as its callers want it.
class Pixels {
 public:
  Pixels(const Scene& scene, const Settings& settings)
      : scene_(scene), settings_(settings), objects_(all_objects(scene_)), samples_(samples_of(settings)) {}
  Pixels(const Pixels&) = delete;  // the worlds refer to the rest
  Pixels& operator=(const Pixels&) = delete;

  const Settings& settings() const { return settings_; }

  /// More bits only for the pixels that need them. Counts the rays of the last attempt.
  Color color(const Place& place, RayCounts& counts, const std::atomic<bool>& cancel) const {
    RayCounts counted;
    const std::vector<SampleOffset> samples = samples_at(place, cancel);
    const auto coarse = traced(coarse_, place, samples, false, counted, cancel);
    const auto fine = traced(fine_, place, samples, false, counted, cancel);
    if (agree(coarse, fine)) {
      counts += counted;
      return rounded(fine);
    }
    const auto finest = traced(finest_, place, samples, false, counted, cancel);
    counts += counted;
    return agree(fine, finest) ? rounded(finest) : undecided;
  }

  PixelWord word(const Place& place, RayCounts& counts, const std::atomic<bool>& cancel) const {
    RayCounts counted;
    const std::vector<SampleOffset> samples = samples_at(place, cancel);
    std::optional<PixelWord> word = confirmed_word(coarse_, fine_, place, samples, counted, cancel);
    if (!word) word = confirmed_word(fine_, finest_, place, samples, counted, cancel);
    counts += counted;
    return word.value_or(PixelWord{{undecided, undecided, undecided}, {undecided, undecided, undecided}, 0, 0, no_geometry});
  }

 private:
  /// Those of the pattern that this pixel needs.
  std::vector<SampleOffset> samples_at(const Place& place, const std::atomic<bool>& cancel) const {
    if (settings_.aa != AntiAliasing::adaptive) return samples_;
    std::vector<SampleOffset> samples(samples_.begin(), samples_.begin() + deciding_samples);
    std::vector<Color> colors;
    RayCounts uncounted;
    for (const SampleOffset& sample : samples)
      colors.push_back(rounded(traced(coarse_, place, {sample}, false, uncounted, cancel)));
    return samples_agree(colors) ? samples : samples_;
  }

  template <class T>
  Vec3<T> traced(const World<T>& world, const Place& place, const std::vector<SampleOffset>& samples, bool clamp_each,
                 RayCounts& counted, const std::atomic<bool>& cancel) const {
    counted = {};
    return Tracer<T>(world, counted, cancel, clamp_each).pixel(place.column, place.row, samples);
  }

  /// The word at one precision, if a finer one gives the same colors.
  template <class T, class Finer>
  std::optional<PixelWord> confirmed_word(const World<T>& world, const World<Finer>& finer, const Place& place,
                                          const std::vector<SampleOffset>& samples, RayCounts& counted,
                                          const std::atomic<bool>& cancel) const {
    const Testimony<T> seen = Witness<T>(world, cancel).pixel(place.column, place.row, samples);
    const auto together = traced(finer, place, samples, false, counted, cancel);
    if (!agree(seen.color.value, together)) return {};
    PixelWord word;
    word.together = range(rounded(together), seen.color.value, seen.color.least, seen.color.greatest);
    if (seen.color.each_value == seen.color.value) {
      word.each = range(rounded(together), seen.color.each_value, seen.color.each_least, seen.color.each_greatest);
    } else {
      RayCounts uncounted;
      const auto each = traced(finer, place, samples, true, uncounted, cancel);
      if (!agree(seen.color.each_value, each)) return {};
      word.each = range(rounded(each), seen.color.each_value, seen.color.each_least, seen.color.each_greatest);
    }
    word.margin = seen.margin.template convert_to<double>();
    word.sensitivity = sensitivity(world, place, samples, seen.color.value, cancel);
    word.object = seen.object;
    return word;
  }

  /// Exactly `value` on the side on which there is no variant.
  template <class T>
  static ColorRange range(const Color& value, const Vec3<T>& exact, const Vec3<T>& least, const Vec3<T>& greatest) {
    return {value, value - rounded(exact - least), value + rounded(greatest - exact)};
  }

  template <class T>
  double sensitivity(const World<T>& world, const Place& place, const std::vector<SampleOffset>& samples,
                     const Vec3<T>& exact, const std::atomic<bool>& cancel) const {
    RayCounts uncounted;
    double most = 0;
    for (const auto alter : {round_to_nearest<T>, round_at_random<T, 1>, round_at_random<T, 2>}) {
      Tracer<T> tracer(world, uncounted, cancel, false, alter);
      const Color moved = rounded(tracer.pixel(place.column, place.row, samples) - exact);
      most = std::max({most, std::abs(moved.r), std::abs(moved.g), std::abs(moved.b)});
    }
    return most;
  }

  const Scene scene_;
  const Settings settings_;
  const std::vector<Object> objects_;
  const std::vector<SampleOffset> samples_;
  const World<Coarse> coarse_{scene_, objects_, settings_};
  const World<Fine> fine_{scene_, objects_, settings_};
  const World<Finest> finest_{scene_, objects_, settings_};
};

/// Calls visit(k, place) for the k-th pixel of the rows.
template <class Visit>
void visit_rows(int first_row, std::size_t pixels, int width, const std::atomic<bool>& cancel, Visit visit) {
  const auto across = static_cast<std::size_t>(width);
  for (std::size_t k = 0; k < pixels; ++k) {
    if (cancel.load(std::memory_order_relaxed)) throw Cancelled{};
    visit(k, Place{static_cast<int>(k % across), first_row + static_cast<int>(k / across)});
  }
}

class Oracle : public Engine {
 public:
  Oracle(const Scene& scene, const Settings& settings) : pixels_(scene, settings) {}

  void trace_rows(int first_row, std::span<Color> pixels, RayCounts& counts,
                  const std::atomic<bool>& cancel) const override {
    visit_rows(first_row, pixels.size(), pixels_.settings().size.width, cancel,
               [&](std::size_t k, const Place& place) { pixels[k] = pixels_.color(place, counts, cancel); });
  }

 private:
  const Pixels pixels_;
};

/// Rows never overlap, so threads never write the same word.
class WitnessEngine : public Engine {
 public:
  WitnessEngine(const Scene& scene, const Settings& settings, std::span<PixelWord> words, int every)
      : pixels_(scene, settings), words_(words), every_(every) {}

  void trace_rows(int first_row, std::span<Color> pixels, RayCounts& counts,
                  const std::atomic<bool>& cancel) const override {
    const int width = pixels_.settings().size.width;
    visit_rows(first_row, pixels.size(), width, cancel, [&](std::size_t k, const Place& place) {
      if (!is_sampled(place.column, place.row, every_)) return;
      PixelWord& word = words_[static_cast<std::size_t>(first_row) * static_cast<std::size_t>(width) + k];
      word = pixels_.word(place, counts, cancel);
      pixels[k] = word.together.value;
    });
  }

 private:
  const Pixels pixels_;
  const std::span<PixelWord> words_;
  const int every_;
};

}  // namespace
}  // namespace oracle

std::unique_ptr<Engine> make_oracle(const Scene& scene, const Settings& settings) {
  return std::make_unique<oracle::Oracle>(scene, settings);
}

std::unique_ptr<Engine> make_witness(const Scene& scene, const Settings& settings, std::span<PixelWord> words, int every) {
  return std::make_unique<oracle::WitnessEngine>(scene, settings, words, every);
}

bool is_sampled(int column, int row, int every) { return (column + 7 * row) % every == 0; }

}  // namespace raylab
