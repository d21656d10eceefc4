#include "core/results/gradescope.hpp"

#include "core/results/counted.hpp"
#include "core/results/plain_text.hpp"

#include <nlohmann/json.hpp>

// The format: gradescope-autograders.readthedocs.io/en/latest/specs. A submission's score is the sum of its tests' scores,
// as long as no score stands at the top; `max_score` only decides what is shown and what passes. So points of a bonus stage
// are extra credit as they stand, if the assignment's points in Gradescope are set to the most without bonus; a max_score of
// 0 would only show them as "2 / 0". Status is always given, since a published image has no points to tell it by.

namespace raylab {
namespace {

using Json = nlohmann::ordered_json;

std::string dumped(const Json& json) { return json.dump(2) + '\n'; }

Json entry(const std::string& number, const std::string& name, bool passed, bool hidden, const std::string& output) {
  return {{"number", number},
          {"name", name},
          {"status", passed ? "passed" : "failed"},
          {"output", output},
          {"output_format", "text"},
          {"visibility", hidden ? "hidden" : "visible"}};
}

Json with_points(Json test, const Points& points) {
  test["score"] = points.got;
  test["max_score"] = points.most;
  return test;
}

/// What costs no mark does not look like a failure.
bool passes(Verdict verdict) { return verdict == Verdict::right || verdict == Verdict::infrastructure; }

void add_paragraph(std::string& text, const std::string& title, const std::string& paragraph) {
  if (paragraph.empty()) return;
  if (!text.empty()) text += "\n\n";
  text += title + paragraph;
}

/// The verdict, and why.
template <class Part>
std::string output_of(const Part& part) {
  std::string text = in_words(part.verdict);
  if (!part.reason.empty()) text += ": " + part.reason;
  if (part.verdict == Verdict::infrastructure) text += '\n' + std::string(new_run_note);
  return text;
}

void add_tests(std::string& text, const std::vector<FailedTest>& failed) {
  for (const FailedTest& test : failed) add_paragraph(text, "Failed: " + test.name + '\n', test.text);
}

std::string name_of(const StageResult& stage, const std::string& name) { return name + (stage.bonus ? " (bonus)" : ""); }

Json task_entry(const StageResult& stage, const TaskResult& task) {
  std::string output = output_of(task);
  if (&task == &stage.tasks.front()) add_paragraph(output, "The compiler says:\n", stage.compiler);
  add_paragraph(output, "It was asked:\n", task.call);
  add_tests(output, task.failed);
  add_paragraph(output, "Hint:\n", task.hint);
  return with_points(entry(task.label, name_of(stage, task.name), passes(task.verdict), false, output), counted(task));
}

/// Without points: those of the task are given with all its tests in mind.
Json hidden_tests_entry(const TaskResult& task) {
  std::string output =
      std::to_string(task.hidden_passed) + " passed, " + std::to_string(task.hidden_failed.size()) + " failed";
  add_tests(output, task.hidden_failed);
  return entry(task.label, task.name + ", the course's own tests", task.hidden_failed.empty(), true, output);
}

Json image_entry(const StageResult& stage, const ImageResult& image) {
  std::string output = output_of(image);
  add_paragraph(output, "The first call that is answered differently:\n", image.difference);
  const std::string name = (image.hidden ? "the course's own image, " : "image, ") + image.scene;
  return with_points(entry(std::to_string(stage.number), name_of(stage, name), passes(image.verdict), image.hidden, output),
                     counted(image));
}

void add_entries(Json& tests, const StageResult& stage) {
  for (const TaskResult& task : stage.tasks) {
    tests.push_back(task_entry(stage, task));
    if (task.hidden_passed > 0 || !task.hidden_failed.empty()) tests.push_back(hidden_tests_entry(task));
  }
  for (const ImageResult& image : stage.images) tests.push_back(image_entry(stage, image));
}

}  // namespace

std::string gradescope_json(const SubmissionResult& submission) {
  const SubmissionResult plain = with_plain_text(submission);
  const bool again = needs_new_run(plain);
  Json tests = Json::array();
  for (const StageResult& stage : plain.stages) add_entries(tests, stage);
  return dumped({{"output", again ? new_run_note : ""},
                 {"output_format", "text"},
                 {"stdout_visibility", "hidden"},
                 {"extra_data", {{"id", plain.id}, {"needs_new_run", again}, {"notes", plain.notes}}},
                 {"tests", tests}});
}

std::string gradescope_failure(std::string_view text) {
  return dumped({{"score", 0.0}, {"output", plain_text(text)}, {"output_format", "text"}, {"tests", Json::array()}});
}

}  // namespace raylab
