// Part of the kernel; kernel/parts.hpp says how the parts are put together.

namespace raylab::fast::RAYLAB_TARGET {

/// The sum of color(element), in pairs, and pairs of pairs: with as many roundings for each as there are levels.
template <class V, class Element, class Color>
Vec3<V> pairwise_sum(std::span<const Element> elements, const Color& color) {
  if (elements.size() == 1) return color(elements[0]);
  const std::size_t half = elements.size() / 2;
  return pairwise_sum<V>(elements.first(half), color) + pairwise_sum<V>(elements.subspan(half), color);
}

/// Samples the pixels of whole rows.
template <class V, Needs needs>
class Sampler {
 public:
  using T = NumberOf<V>;
  using Mask = MaskOf<V>;
  using Index = IndexOf<V>;
  using Tile = fast::RAYLAB_TARGET::Tile<V>;

  Sampler(const Prepared<T>& scene, RayCounts& counts, const std::atomic<bool>& cancel)
      : scene_(scene), counts_(counts), tracer_(scene, counts, cancel) {
    std::array<T, Lanes<V>::count> x, y;
    for (int lane = 0; lane < Lanes<V>::count; ++lane) {
      x[static_cast<std::size_t>(lane)] = static_cast<T>(lane % Tile::width);
      y[static_cast<std::size_t>(lane)] = static_cast<T>(lane / Tile::width);
    }
    tile_x_ = load<V>(x.data());
    tile_y_ = load<V>(y.data());
    all_ = tile_x_ >= V(0);
  }

  /// Whole rows, as Engine::trace_rows says.
  void rows(int first_row, std::span<Color> pixels) {
    if (scene_.samples.size() == 1)  // through the center
      tiles(
          first_row, pixels, [this](V x, V y, Mask lanes) RAYLAB_ATTRIBUTE __attribute__((always_inline)) {
            return primary(x, y, lanes);
          });
    else if (scene_.adaptive)
      tiles(first_row, pixels, [this](V x, V y, Mask lanes) RAYLAB_ATTRIBUTE { return adaptive_pixel(x, y, lanes); });
    else
      tiles(first_row, pixels, [this](V x, V y, Mask lanes) RAYLAB_ATTRIBUTE { return mean_pixel(x, y, lanes); });
  }

 private:
  /// Tile by tile, color(x, y, lanes) being that of the pixels whose centers are at (x, y), not yet clamped. A function of
  /// its own for each way to sample, so that none has to share registers with the others.
  template <class ColorOf>
  [[gnu::noinline]] void tiles(int first_row, std::span<Color> pixels, const ColorOf& color) {
    const int width = scene_.settings.size.width;
    const int height = static_cast<int>(pixels.size() / static_cast<std::size_t>(width));
    for (int row = 0; row < height; row += Tile::height)
      for (int column = 0; column < width; column += Tile::width) {
        const int columns = std::min(Tile::width, width - column), rows = std::min(Tile::height, height - row);
        Color* const corner =
            &pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
        write(color(center_x(column), center_y(first_row + row), inside(columns, rows)), columns, rows, corner);
      }
  }

  /// Of the centers of a tile's pixels, from the image's: halves of whole numbers, exact in any T.
  V center_x(int column) const {
    return V(static_cast<T>(column) + T(0.5) - T(0.5) * static_cast<T>(scene_.settings.size.width)) + tile_x_;
  }
  V center_y(int row) const {
    return V(T(0.5) * static_cast<T>(scene_.settings.size.height) - static_cast<T>(row) - T(0.5)) - tile_y_;
  }

  /// The pixels of a tile that are in the image.
  Mask inside(int columns, int rows) const {
    if (columns == Tile::width && rows == Tile::height) return all_;
    return (tile_x_ < V(static_cast<T>(columns))) & (tile_y_ < V(static_cast<T>(rows)));
  }

  void write(const Vec3<V>& color, int columns, int rows, Color* corner) const {
    std::array<double, 3 * Lanes<V>::count> numbers;
    store_interleaved(clamped(color.x), clamped(color.y), clamped(color.z), numbers.data());
    for (int row = 0; row < rows; ++row, corner += scene_.settings.size.width) {
      static_assert(sizeof(Color) == 3 * sizeof(double));
      const double* const first = &numbers[static_cast<std::size_t>(3 * row * Tile::width)];
      if (columns == Tile::width)
        std::memcpy(static_cast<void*>(corner), first, Tile::width * sizeof(Color));
      else
        std::memcpy(static_cast<void*>(corner), first, static_cast<std::size_t>(columns) * sizeof(Color));
    }
  }

  /// The mean of the samples of the pixels around (x, y).
  RAYLAB_INLINE Vec3<V> mean_pixel(V x, V y, Mask lanes) {
    const std::span<const SampleOffset> samples = scene_.samples;
    const Vec3<V> sum =
        pairwise_sum<V>(samples, [&](const SampleOffset& offset) RAYLAB_ATTRIBUTE { return sample(x, y, offset, lanes); });
    return V(T(1) / static_cast<T>(samples.size())) * sum;
  }

  Vec3<V> sample(V x, V y, const SampleOffset& offset, Mask lanes) {
    return sample(x + V(static_cast<T>(offset.dx)), y + V(static_cast<T>(offset.dy)), lanes);
  }

  /// One of several: they are asked for in several places, which share this one copy of all that is inlined into it.
  [[gnu::noinline]] Vec3<V> sample(V x, V y, Mask lanes) { return primary(x, y, lanes); }

