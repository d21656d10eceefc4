// Writes every report of the sample class, for the scripted tests and for those of the pages: raylab-sample-reports OUT

#include "core/image/partial_file.hpp"
#include "core/results/github.hpp"
#include "core/results/gradebook.hpp"
#include "core/results/gradescope.hpp"
#include "core/results/junit.hpp"
#include "core/results/roster.hpp"
#include "tests/sample_results.hpp"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <ostream>
#include <string>

using namespace raylab;
using namespace raylab::test;

namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) {
  write_file(path, [&](std::ostream& out) { out << text; });
}

void write_reports(const fs::path& out) {
  const ClassResults results = sample_class();
  write(out / "results.json", results_json(results));
  write(out / "junit.xml", junit_xml(results));
  write(out / "gradebook.csv", gradebook_csv(results, sample_roster()));
  write(out / "roster.csv", roster_csv(sample_roster()));
  for (const SubmissionResult& submission : results.submissions) {
    const fs::path folder = out / "submissions" / submission.id.substr(submission.id.find_first_not_of("./"), 10);
    write(folder / "gradescope.json", gradescope_json(submission));
    write(folder / "summary.md", github_summary(submission));
    write(folder / "annotations.txt", github_annotations(submission));
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: raylab-sample-reports OUT\n");
    return 2;
  }
  try {
    write_reports(argv[1]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "raylab-sample-reports: %s\n", error.what());
    return 1;
  }
}
