#include "core/results/github.hpp"

#include "core/results/compiler_errors.hpp"
#include "core/results/counted.hpp"
#include "core/results/shown.hpp"

#include <cctype>

namespace raylab {
namespace {

// ---- The summary: HTML in Markdown, where a blank line would end the HTML -------------------------------------------

/// Text inside <code> or <pre>, where GitHub looks for no mentions: every punctuation mark as a reference, which has no
/// meaning in Markdown, in HTML or to the runner.
std::string inert(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80 && std::isalnum(byte) == 0 && c != ' ')
      safe += "&#" + std::to_string(byte) + ';';
    else
      safe += c;
  }
  return safe;
}

std::string code(std::string_view text) { return "<code>" + inert(text) + "</code>"; }

std::string block(std::string_view text) { return "<pre>" + inert(text) + "</pre>\n"; }

std::string fold(const std::string& title, const std::string& body) {
  return "<details><summary>" + title + "</summary>\n" + body + "</details>\n";
}

std::string sign(Verdict verdict) {
  if (verdict == Verdict::right) return "✅ ";
  return verdict == Verdict::not_written ? "⬜ " : verdict == Verdict::infrastructure ? "⚠️ " : "❌ ";
}

std::string verdict_text(Verdict verdict) { return sign(verdict) + in_words(verdict); }

std::string row(const std::string& what, Verdict verdict, const std::string& points) {
  return "<tr><td>" + what + "</td><td>" + verdict_text(verdict) + "</td><td>" + points + "</td></tr>\n";
}

std::string stage_table(const StageResult& stage, const Points& hidden) {
  std::string rows = "<tr><th>Task</th><th>Verdict</th><th>Points</th></tr>\n";
  for (const TaskResult& task : stage.tasks)
    rows += row(code(task.label + ' ' + task.name), task.verdict, points_text(task.points));
  for (const ImageResult& image : stage.images) rows += row("Image " + code(image.scene), image.verdict, "");
  if (hidden.most > 0) rows += "<tr><td>Course's own checks</td><td></td><td>" + points_text(hidden) + "</td></tr>\n";
  return "<table>\n" + rows + "</table>\n";
}

std::string task_details(const TaskResult& task) {
  std::string body = "<p>" + code(task.reason) + "</p>\n";
  if (!task.call.empty()) body += "<p>It was asked:</p>\n" + block(task.call);
  for (const FailedTest& test : task.failed) body += "<p>" + code(test.name) + "</p>\n" + block(test.text);
  if (!task.hint.empty()) body += fold("Hint", block(task.hint));
  return fold(code(task.label + ' ' + task.name) + ": " + in_words(task.verdict), body);
}

std::string image_details(const ImageResult& image) {
  std::string body = "<p>" + code(image.reason) + "</p>\n";
  if (!image.difference.empty()) body += "<p>The first call that is answered differently:</p>\n" + block(image.difference);
  return fold("Image " + code(image.scene) + ": " + in_words(image.verdict), body);
}

std::string stage_details(const StageResult& stage) {
  std::string text;
  if (!stage.compiler.empty()) text += fold("What the compiler says", block(stage.compiler));
  for (const TaskResult& task : stage.tasks)
    if (task.verdict != Verdict::right) text += task_details(task);
  for (const ImageResult& image : stage.images)
    if (image.verdict != Verdict::right) text += image_details(image);
  return text;
}

std::string stage_summary(const StageResult& stage, const Points& hidden, std::size_t room) {
  const std::string head = "<h3>Stage " + std::to_string(stage.number) + ": " + code(stage.name) +
                           (stage.bonus ? ", bonus" : "") + " (" + points_text(stage.points) + ")</h3>\n";
  const std::string details = stage_details(stage);
  return head + stage_table(stage, hidden) +
         (details.size() <= room ? details : "<p>What is wrong is too long to be shown here: see the report.</p>\n");
}

// ---- The annotations ------------------------------------------------------------------------------------------------

std::string percent_encoded(std::string_view text, std::string_view characters) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string safe;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (characters.find(c) == characters.npos)
      safe += c;
    else
      (safe += '%') += {digits[byte >> 4U], digits[byte & 15U]};
  }
  return safe;
}

// What GitHub's own toolkit encodes.
std::string data(std::string_view text) { return percent_encoded(text, "%\r\n"); }
std::string property(std::string_view text) { return percent_encoded(text, "%\r\n:,"); }

std::string command(const std::string& level, const std::string& file, const std::string& place, std::string_view title,
                    std::string_view text) {
  std::string properties = "title=" + property(title);
  if (!file.empty()) properties = "file=" + property(file) + place + ',' + properties;
  return "::" + level + ' ' + properties + "::" + data(text) + '\n';
}

std::string level_of(Verdict verdict) {
  return verdict == Verdict::not_written || verdict == Verdict::infrastructure ? "warning" : "error";
}

template <class Part>
std::string part_annotation(const StageResult& stage, const std::string& name, const Part& part) {
  if (part.verdict == Verdict::right) return "";
  return command(level_of(part.verdict), stage.file, "", name + ": " + in_words(part.verdict),
                 part.reason.empty() ? in_words(part.verdict) : part.reason);
}

/// Of a file that does not compile, its errors instead of all that follows from them.
std::string compiler_annotations(const StageResult& stage) {
  std::string commands;
  for (const CompilerError& error : compiler_errors(stage.compiler, stage.file))
    commands += command("error", stage.file, ",line=" + std::to_string(error.line) + ",col=" + std::to_string(error.column),
                        "does not compile", error.text);
  return commands;
}

std::string stage_annotations(const StageResult& stage) {
  if (const std::string errors = compiler_annotations(stage); !errors.empty()) return errors;
  std::string commands;
  for (const TaskResult& task : stage.tasks) commands += part_annotation(stage, task.label + ' ' + task.name, task);
  for (const ImageResult& image : stage.images) commands += part_annotation(stage, "image " + image.scene, image);
  return commands;
}

}  // namespace

std::string github_summary(const SubmissionResult& submission) {
  constexpr std::size_t most_bytes = 900'000;  // GitHub takes a mebibyte
  const SubmissionResult shown = shown_to_student(submission);
  std::string text = "<h2>" + points_text(shown.points) + " points";
  if (shown.bonus.most > 0) text += ", bonus " + points_text(shown.bonus);
  text += "</h2>\n";
  if (needs_new_run(submission)) text += "<p>⚠️ " + std::string(new_run_note) + "</p>\n";
  for (std::size_t i = 0; i < shown.stages.size(); ++i) {
    const std::size_t room = most_bytes - std::min(text.size(), most_bytes);
    text += stage_summary(shown.stages[i], hidden_points(submission.stages[i]), room);
  }
  return text;
}

std::string github_annotations(const SubmissionResult& submission) {
  std::string commands;
  for (const StageResult& stage : shown_to_student(submission).stages) commands += stage_annotations(stage);
  return commands;
}

}  // namespace raylab
