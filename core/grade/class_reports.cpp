#include "core/grade/class_reports.hpp"

#include "core/image/partial_file.hpp"
#include "core/results/class_page.hpp"
#include "core/results/gradebook.hpp"
#include "core/results/junit.hpp"
#include "core/results/student_page.hpp"

#include <string>

namespace raylab {
namespace fs = std::filesystem;

ClassResults write_reports(const ClassFolder& folder) {
  const ClassRun run = folder.run();
  const ClassResults results{1, run.raylab, folder.seed(), run.unsafe, run.guarantees, folder.results()};
  const std::vector<RosterEntry> roster = folder.roster();
  for (const SubmissionResult& submission : results.submissions) {
    const fs::path place = folder.submission(submission.id);
    write_file(place / "report.html", student_page(submission, place));
  }
  write_file(folder.path() / "gradebook.csv", gradebook_csv(results, roster));
  write_file(folder.path() / "junit.xml", junit_xml(results));
  write_file(folder.path() / "index.html", class_page(results, roster, folder.seconds()));
  write_file(folder.path() / "results.json", results_json(results));
  return results;
}

}  // namespace raylab
