#include "core/results/gradebook.hpp"

#include "core/results/counted.hpp"
#include "core/results/csv.hpp"
#include "core/results/roster.hpp"

#include <algorithm>

namespace raylab {
namespace {

using Cells = std::vector<std::string>;

void add_once(Cells& cells, const std::string& cell) {
  if (std::find(cells.begin(), cells.end(), cell) == cells.end()) cells.push_back(cell);
}

std::string stage_name(const StageResult& stage) { return "stage " + std::to_string(stage.number); }

/// The columns that stages and tasks have in any submission, in the order of their first appearance.
struct Columns {
  Cells stages, tasks;
};

Columns columns_of(const ClassResults& results) {
  Columns columns;
  for (const SubmissionResult& submission : results.submissions)
    for (const StageResult& stage : submission.stages) {
      add_once(columns.stages, stage_name(stage));
      for (const TaskResult& task : stage.tasks) add_once(columns.tasks, task.label);
    }
  return columns;
}

void add_points(Cells& cells, const Points& points) {
  cells.push_back(points_text(points.got));
  cells.push_back(points_text(points.most));
}

std::string stage_points(const SubmissionResult& submission, const std::string& name) {
  for (const StageResult& stage : submission.stages)
    if (stage_name(stage) == name) return points_text(counted(stage).got);
  return "";
}

std::string task_verdict(const SubmissionResult& submission, const std::string& label) {
  for (const StageResult& stage : submission.stages)
    for (const TaskResult& task : stage.tasks)
      if (task.label == label) return in_words(task.verdict);
  return "";
}

Cells head(const Columns& columns) {
  Cells cells{"id", "name", "points", "most points", "bonus", "most bonus", "grade again"};
  cells.insert(cells.end(), columns.stages.begin(), columns.stages.end());
  for (const std::string& label : columns.tasks) cells.push_back(csv_text(label));
  return cells;
}

Cells cells_of(const SubmissionResult& submission, const std::string& name, const Columns& columns) {
  Cells cells{csv_text(submission.id), csv_text(name)};
  add_points(cells, counted_points(submission));
  add_points(cells, counted_bonus(submission));
  cells.push_back(needs_new_run(submission) ? "yes" : "no");
  for (const std::string& stage : columns.stages) cells.push_back(stage_points(submission, stage));
  for (const std::string& label : columns.tasks) cells.push_back(task_verdict(submission, label));
  return cells;
}

}  // namespace

std::string gradebook_csv(const ClassResults& results, const std::vector<RosterEntry>& roster) {
  const Columns columns = columns_of(results);
  std::string csv = csv_line(head(columns));
  for (const SubmissionResult& submission : results.submissions)
    csv += csv_line(cells_of(submission, name_in(roster, submission.id), columns));
  return csv;
}

}  // namespace raylab
