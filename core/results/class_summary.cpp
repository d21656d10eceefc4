#include "core/results/class_summary.hpp"

#include "core/results/counted.hpp"
#include "core/results/plain_text.hpp"
#include "core/results/roster.hpp"

#include <algorithm>

namespace raylab {
namespace {

/// The first of a list that `is` holds for; a new one, `made`, if there is none.
template <class T, class Is>
T& find_or_add(std::vector<T>& list, Is is, const T& made) {
  const auto found = std::find_if(list.begin(), list.end(), is);
  return found == list.end() ? list.emplace_back(made) : *found;
}

void count(std::vector<VerdictCount>& verdicts, Verdict verdict) {
  const auto is = [&](const VerdictCount& entry) { return entry.verdict == verdict; };
  ++find_or_add(verdicts, is, VerdictCount{verdict, 0}).count;
}

void count(std::vector<TaskSummary>& tasks, const TaskResult& task) {
  const auto is = [&](const TaskSummary& entry) { return entry.label == task.label; };
  TaskSummary& entry = find_or_add(tasks, is, TaskSummary{task.label, task.name, 0, {}});
  entry.missed += task.verdict != Verdict::right;
  count(entry.verdicts, task.verdict);
}

void count(std::vector<TextCount>& texts, const std::string& label, const std::string& text) {
  if (text.empty()) return;
  const auto is = [&](const TextCount& entry) { return entry.label == label && entry.text == text; };
  ++find_or_add(texts, is, TextCount{label, text, 0}).count;
}

void count(ClassSummary& summary, const TaskResult& task) {
  count(summary.tasks, task);
  count(summary.mistakes, task.label, task.mistake);
  for (const FailedTest& test : task.failed) count(summary.failed_tests, task.label, test.name);
  for (const FailedTest& test : task.hidden_failed) count(summary.failed_tests, task.label, test.name);
}

void count(ClassSummary& summary, const StageResult& stage) {
  const auto is = [&](const StageColumn& column) { return column.number == stage.number; };
  find_or_add(summary.stages, is, StageColumn{stage.number, stage.name, stage.bonus});
  for (const TaskResult& task : stage.tasks) count(summary, task);
}

template <class Count, class By>
void sort_most_first(std::vector<Count>& counts, By by) {
  std::stable_sort(counts.begin(), counts.end(), [&](const Count& a, const Count& b) { return a.*by > b.*by; });
}

void sort(ClassSummary& summary) {
  std::sort(summary.stages.begin(), summary.stages.end(),
            [](const StageColumn& a, const StageColumn& b) { return a.number < b.number; });
  sort_most_first(summary.tasks, &TaskSummary::missed);
  sort_most_first(summary.mistakes, &TextCount::count);
  sort_most_first(summary.failed_tests, &TextCount::count);
  for (TaskSummary& task : summary.tasks)
    std::sort(task.verdicts.begin(), task.verdicts.end(),
              [](const VerdictCount& a, const VerdictCount& b) { return a.verdict < b.verdict; });
}

std::optional<Points> points_in(const SubmissionResult& submission, int stage_number) {
  for (const StageResult& stage : submission.stages)
    if (stage.number == stage_number) return counted(stage);
  return {};
}

std::optional<double> seconds_of(const Seconds& seconds, const std::string& id) {
  const auto found = std::find_if(seconds.begin(), seconds.end(), [&](const auto& entry) { return entry.first == id; });
  return found == seconds.end() ? std::nullopt : std::optional(found->second);
}

std::vector<std::string> unjudged_in(const SubmissionResult& submission) {
  std::vector<std::string> texts;
  const auto add = [&](Verdict verdict, const std::string& what, const std::string& reason) {
    if (verdict == Verdict::infrastructure) texts.push_back(what + (reason.empty() ? "" : ": " + reason));
  };
  for (const StageResult& stage : submission.stages) {
    for (const TaskResult& task : stage.tasks) add(task.verdict, task.label + ' ' + task.name, task.reason);
    for (const ImageResult& image : stage.images)
      add(image.verdict, "stage " + std::to_string(stage.number) + ", " + image.scene, image.reason);
  }
  return texts;
}

Verdict worst_in(const SubmissionResult& submission) {
  Verdict worst = Verdict::right;
  for (const StageResult& stage : submission.stages)
    for (const TaskResult& task : stage.tasks) worst = std::max(worst, task.verdict);
  return worst;
}

SubmissionRow row_of(const SubmissionResult& submission, const std::vector<StageColumn>& columns) {
  SubmissionRow row;
  row.id = submission.id;
  row.points = counted_points(submission);
  row.bonus = counted_bonus(submission);
  for (const StageColumn& column : columns) row.stages.push_back(points_in(submission, column.number));
  row.worst = worst_in(submission);
  row.unjudged = unjudged_in(submission);
  row.notes = submission.notes;
  return row;
}

}  // namespace

ClassSummary summary_of(const ClassResults& results, const std::vector<RosterEntry>& roster, const Seconds& seconds) {
  const ClassResults plain = with_plain_text(results);
  ClassSummary summary{plain.raylab, plain.seed, plain.unsafe, plain.guarantees, {}, {}, {}, {}, {}, {}};
  for_each_name(Verdict{}, [&](const char*, Verdict verdict) { summary.verdicts.push_back(verdict); });
  for (const SubmissionResult& submission : plain.submissions)
    for (const StageResult& stage : submission.stages) count(summary, stage);
  sort(summary);
  for (std::size_t i = 0; i < plain.submissions.size(); ++i) {
    SubmissionRow& row = summary.submissions.emplace_back(row_of(plain.submissions[i], summary.stages));
    const std::string& id = results.submissions[i].id;  // as it stands in the other lists
    row.name = name_in(roster, id);
    row.seconds = seconds_of(seconds, id);
  }
  return summary;
}

}  // namespace raylab
