#include "core/grade/class_reports.hpp"

#include "core/image/partial_file.hpp"
#include "core/results/class_page.hpp"
#include "core/results/gradebook.hpp"
#include "core/results/junit.hpp"
#include "core/results/student_page.hpp"

#include <ostream>
#include <string>

namespace raylab {
namespace {

namespace fs = std::filesystem;

void write_text(const fs::path& path, const std::string& text) {
  write_file(path, [&](std::ostream& stream) { stream << text; });
}

}  // namespace

ClassResults write_reports(const ClassFolder& folder) {
  const ClassRun run = folder.run();
  const ClassResults results{1, run.raylab, folder.seed(), run.unsafe, run.guarantees, folder.results()};
  const std::vector<RosterEntry> roster = folder.roster();
  for (const SubmissionResult& submission : results.submissions) {
    const fs::path place = folder.submission(submission.id);
    write_text(place / "report.html", student_page(submission, place));
  }
  write_text(folder.path() / "gradebook.csv", gradebook_csv(results, roster));
  write_text(folder.path() / "junit.xml", junit_xml(results));
  write_text(folder.path() / "index.html", class_page(results, roster, folder.seconds()));
  write_text(folder.path() / "results.json", results_json(results));
  return results;
}

}  // namespace raylab
