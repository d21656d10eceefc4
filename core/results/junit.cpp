#include "core/results/junit.hpp"

#include "core/results/counted.hpp"
#include "core/results/plain_text.hpp"

namespace raylab {
namespace {

/// Text of an element or of an attribute: in plain_text() nothing but these has a meaning, and no CDATA section is needed.
std::string escaped(std::string_view text) {
  std::string xml;
  for (const char c : text) {
    switch (c) {
      case '&':
        xml += "&amp;";
        break;
      case '<':
        xml += "&lt;";
        break;
      case '>':
        xml += "&gt;";
        break;
      case '"':
        xml += "&quot;";
        break;
      case '\n':
        xml += "&#10;";
        break;  // a line break as it stands would be a blank in an attribute
      case '\t':
        xml += "&#9;";
        break;
      default:
        xml += c;
    }
  }
  return xml;
}

std::string attribute(const std::string& name, std::string_view value) { return ' ' + name + "=\"" + escaped(value) + '"'; }

struct Counts {
  int tests = 0, failures = 0, errors = 0, skipped = 0;

  Counts& operator+=(const Counts& other) {
    tests += other.tests;
    failures += other.failures;
    errors += other.errors;
    skipped += other.skipped;
    return *this;
  }
};

std::string attributes(const Counts& counts) {
  return attribute("tests", std::to_string(counts.tests)) + attribute("failures", std::to_string(counts.failures)) +
         attribute("errors", std::to_string(counts.errors)) + attribute("skipped", std::to_string(counts.skipped));
}

/// The element that says what a verdict is in JUnit's words; empty for one that passes.
std::string element_of(Verdict verdict) {
  if (verdict == Verdict::right) return "";
  if (verdict == Verdict::wrong) return "failure";
  return verdict == Verdict::not_written ? "skipped" : "error";
}

void count(Counts& counts, Verdict verdict) {
  const std::string element = element_of(verdict);
  ++counts.tests;
  counts.failures += element == "failure";
  counts.errors += element == "error";
  counts.skipped += element == "skipped";
}

std::string details_of(const StageResult& stage, const TaskResult& task) {
  std::string text = task.verdict == Verdict::does_not_compile ? stage.compiler : task.call;
  for (const std::vector<FailedTest>& failed : {task.failed, task.hidden_failed})
    for (const FailedTest& test : failed) text += (text.empty() ? "" : "\n\n") + test.name + '\n' + test.text;
  return text;
}

template <class Part>
std::string test_case(const StageResult& stage, const std::string& name, const Part& part, const std::string& details) {
  const std::string start = "    <testcase" +
                            attribute("classname", "stage " + std::to_string(stage.number) + ' ' + stage.name) +
                            attribute("name", name);
  const std::string element = element_of(part.verdict);
  if (element.empty()) return start + "/>\n";
  // JUnit's schema gives <skipped> a message and nothing else.
  const std::string type = element == "skipped" ? "" : attribute("type", in_words(part.verdict));
  return start + ">\n      <" + element + type +
         attribute("message", part.reason.empty() ? in_words(part.verdict) : part.reason) + '>' + escaped(details) + "</" +
         element + ">\n    </testcase>\n";
}

std::string test_cases(const StageResult& stage, Counts& counts) {
  std::string xml;
  for (const TaskResult& task : stage.tasks) {
    count(counts, task.verdict);
    xml += test_case(stage, task.label + ' ' + task.name, task, details_of(stage, task));
  }
  for (const ImageResult& image : stage.images) {
    count(counts, image.verdict);
    xml += test_case(stage, (image.hidden ? "hidden image " : "image ") + image.scene, image, image.difference);
  }
  return xml;
}

std::string property(const std::string& name, const std::string& value) {
  return "      <property" + attribute("name", name) + attribute("value", value) + "/>\n";
}

std::string test_suite(const SubmissionResult& submission, Counts& all) {
  Counts counts;
  std::string cases;
  for (const StageResult& stage : submission.stages) cases += test_cases(stage, counts);
  all += counts;
  return "  <testsuite" + attribute("name", submission.id) + attributes(counts) + ">\n    <properties>\n" +
         property("points", points_text(counted_points(submission))) +
         property("bonus", points_text(counted_bonus(submission))) + "    </properties>\n" + cases + "  </testsuite>\n";
}

}  // namespace

std::string junit_xml(const ClassResults& results) {
  Counts all;
  std::string suites;
  for (const SubmissionResult& submission : with_plain_text(results.submissions)) suites += test_suite(submission, all);
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + attribute("name", "raylab") + attributes(all) + ">\n" +
         suites + "</testsuites>\n";
}

}  // namespace raylab
