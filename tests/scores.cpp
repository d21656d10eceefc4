#include "tests/scores.hpp"

#include "core/image/diff.hpp"
#include "core/image/image_file.hpp"

#include <utility>

namespace raylab::test {
namespace {

Image in_8_bits(const Image& image) {
  Image levels = image;
  for (Color& c : levels.pixels) c = Color(quantise(c.r), quantise(c.g), quantise(c.b)) / 255.0;
  return levels;
}

}  // namespace

Scores scores_of(const Subject& subject, const Image& image) {
  return {compare(image, NumberFormat::float32, subject.reference).score,
          compare(in_8_bits(image), NumberFormat::uint8, subject.reference).score};
}

Subjects subjects_by_stage() {
  Subjects subjects;
  for (Subject& subject : load_subjects(false)) subjects[subject.reference.stage].push_back(std::move(subject));
  return subjects;
}

std::string title(const Subject& subject) { return subject.scene + ", stage " + std::to_string(subject.reference.stage); }

}  // namespace raylab::test
