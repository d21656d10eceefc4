#include "tests/subjects.hpp"

#include "core/image/data_folder.hpp"
#include "core/image/reference_file.hpp"
#include "core/references/manifest.hpp"
#include "core/render/render.hpp"
#include "core/scene/read_scene.hpp"

#include <filesystem>

namespace raylab::test {

std::vector<Subject> load_subjects(bool hard) {
  std::vector<Subject> subjects;
  const std::filesystem::path manifest = data_folder(manifest_file);
  for (const SceneEntry& scene : read_manifest(manifest).scenes) {
    if (is_hard(scene.sources.front().file) != hard) continue;
    const SceneFile file = read_scene(data_folder(scene.sources.front().file));
    for (const ReferenceEntry& entry : scene.references)
      subjects.push_back({scene.name, file.scene.value(), read_reference(manifest.parent_path() / entry.exr.file)});
  }
  return subjects;
}

Image rendered(const Subject& subject, const MakeEngine& make) {
  const Settings settings{subject.reference.stage,
                          {subject.reference.value.width, subject.reference.value.height},
                          subject.world.max_bounces,
                          {}};
  return render_image(*make(subject.world, settings), settings.size, 2);
}

}  // namespace raylab::test