  RAYLAB_INLINE Vec3<V> adaptive_pixel(V x, V y, Mask lanes) {
    Vec3<V> sum = zero<V>(), least_seen = {V(1), V(1), V(1)}, greatest_seen = zero<V>();
    Mask agreed = lanes;
    for (std::size_t k = 0; k < deciding_samples; ++k) {
      const Vec3<V> color = sample(x, y, scene_.samples[k], lanes);
      sum = sum + color;
      const Vec3<V> seen = {clamped(color.x), clamped(color.y), clamped(color.z)};
      least_seen = {least(least_seen.x, seen.x), least(least_seen.y, seen.y), least(least_seen.z, seen.z)};
      greatest_seen = {greatest(greatest_seen.x, seen.x), greatest(greatest_seen.y, seen.y),
                       greatest(greatest_seen.z, seen.z)};
      agreed = agreed & (dot(seen, seen) >= V(0));  // and not NaN
    }
    const Vec3<V> apart = greatest_seen - least_seen;
    const V limit(static_cast<T>(agreeing_samples));
    agreed = agreed & (apart.x <= limit) & (apart.y <= limit) & (apart.z <= limit);
    const Mask more = without(lanes, agreed);
    const Vec3<V> mean = V(T(1) / static_cast<T>(deciding_samples)) * sum;
    if (none(more)) return mean;
    const Vec3<V> refined = V(T(1) / static_cast<T>(scene_.samples.size())) * with_the_rest(x, y, more, sum);
    return select(more, refined, mean);
  }

  /// Adds the samples that did not decide. Pixels that need them are few and far between, so that most lanes of a pack would
  /// be idle: the samples are lined up in new packs instead, pixel by pixel.
  Vec3<V> with_the_rest(V x, V y, Mask pixels, const Vec3<V>& sum) {
    constexpr std::size_t rest = adaptive_samples - deciding_samples, lanes = Lanes<V>::count;
    std::array<T, lanes> x_of, y_of;
    store(x, x_of.data());
    store(y, y_of.data());
    std::array<T, (rest + 1) * lanes> xs{}, ys{};
    std::size_t count = 0;
    for (std::uint32_t left = bits(pixels); left != 0; left &= left - 1)
      for (std::size_t k = deciding_samples; k < scene_.samples.size(); ++k, ++count) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(left));
        xs[count] = x_of[lane] + static_cast<T>(scene_.samples[k].dx);
        ys[count] = y_of[lane] + static_cast<T>(scene_.samples[k].dy);
      }
    std::array<std::array<T, (rest + 1) * lanes>, 3> colors;
    for (std::size_t i = 0; i < count; i += lanes) {
      const std::uint32_t there =
          count - i >= lanes ? static_cast<std::uint32_t>((1ull << lanes) - 1) : (1u << (count - i)) - 1;
      const Vec3<V> color = sample(load<V>(&xs[i]), load<V>(&ys[i]), mask_of<V>(there));
      store(color.x, &colors[0][i]);
      store(color.y, &colors[1][i]);
      store(color.z, &colors[2][i]);
    }
    return {added(sum.x, colors[0], bits(pixels)), added(sum.y, colors[1], bits(pixels)),
            added(sum.z, colors[2], bits(pixels))};
  }

  template <std::size_t most>
  V added(V sum, const std::array<T, most>& numbers, std::uint32_t pixels) const {
    std::array<T, Lanes<V>::count> sums;
    store(sum, sums.data());
    for (std::size_t i = 0; pixels != 0; pixels &= pixels - 1)
      for (std::size_t k = deciding_samples; k < scene_.samples.size(); ++k)
        sums[static_cast<std::size_t>(std::countr_zero(pixels))] += numbers[i++];
    return load<V>(sums.data());
  }

  RAYLAB_INLINE Vec3<V> primary(V x, V y, Mask lanes) {
    counts_.primary += count(lanes);
    const Vec3<V> d = camera_direction(scene_.camera, x, y);
    if (scene_.settings.stage == 1) return V(T(0.5)) * (d + Vec3<V>{V(1), V(1), V(1)});
    return tracer_.color({spread<V>(scene_.camera.position), d, Index(-1), mask_of<V>(0)}, lanes);
  }

  const Prepared<T>& scene_;
  V tile_x_, tile_y_;  // of each lane, in its tile
  Mask all_;
  RayCounts& counts_;
  Tracer<V, needs> tracer_;
};

/// A kernel's entry: see TraceRows. Takes the code that has what the scene needs, and no more.
template <class V>
void trace_rows(const Prepared<NumberOf<V>>& scene, int first_row, std::span<Color> pixels, RayCounts& counts,
                const std::atomic<bool>& cancel) {
  const bool planes = !scene.planes.empty(), bounces = scene.features.mirrors || scene.features.glass;
  if (planes && bounces)
    Sampler<V, Needs{true, true}>(scene, counts, cancel).rows(first_row, pixels);
  else if (planes)
    Sampler<V, Needs{true, false}>(scene, counts, cancel).rows(first_row, pixels);
  else if (bounces)
    Sampler<V, Needs{false, true}>(scene, counts, cancel).rows(first_row, pixels);
  else
    Sampler<V, Needs{false, false}>(scene, counts, cancel).rows(first_row, pixels);
}

}  // namespace raylab::fast::RAYLAB_TARGET
