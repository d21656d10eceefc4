#pragma once

#include "core/math/fields.hpp"
#include "core/math/sample.hpp"
#include "core/math/vec3.hpp"
#include "core/scene/scene.hpp"

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace raylab {

/// Where in a pixel the samples lie. `adaptive`: the four of rotated4, and where these disagree the twelve others of grid16,
/// which has those four too.
enum class AntiAliasing { none, grid4, rotated4, grid16, grid64, grid1024, adaptive };

/// What the patterns are called, in order.
inline constexpr std::array<std::pair<std::string_view, AntiAliasing>, 7> aa_patterns{
    {{"none", AntiAliasing::none},
     {"grid4", AntiAliasing::grid4},
     {"rotated4", AntiAliasing::rotated4},
     {"grid16", AntiAliasing::grid16},
     {"grid64", AntiAliasing::grid64},
     {"grid1024", AntiAliasing::grid1024},
     {"adaptive", AntiAliasing::adaptive}}};

/// As RAYLAB_NAMES would write it, from that list.
template <class Visit>
constexpr void for_each_name(AntiAliasing, Visit&& visit) {
  for (const auto& [name, pattern] : aa_patterns) visit(name.data(), pattern);
}

/// The name of a pattern.
std::string_view aa_name(AntiAliasing pattern);

/// The sample places of a pattern, in pixels from the pixel's centre: one in the centre, the centres of n x n equal squares
/// row by row from the top left, or the rotated grid of the handout's section 2.1. Of `adaptive`, all sixteen, the four that
/// decide coming first.
std::vector<SampleOffset> sample_offsets(AntiAliasing pattern);

/// How many samples adaptive takes at most, how many of them decide whether there will be more, and how far apart they may
/// be in any component, clamped to 0..1, if they are to do: eight of the 255 steps of an image.
inline constexpr std::size_t adaptive_samples = 16;
inline constexpr std::size_t deciding_samples = 4;
inline constexpr double agreeing_samples = 1. / 32;

/// Do these samples of a pixel agree, so that adaptive takes no more?
bool samples_agree(std::span<const Color> samples);

/// What to compute of a scene.
struct Settings {
  int stage = 7;                   ///< the last stage that takes part, from 1
  ImageSize size;                  ///< of the image, in place of the scene's
  int max_bounces = 5;             ///< in place of the scene's
  std::optional<AntiAliasing> aa;  ///< nothing: as the stage says, one sample before stage 7, the rotated grid from there
};
RAYLAB_FIELDS(Settings, RAYLAB_FIELD(stage) RAYLAB_FIELD(size) RAYLAB_FIELD(max_bounces) RAYLAB_OPTIONAL_FIELD(aa))

/// How many rays of each kind were traced; one primary ray for each sample.
struct RayCounts {
  std::uint64_t primary = 0;
  std::uint64_t shadow = 0;
  std::uint64_t reflected = 0;
  std::uint64_t refracted = 0;

  RayCounts& operator+=(const RayCounts& other);
};
RAYLAB_FIELDS(RayCounts, RAYLAB_FIELD(primary) RAYLAB_FIELD(shadow) RAYLAB_FIELD(reflected) RAYLAB_FIELD(refracted))

/// How an engine that takes pains to be fast works; without a name of an instruction set, it does not.
struct EngineFacts {
  std::string simd;
  double hierarchy_seconds = 0;       ///< to build the hierarchies over many spheres
  std::size_t hierarchy_spheres = 0;  ///< how many are in them
  std::size_t hierarchy_bytes = 0;    ///< what they take, and the spheres' order, beside the spheres themselves
};

/// Thrown by an engine out of its work when it is asked to stop.
struct Cancelled {};

/// One way to compute images, ready to run: the scene prepared, the settings fixed. All its functions are const and may run
/// in several threads at once; the same row gives the same bits, whatever else runs.
class Engine {
 public:
  virtual ~Engine() = default;

  /// Computes whole rows of the image from `first_row` down, the top row being 0, into `pixels`: row by row from the left,
  /// clamped to 0..1, as many rows as fit (pixels.size() is a multiple of the image's width). Adds to `counts`.
  /// Throws Cancelled within a few milliseconds once `cancel` is set.
  virtual void trace_rows(int first_row, std::span<Color> pixels, RayCounts& counts,
                          const std::atomic<bool>& cancel) const = 0;

  /// How many rows trace_rows() likes to be given at a time.
  virtual int rows_at_once() const { return 1; }

  /// What a user may want to know of how it works.
  virtual EngineFacts facts() const { return {}; }
};

}  // namespace raylab
