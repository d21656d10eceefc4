#pragma once

#include "core/math/fields.hpp"
#include "core/results/results.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace raylab {

/// Processor seconds that grading a submission took, by its id. They stand apart from the results, which are the same on
/// every machine.
using Seconds = std::vector<std::pair<std::string, double>>;

struct VerdictCount {
  Verdict verdict = Verdict::right;
  int count = 0;
};
RAYLAB_FIELDS(VerdictCount, RAYLAB_FIELD(verdict) RAYLAB_FIELD(count))

/// What became of a task in the class.
struct TaskSummary {
  std::string label;
  std::string name;
  int missed = 0;                      ///< submissions that do not have it right
  std::vector<VerdictCount> verdicts;  ///< those that occur, in their order
};
RAYLAB_FIELDS(TaskSummary, RAYLAB_FIELD(label) RAYLAB_FIELD(name) RAYLAB_FIELD(missed) RAYLAB_FIELD(verdicts))

/// A text that several submissions got: the name of a known mistake or of a failed test.
struct TextCount {
  std::string label;  ///< of the task
  std::string text;
  int count = 0;  ///< submissions
};
RAYLAB_FIELDS(TextCount, RAYLAB_FIELD(label) RAYLAB_FIELD(text) RAYLAB_FIELD(count))

struct StageColumn {
  int number = 0;
  std::string name;
  bool bonus = false;
};
RAYLAB_FIELDS(StageColumn, RAYLAB_FIELD(number) RAYLAB_FIELD(name) RAYLAB_FIELD(bonus))

struct SubmissionRow {
  std::string id;
  std::string name;  ///< from the roster; empty if it has none
  Points points;
  Points bonus;
  std::vector<std::optional<Points>> stages;  ///< one for each column, if the submission has the stage
  Verdict worst = Verdict::right;             ///< of its tasks: the last in the order of the verdicts
  std::optional<double> seconds;
  std::vector<std::string> unjudged;  ///< what raylab failed to judge, and why
  std::vector<std::string> notes;
};
RAYLAB_FIELDS(SubmissionRow,
              RAYLAB_FIELD(id) RAYLAB_FIELD(name) RAYLAB_FIELD(points) RAYLAB_FIELD(bonus) RAYLAB_FIELD(stages)
                  RAYLAB_FIELD(worst) RAYLAB_FIELD(seconds) RAYLAB_FIELD(unjudged) RAYLAB_FIELD(notes))

/// A class at a glance. All text is plain_text(), the points are those that count.
struct ClassSummary {
  std::string raylab;
  std::string seed;
  bool unsafe = false;
  std::vector<Guarantee> guarantees;
  std::vector<Verdict> verdicts;  ///< all there are, the worst last
  std::vector<StageColumn> stages;
  std::vector<TaskSummary> tasks;   ///< those missed most first
  std::vector<TextCount> mistakes;  ///< the most frequent first, as the failed tests
  std::vector<TextCount> failed_tests;
  std::vector<SubmissionRow> submissions;
};
RAYLAB_FIELDS(ClassSummary, RAYLAB_FIELD(raylab) RAYLAB_FIELD(seed) RAYLAB_FIELD(unsafe) RAYLAB_FIELD(guarantees)
                                RAYLAB_FIELD(verdicts) RAYLAB_FIELD(stages) RAYLAB_FIELD(tasks) RAYLAB_FIELD(mistakes)
                                    RAYLAB_FIELD(failed_tests) RAYLAB_FIELD(submissions))

ClassSummary summary_of(const ClassResults& results, const std::vector<RosterEntry>& roster, const Seconds& seconds);

}  // namespace raylab
