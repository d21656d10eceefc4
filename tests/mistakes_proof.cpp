// Proves of each known mistake that unit tests of its own task fail and none of an earlier task, where they judge one of
// raylab's own tables, and none of any other task where they judge a submission, though tasks that ask the mistaken one give
// wrong answers; that two mistakes in two tasks of a stage fail the tests of both; and that an image of a checked-in scene
// shows the mistake; or, where it is marked so, that no image does, or that nothing does. Exit code 1 if a statement does
// not hold.
//   raylab-mistakes              prints the page docs/mistakes.md: of each mistake, the scene that shows it best
//   raylab-mistakes PAGE         asks the scenes that PAGE names, and fails if PAGE is stale

#include "core/render/stages_engine.hpp"
#include "tests/mistakes/page.hpp"
#include "tests/selection.hpp"
#include "tests/temporary_folder.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

extern "C" const raylab::ExportedTasks* raylab_tasks_solution();

using namespace raylab;
using namespace raylab::test;

namespace {

constexpr std::size_t least_mistakes = 60;

/// Counts the statements that hold, and tells of those that do not.
class Statements {
 public:
  void check(bool holds, const std::string& what) {
    ++(holds ? passed_ : failed_);
    if (!holds) std::cerr << "FAILED: " << what << '\n';
  }
  int report() const {
    std::cerr << passed_ << " passed, " << failed_ << " failed\n";
    return failed_ == 0 ? 0 : 1;
  }

