// Writes every report of the sample class, for the scripted tests and for those of the pages: raylab-sample-reports SOURCES
// OUT

#include "core/image/diff.hpp"
#include "core/image/diff_pictures.hpp"
#include "core/image/image_file.hpp"
#include "core/image/partial_file.hpp"
#include "core/results/class_page.hpp"
#include "core/results/github.hpp"
#include "core/results/gradebook.hpp"
#include "core/results/gradescope.hpp"
#include "core/results/junit.hpp"
#include "core/results/roster.hpp"
#include "core/results/student_page.hpp"
#include "tests/sample_results.hpp"

#include <cctype>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

using namespace raylab;
using namespace raylab::test;

namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) {
  write_file(path, [&](std::ostream& out) { out << text; });
}

/// The heat map of two images of one size.
Image heat_map_of(const Image& image, const Image& reference) {
  Reference expected{{reference, reference, reference},
                     {},
                     std::vector<double>(image.pixels.size(), 1.0),
                     std::vector<double>(image.pixels.size(), 0.0),
                     std::vector<GeometryId>(image.pixels.size(), no_geometry)};
  return heat_map(compare(image, NumberFormat::uint8, expected));
}

/// The images that the sample's stages name: a stage's reference, and in its place that of the stage before.
void write_images(const fs::path& renders, const fs::path& folder) {
  const struct {
    std::string stage, before, at, scene;
  } all[] = {{"04", "03_blinn_phong", "04_shadows", "scene2"},
             {"05", "04_shadows", "05_reflections", "scene3"},
             {"06", "05_reflections", "06_refraction", "scene4"}};
  for (const auto& [stage, before, at, scene] : all) {
    const Image image = read_image(renders / before / (scene + ".png")).image;
    const Image reference = read_image(renders / at / (scene + ".png")).image;
    write_image(folder / (stage + "_image.png"), image);
    write_image(folder / (stage + "_reference.png"), reference);
    write_image(folder / (stage + "_heat.png"), heat_map_of(image, reference));
  }
}

/// A folder's name for an id, hostile or not.
std::string folder_name(const std::string& id) {
  std::string name;
  for (const char c : id)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) name += c;
  return name;
}

ClassResults unsafe(ClassResults results) {
  results.unsafe = true;
  results.guarantees.clear();
  return results;
}

void write_reports(const fs::path& renders, const fs::path& out) {
  const ClassResults results = sample_class();
  write(out / "results.json", results_json(results));
  write(out / "junit.xml", junit_xml(results));
  write(out / "gradebook.csv", gradebook_csv(results, sample_roster()));
  write(out / "roster.csv", roster_csv(sample_roster()));
  write(out / "index.html", class_page(results, sample_roster(), sample_seconds()));
  write(out / "unsafe.html", class_page(unsafe(results), sample_roster(), {}));
  for (const SubmissionResult& submission : results.submissions) {
    const fs::path folder = out / "submissions" / folder_name(submission.id);
    write_images(renders, folder / "images");
    write(folder / "report.html", student_page(submission, folder));
    write(folder / "gradescope.json", gradescope_json(submission));
    write(folder / "summary.md", github_summary(submission));
    write(folder / "annotations.txt", github_annotations(submission));
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: raylab-sample-reports SOURCES OUT\n");
    return 2;
  }
  try {
    write_reports(fs::path(argv[1]) / "reference" / "renders", argv[2]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "raylab-sample-reports: %s\n", error.what());
    return 1;
  }
}
