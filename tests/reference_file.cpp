// Files of references: what is read is what was written, to the digits that a file keeps.

#include "core/image/reference_file.hpp"

#include "core/image/diff.hpp"
#include "core/image/image_file.hpp"
#include "tests/sample_reference.hpp"
#include "tests/support.hpp"
#include "tests/temporary_folder.hpp"

#include <fstream>
#include <string>

using namespace raylab;
using namespace raylab::test;

TEST_CASE("reference file: it gives back what was written, in floats", "[reference_file]") {
  const TemporaryFolder folder;
  Reference reference = with_objects();
  for (std::size_t k = 0; k < reference.margin.size(); ++k) {
    reference.margin[k] = std::pow(0.9, static_cast<double>(k % 500));
    reference.sensitivity[k] = 1e-16 * static_cast<double>(k % 77);
    if (k % 9 == 0) reference.least.pixels[k] -= Color(0.01);
  }
  for (const bool with_each : {false, true}) {
    if (with_each)
      reference.each =
          PixelRanges{with_moved(reference.value, 50, 0.1), reference.least, with_moved(reference.value, 50, 0.1)};
    write_reference(folder / "r.exr", reference);
    const Reference read = read_reference(folder / "r.exr");
    CHECK(read.scene == "scene");
    CHECK(read.stage == 5);
    CHECK(read.planes == 1);
    CHECK(read.spheres == 2);
    CHECK(read.object == reference.object);
    CHECK(read.each.has_value() == with_each);
    const Reference stored = as_stored(reference);
    CHECK(read.value.pixels == stored.value.pixels);
    CHECK(read.least.pixels == stored.least.pixels);
    CHECK(read.greatest.pixels == stored.greatest.pixels);
    CHECK(read.margin == stored.margin);
    CHECK(read.sensitivity == stored.sensitivity);
    if (with_each) CHECK(read.each->value.pixels == stored.each->value.pixels);
    for (std::size_t k = 0; k < read.margin.size(); ++k) {
      REQUIRE(read.value.pixels[k] == within(6e-8, reference.value.pixels[k]));
      for (int channel = 0; channel < 3; ++channel) {
        const double below = reference.value.pixels[k][channel] - reference.least.pixels[k][channel];
        const double read_below = read.value.pixels[k][channel] - read.least.pixels[k][channel];
        REQUIRE(read_below >= below - 2e-7);
        REQUIRE(read_below <= below * (1 + 1.0 / 32) + 2e-7);
      }
      REQUIRE(read.margin[k] <= reference.margin[k]);
      REQUIRE(read.margin[k] >= 0.79 * reference.margin[k]);
      REQUIRE(read.sensitivity[k] >= reference.sensitivity[k]);
      REQUIRE(read.sensitivity[k] <= 1.26 * reference.sensitivity[k]);
    }
  }
}

TEST_CASE("reference file: both ways to clamp are read back, up to white", "[reference_file]") {
  const TemporaryFolder folder;
  Reference reference = reference_of(Image(4, 4, Color(0.4)));
  const Image white(4, 4, Color(1));
  reference.each = PixelRanges{white, white, white};
  write_reference(folder / "r.exr", reference);
  CHECK(read_reference(folder / "r.exr").each->value.pixels == white.pixels);
}

TEST_CASE("reference file: a broken one is refused", "[reference_file]") {
  const TemporaryFolder folder;
  const auto patched = [&](const std::string& from, const std::string& to) {
    write_reference(folder / "r.exr", with_objects());
    std::string bytes = bytes_of(folder / "r.exr");
    const std::size_t place = bytes.find(from);
    REQUIRE(place != std::string::npos);
    bytes.replace(place, to.size(), to);
    std::ofstream(folder / "p.exr", std::ios::binary) << bytes;
    return folder / "p.exr";
  };
  CHECK_THROWS_WITH(read_reference(patched("margin", "mardin")), ContainsSubstring("without the channel margin"));
  Reference wrong = with_objects();
  wrong.value.at(3, 3) = Color(1.5);
  write_reference(folder / "w.exr", wrong);
  CHECK_THROWS_WITH(read_reference(folder / "w.exr"), ContainsSubstring("values that no scene gives"));
  wrong = with_objects();
  wrong.margin[7] = 3;
  write_reference(folder / "w.exr", wrong);
  CHECK_THROWS_WITH(read_reference(folder / "w.exr"), ContainsSubstring("values that no scene gives"));
}

TEST_CASE("reference file: any image is a reference that knows its values alone", "[reference_file]") {
  const TemporaryFolder folder;
  write_image(folder / "a.png", smooth_picture());
  const Reference reference = read_reference(folder / "a.png");
  CHECK_FALSE(reference.has_word());
  CHECK(reference.format == NumberFormat::uint8);
  CHECK(compare(smooth_picture(), NumberFormat::float64, reference).same);
}