 private:
  std::size_t passed_ = 0, failed_ = 0;
};

/// Which test fails first, for a message.
std::string first_failure(const Totals& totals) { return totals.failures.empty() ? "none" : totals.failures.front(); }

/// Who is judged: one of raylab's own tables, or a submission.
struct Judgement {
  std::string_view of;
  std::string (*tests)(std::string_view task);     ///< what is asked
  std::string (*unharmed)(std::string_view task);  ///< what must not fail, whatever is wrong in the task
  Totals (*run)(const std::string& selection, const StageTable& table, const std::filesystem::path& report);
};

Totals run_as_submission(const std::string& selection, const StageTable& table, const std::filesystem::path& report) {
  const auto images = [&](const Scene& scene, const Settings& settings) { return make_stages(scene, settings, table); };
  return run_tests(selection, table, images, report);
}

const Judgement strict{"raylab's own table", tests_of, tests_before,
                       [](const std::string& selection, const StageTable& table, const std::filesystem::path& report) {
                         return run_tests(selection, table, report);
                       }};
const Judgement of_submissions{"a submission", tests_of_submission, tests_of_submission_besides, run_as_submission};

/// The tests of the mistake's own task, after those of the tasks that it must not harm.
Totals check_unit_tests(const Mistake& mistake, const StageTable& wrong, const Judgement& judgement,
                        Statements& statements) {
  const TemporaryFolder folder;
  const std::string who = full_name(mistake) + ", in " + std::string(judgement.of) + ": ";
  if (const std::string others = judgement.unharmed(mistake.task); !others.empty()) {
    const Totals of_others = judgement.run(others, wrong, folder / "report");
    statements.check(of_others.failed == 0 && of_others.passed > 0,
                     who + "fails a test of another task: " + first_failure(of_others));
  }
  const Totals own = judgement.run(judgement.tests(mistake.task), wrong, folder / "report");
  if (mistake.shows == Shows::nowhere)
    statements.check(own.failed == 0 && own.passed > 0, who + "equivalent, and fails " + first_failure(own));
  else
    statements.check(own.failed > 0, who + "fails no test of its own task");
  return own;
}

/// Is the second mistake, which is put beside right tasks, what a right task answers that asks the first? Right Schlick of
/// the cosine in the glass, say, is what a right 6.3 gets from a 6.2 that takes the cosine in air for it.
bool is_right_on_top_of(const Mistake& first, const Mistake& second) {
  return (first.name == "the inner angle" && second.name == "from inside, the cosine in the glass") ||
         (first.name == "1 - R for R" && second.name == "weights exchanged");
}

/// Of a submission, on top of each known mistake in an earlier task of its stage, which it may ask: the tests of its own
/// task must fail all the same.
void check_second_mistake(const Mistake& mistake, const StageTable& right, Statements& statements) {
  if (mistake.shows == Shows::nowhere) return;
  const TemporaryFolder folder;
  for (const Mistake& first : known_mistakes()) {
    if (stage_of(first.task) != stage_of(mistake.task) || first.task >= mistake.task || is_right_on_top_of(first, mistake))
      continue;
    const StageTable both = with(mistake, with(first, right));
    const Totals own = of_submissions.run(of_submissions.tests(mistake.task), both, folder / "report");
    statements.check(own.failed > 0, full_name(mistake) + ": hidden by " + full_name(first));
  }
}

/// On all scenes of the mistake's own stage and of the last one, where everything has joined.
void check_hidden(const Mistake& mistake, const StageTable& right, const Subjects& subjects, Statements& statements) {
  for (const int stage : std::set{stage_of(mistake.task), subjects.rbegin()->first})
    for (const Subject& subject : subjects.at(stage)) {
      const Evidence image = evidence(mistake, right, subject);
      statements.check(std::max(image.scores.floats, image.scores.bytes) <= 1,
                       full_name(mistake) + ": should not show, and does in " + image.scene);
    }
}

Evidence evidence_in(const std::string& scene, const Mistake& mistake, const StageTable& right, const Subjects& subjects) {
  for (const auto& [stage, list] : subjects)
    for (const Subject& subject : list)
      if (title(subject) == scene) return evidence(mistake, right, subject);
  return {};
}

/// The image that shows the mistake, which is of the scene that the page names, if there is a page.
Evidence check_image(const Mistake& mistake, const StageTable& right, const Subjects& subjects, const std::string& page,
                     Statements& statements) {
  if (mistake.shows == Shows::in_unit_tests || mistake.shows == Shows::nowhere) {
    if (page.empty()) check_hidden(mistake, right, subjects, statements);
    return {};
  }
  const Evidence image = page.empty() ? best_evidence(mistake, right, subjects)
                                      : evidence_in(scenes_in(page)[full_name(mistake)], mistake, right, subjects);
  statements.check(counted(mistake, image.scores) >= least_of_wrong,
                   full_name(mistake) + ": shows in no image enough; best is " + image.scene);
  return image;
}

/// Each task of a stage that has any: an added stage may join without.
void check_all_tasks_have_one(std::span<const Mistake> mistakes, Statements& statements) {
  std::set<std::string> names;
  std::set<std::string_view> tasks;
  std::set<int> stages;
  std::size_t real = 0;
  for (const Mistake& mistake : mistakes) {
    statements.check(names.insert(full_name(mistake)).second, full_name(mistake) + ": is there twice");
    statements.check((mistake.shows == Shows::in_images) == mistake.why.empty(), full_name(mistake) + ": needs its reason");
    if (mistake.shows == Shows::nowhere) continue;
    ++real;
    tasks.insert(mistake.task);
    stages.insert(stage_of(mistake.task));
  }
  for (const TaskInfo& task : task_list())
    statements.check(tasks.contains(task.label) || !stages.contains(stage_of(task.label)),
                     "task " + std::string(task.label) + " has no known mistake");
  statements.check(real >= least_mistakes, "there are only " + std::to_string(real) + " known mistakes");
}

}  // namespace

int main(int argc, char** argv) {
  const std::string page = argc > 1 ? bytes_of(argv[1]) : "";
  if (argc > 1 && page.empty()) {
    std::cerr << argv[1] << ": cannot be read\n";
    return 2;
  }
  const StageTable right = import_tasks(*raylab_tasks_solution());
  const Subjects subjects = subjects_by_stage();
  Statements statements;
  check_all_tasks_have_one(known_mistakes(), statements);

  std::vector<FoundMistake> found;
  for (const Mistake& mistake : known_mistakes()) {
    const StageTable wrong = with(mistake, right);
    check_unit_tests(mistake, wrong, of_submissions, statements);
    check_second_mistake(mistake, right, statements);
    found.push_back({mistake, check_unit_tests(mistake, wrong, strict, statements),
                     check_image(mistake, right, subjects, page, statements)});
  }

  const std::string text = mistakes_page(found);
  if (page.empty())
    std::cout << text;
  else
    statements.check(without_scores(page) == without_scores(text), std::string(argv[1]) + " is stale; make it anew");
  return statements.report();
}
