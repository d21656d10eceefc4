#include "core/references/other_stage.hpp"

#include "core/image/reference_file.hpp"
#include "core/render/stage_table.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace raylab {
namespace {

/// The image stays the same up to the stage before the next reference.
int last_stage_of(const SceneEntry& scene, std::size_t k) {
  return k + 1 < scene.references.size() ? scene.references[k + 1].stage - 1 : static_cast<int>(stage_list().size());
}

std::string counted_stages(int count) { return count == 1 ? "one stage" : std::to_string(count) + " stages"; }

}  // namespace

std::optional<Finding> find_other_stage(const Image& image, NumberFormat format, const SceneEntry& scene, int stage,
                                        const std::filesystem::path& renders) {
  for (std::size_t k = 0; k < scene.references.size(); ++k) {
    const ReferenceEntry& entry = scene.references[k];
    if (&entry == find_reference(scene, stage)) continue;
    Reference reference;
    try {
      reference = read_reference(renders / entry.exr.file);
    } catch (const std::runtime_error&) {
      continue;  // a missing hint is no reason to give no verdict
    }
    if (reference.value.width != image.width || reference.value.height != image.height) continue;
    if (!compare(image, format, reference).same) continue;
    const int nearest = entry.stage > stage ? entry.stage : std::min(last_stage_of(scene, k), stage - 1);
    const int behind = stage - nearest;
    return Finding{"other-stage",
                   "This is what " + stage_title(nearest) + ", gives: " +
                       (behind > 0 ? counted_stages(behind) + " behind." : counted_stages(-behind) + " ahead.")};
  }
  return {};
}

}  // namespace raylab
