// The reports of grading: that each says what the results say, tells students nothing of the course's own tests, and lets
// nothing through that a submission wrote.

#include "core/results/results.hpp"

#include "core/image/base64.hpp"
#include "core/image/data_folder.hpp"
#include "core/results/class_page.hpp"
#include "core/results/class_summary.hpp"
#include "core/results/compiler_errors.hpp"
#include "core/results/counted.hpp"
#include "core/results/csv.hpp"
#include "core/results/github.hpp"
#include "core/results/gradebook.hpp"
#include "core/results/gradescope.hpp"
#include "core/results/junit.hpp"
#include "core/results/plain_text.hpp"
#include "core/results/roster.hpp"
#include "core/results/shown.hpp"
#include "core/results/student_page.hpp"
#include "tests/catch.hpp"
#include "tests/sample_results.hpp"
#include "tests/temporary_folder.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

using namespace raylab;
using namespace raylab::test;

namespace {

using Json = nlohmann::ordered_json;

SubmissionResult sample(Sample which) { return sample_class().submissions[which]; }

bool contains(std::string_view text, std::string_view part) { return text.find(part) != text.npos; }

/// Is there anything in `text` that no report may hold: control characters, marks of direction, bytes that are no UTF-8?
bool is_plain(const std::string& text) { return plain_text(text) == text; }

}  // namespace

// ---- What all reports share -----------------------------------------------------------------------------------------

TEST_CASE("results: results.json reads back to the same", "[results]") {
  const ClassResults results = with_plain_text(sample_class());
  CHECK(results_json(parse_results(results_json(results))) == results_json(results));
  CHECK_THROWS_AS(parse_results("{}"), InputError);
}

TEST_CASE("results: plain text shows what is not plain, and keeps the rest", "[results]") {
  CHECK(plain_text("a\r\nb\tc\n") == "a\nb\tc\n");
  CHECK(plain_text("\x1b[31m\r\x7f") == "\\x1b[31m\\x0d\\x7f");
  CHECK(plain_text("\xff caf\xc3\xa9 \xd8\xa3 \xf0\x9f\x8e\x88") == "\\xff caf\xc3\xa9 \xd8\xa3 \xf0\x9f\x8e\x88");
  CHECK(plain_text("\xe2\x80\xae\xe2\x81\xa6\xc2\x85\xef\xbf\xbf") == "\\u202e\\u2066\\u0085\\uffff");
  CHECK(plain_line("a\r\nb\tc") == "a\\x0d\\x0ab\\x09c");
  CHECK(is_plain(plain_text(hostile)));
  CHECK_FALSE(is_plain(std::string(hostile)));
}

TEST_CASE("results: what raylab failed to judge costs no mark", "[results]") {
  const SubmissionResult submission = sample(raylab_failed);
  CHECK(submission.points.got == 2);
  CHECK(points_text(counted_points(submission)) == "7 of 8");
  CHECK(points_text(counted_bonus(submission)) == "5 of 5");
  CHECK(points_text(counted(submission.stages[1])) == "5 of 5");
  CHECK(needs_new_run(submission));
  CHECK(needs_new_run(submission.stages[1]));
  CHECK_FALSE(needs_new_run(submission.stages[0]));
  CHECK_FALSE(needs_new_run(sample(breaks)));
}

TEST_CASE("results: points that are given already are not given twice, and none is NaN", "[results]") {
  SubmissionResult submission = sample(raylab_failed);
  const Points once = counted_points(submission);
  const SubmissionResult shown = shown_to_student(submission);
  CHECK(counted_points(shown).got == once.got);
  submission.points.got = std::numeric_limits<double>::quiet_NaN();
  submission.bonus.most = std::numeric_limits<double>::infinity();
  CHECK(points_text(counted_points(submission)) == "5 of 8");
  CHECK(points_text(counted_bonus(submission)) == "5 of 0");
}

TEST_CASE("results: points are written to a thousandth", "[results]") {
  CHECK(points_text(2.0 / 3) == "0.667");
  CHECK(points_text(0.1 + 0.2) == "0.3");
  CHECK(points_text(12) == "12");
}

TEST_CASE("results: a student is shown nothing of the course's own tests, but points", "[results]") {
  for (const SubmissionResult& submission : sample_class().submissions)
    CHECK_FALSE(contains(to_json(shown_to_student(submission)), secret));
  CHECK(points_text(hidden_points(sample(mistakes).stages[1])) == "0.5 of 2");
  CHECK(points_text(hidden_points(sample(raylab_failed).stages[1])) == "2 of 2");
}

// ---- Gradescope -----------------------------------------------------------------------------------------------------

namespace {

/// The sum of the scores, as Gradescope makes it.
Points gradescope_sum(const Json& json) {
  Points sum;
  for (const Json& test : json["tests"])
    if (test.contains("score")) sum += {test["score"].get<double>(), test["max_score"].get<double>()};
  return sum;
}

}  // namespace

TEST_CASE("gradescope: the scores add up to points and bonus, and stand in the tests alone", "[results]") {
  for (const SubmissionResult& submission : sample_class().submissions) {
    const Json json = Json::parse(gradescope_json(submission));
    CHECK_FALSE(json.contains("score"));
    Points expected = counted_points(submission);
    expected += counted_bonus(submission);
    CHECK(points_text(gradescope_sum(json)) == points_text(expected));
  }
}

TEST_CASE("gradescope: each entry says all that the format has, and hides what is the course's own", "[results]") {
  for (const SubmissionResult& submission : sample_class().submissions) {
    const Json json = Json::parse(gradescope_json(submission));
    CHECK_FALSE(contains(json["output"].get<std::string>(), secret));
    for (const Json& test : json["tests"]) {
      CHECK((test["status"] == "passed" || test["status"] == "failed"));
      CHECK(test["output_format"] == "text");
      const bool own = contains(test["name"].get<std::string>(), "the course's own");
      CHECK(test["visibility"] == (own ? "hidden" : "visible"));
      if (!own) CHECK_FALSE(contains(test.dump(), secret));
      CHECK(is_plain(test["output"].get<std::string>()));
    }
  }
}

TEST_CASE("gradescope: names and numbers tell the entries apart", "[results]") {
  const Json tests = Json::parse(gradescope_json(sample(mistakes)))["tests"];
  const auto at = [&](const std::string& number, const std::string& name) {
    return std::find_if(tests.begin(), tests.end(),
                        [&](const Json& t) { return t["number"] == number && t["name"] == name; });
  };
  REQUIRE(at("5.1", "reflect") != tests.end());
  CHECK((*at("5.1", "reflect"))["status"] == "failed");
  CHECK(contains((*at("5.1", "reflect"))["output"].get<std::string>(), "got       (0.6, 2.4, 0)"));
  CHECK(contains((*at("5.1", "reflect"))["output"].get<std::string>(), "unused variable"));
  REQUIRE(at("5.1", "reflect, the course's own tests") != tests.end());
  CHECK_FALSE((*at("5.1", "reflect, the course's own tests")).contains("score"));
  CHECK((*at("5", "image, scene3"))["max_score"] == 0);
  CHECK((*at("6.2", "schlick (bonus)"))["max_score"] == 1);
}

TEST_CASE("gradescope: what raylab failed to judge says so, and looks like no failure", "[results]") {
  const Json json = Json::parse(gradescope_json(sample(raylab_failed)));
  CHECK(json["output"] == new_run_note);
  CHECK(json["extra_data"]["needs_new_run"] == true);
  const Json& reflect = json["tests"][3];
  CHECK(reflect["number"] == "5.1");
  CHECK(reflect["status"] == "passed");
  CHECK(contains(reflect["output"].get<std::string>(), new_run_note));
}

TEST_CASE("gradescope: there is a valid file with no points for when grading fails", "[results]") {
  const Json json = Json::parse(gradescope_failure(hostile));
  CHECK(json["score"] == 0);
  CHECK(is_plain(json["output"].get<std::string>()));
}

// ---- JUnit ----------------------------------------------------------------------------------------------------------

namespace {

std::size_t occurrences(std::string_view text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

ClassResults class_of(SubmissionResult submission) {
  ClassResults results;
  results.submissions = {std::move(submission)};
  return results;
}

}  // namespace

TEST_CASE("junit: a suite for each submission, a case for each task and image", "[results]") {
  const std::string xml = junit_xml(sample_class());
  CHECK(occurrences(xml, "<testsuite ") == 6);
  CHECK(occurrences(xml, "<testcase ") == 6 * 13);
  CHECK(contains(xml, R"(<testsuites name="raylab" tests="78")"));
}

TEST_CASE("junit: failures, errors and what is not written are told apart, and counted", "[results]") {
  const auto counts = [](Sample which) { return junit_xml(class_of(sample(which))); };
  CHECK(contains(counts(all_right), R"(tests="13" failures="0" errors="0" skipped="0")"));
  CHECK(contains(counts(mistakes), R"(tests="13" failures="4" errors="0" skipped="5")"));
  CHECK(contains(counts(breaks), R"(tests="13" failures="0" errors="13" skipped="0")"));
  CHECK(contains(counts(raylab_failed), R"(tests="13" failures="1" errors="5" skipped="0")"));
  CHECK(occurrences(counts(mistakes), "<failure type=\"wrong\"") == 4);
  CHECK(occurrences(counts(mistakes), "<skipped message=") == 5);
  for (const std::string type : {"crashed", "too slow", "out of memory", "refused", "does not compile"})
    CHECK(contains(counts(breaks), "<error type=\"" + type + '"'));
  CHECK(contains(counts(raylab_failed), "<error type=\"infrastructure\""));
}

TEST_CASE("junit: no text ends what it stands in", "[results]") {
  const std::string xml = junit_xml(class_of(sample(hostile_text)));
  CHECK(is_plain(xml));
  CHECK_FALSE(contains(xml, "<script"));
  CHECK_FALSE(contains(xml, "]]>"));
  CHECK(contains(xml, "]]&gt; &lt;/script&gt;"));
}

// ---- GitHub ---------------------------------------------------------------------------------------------------------

TEST_CASE("github: the summary has a table a stage, and folds for what is wrong", "[results]") {
  const std::string text = github_summary(sample(mistakes));
  CHECK(occurrences(text, "<table>") == 3);
  CHECK(contains(text, "5 of 8 points, bonus 0 of 5"));
  CHECK(contains(text, "<tr><td>Course's own checks</td><td></td><td>0.5 of 2</td></tr>"));
  CHECK(contains(text, "got       &#40;0&#46;6&#44; 2&#46;4&#44; 0&#41;"));
  CHECK(contains(github_summary(sample(raylab_failed)), new_run_note));
  CHECK_FALSE(contains(text, new_run_note));
}

TEST_CASE("github: nothing of a submission's text has a meaning in the summary", "[results]") {
  const std::string text = github_summary(sample(hostile_text));
  CHECK(is_plain(text));
  for (const std::string_view bad : {"::", "@", "<script", "<img", "`", "**", "http:", "\n\n", "# heading", "|", "<!--"})
    CHECK_FALSE(contains(text, bad));
  CHECK(contains(text, "reversed"));
}

TEST_CASE("github: neither summary nor annotations tell of the course's own tests", "[results]") {
  for (const SubmissionResult& submission : sample_class().submissions) {
    CHECK_FALSE(contains(github_summary(submission), "SECRET"));
    CHECK_FALSE(contains(github_annotations(submission), "SECRET"));
  }
}

TEST_CASE("github: the summary stays below what GitHub takes", "[results]") {
  SubmissionResult submission = sample(mistakes);
  submission.stages[0].compiler.assign(400'000, '.');
  const std::string text = github_summary(submission);
  CHECK(text.size() < 1'048'576);
  CHECK(contains(text, "too long to be shown"));
  CHECK(contains(text, "got       "));  // what is short enough is there still
}

TEST_CASE("github: annotations name file, place and title", "[results]") {
  const std::string text = github_annotations(sample(breaks));
  CHECK(contains(text,
                 "::error file=04_shadows.cpp,line=12,col=7,title=does not compile::'foo' was not declared in this "
                 "scope\n"));
  CHECK_FALSE(contains(text, "4.1"));  // it follows from that
  CHECK(
      contains(text, "::error file=05_reflections.cpp,title=5.1 reflect%3A crashed::It ended with a segmentation fault.\n"));
  CHECK(contains(github_annotations(sample(mistakes)),
                 "::warning file=06_refraction.cpp,title=6.1 through_sphere%3A not written"));
  CHECK(contains(github_annotations(sample(nothing_written)), "::warning title=4.1 blocked%3A not written"));
  CHECK(contains(github_annotations(sample(raylab_failed)), "::warning file=05_reflections.cpp,title=5.1"));
  CHECK(github_annotations(sample(all_right)).empty());
}

TEST_CASE("github: no text of a submission becomes a command or a property of its own", "[results]") {
  std::istringstream lines(github_annotations(sample(hostile_text)));
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    CHECK((line.starts_with("::error file=") || line.starts_with("::warning file=")));
    const std::string properties = line.substr(0, line.find("::", 2));
    CHECK(occurrences(properties, ",") == 1);
    CHECK(is_plain(line));
  }
  CHECK(count == 7);
  CHECK(contains(github_annotations(sample(hostile_text)), "100%25"));
}

TEST_CASE("compiler errors: those of the file, by any path, with their place", "[results]") {
  const auto errors = compiler_errors(
      "In file included from x:\n/tmp/a b/01_rays.cpp:7:12: error: a: error: b\n01_rays.cpp:8:1: warning: no\n"
      "01_rays.cpp:9:2: fatal error: gone\nother_01_rays.cpp:1:1: error: not it\nstage.hpp:3:1: error: nor this\n"
      "01_rays.cpp: error: no place\n01_rays.cpp:0:1: error: none\n01_rays.cpp:1:99999999999: error: none\n",
      "01_rays.cpp");
  REQUIRE(errors.size() == 2);
  CHECK((errors[0].line == 7 && errors[0].column == 12 && errors[0].text == "a: error: b"));
  CHECK((errors[1].line == 9 && errors[1].text == "gone"));
  CHECK(compiler_errors("x:1:1: error: y", "").empty());
}

// ---- Gradebook and roster -------------------------------------------------------------------------------------------

TEST_CASE("gradebook: a line for each submission, with all its points and verdicts", "[results]") {
  const auto lines = parse_csv(gradebook_csv(sample_class(), sample_roster()));
  REQUIRE(lines.size() == 7);
  CHECK(lines[0] == std::vector<std::string>{"id", "name", "points", "most points", "bonus", "most bonus", "grade again",
                                             "stage 4", "stage 5", "stage 6", "4.1", "5.1", "5.2", "5.3", "6.1", "6.2",
                                             "6.3"});
  CHECK(lines[2] == std::vector<std::string>{"1b2c3d4e5f", "Zo\xc3\xab O'Hara, \"Zee\"", "5", "8", "0", "5", "no", "3", "2",
                                             "0", "right", "wrong", "wrong", "right", "not written", "not written",
                                             "not written"});
  CHECK(lines[5][2] == "7");
  CHECK(lines[5][6] == "yes");
  CHECK(lines[5][8] == "5");
  CHECK(lines[6][1].empty());
}

TEST_CASE("gradebook: no cell is a formula, by whichever separator it is read", "[results]") {
  CHECK(csv_text("=1+1") == "'=1+1");
  CHECK(csv_text(" \"@x") == " \"'@x");
  CHECK(csv_text("a;=b|+c,-d") == "a;'=b|'+c,'-d");
  CHECK(csv_text("\t=1") == "\\x09=1");
  CHECK(csv_text("\r=1") == "\\x0d=1");
  CHECK(csv_text("\xef\xbc\x9d"
                 "1") ==
        "'\xef\xbc\x9d"
        "1");
  CHECK(csv_text("Anna-Maria Smith = ok") == "Anna-Maria Smith = ok");
  for (const std::vector<std::string>& line : parse_csv(gradebook_csv(sample_class(), sample_roster())))
    for (const std::string& cell : line) {
      CHECK(plain_line(cell) == cell);
      CHECK(csv_text(cell) == cell);
    }
}

TEST_CASE("csv: cells are quoted by RFC 4180, and read back", "[results]") {
  CHECK(csv_line({"a", "b,c", "say \"x\"", " d", ""}) == "a,\"b,c\",\"say \"\"x\"\"\",\" d\",\r\n");
  using Lines = std::vector<std::vector<std::string>>;
  CHECK(parse_csv("\xef\xbb\xbf"
                  "a,\"b\r\n\"\"c\"\r\n,\nlast") == Lines{{"a", "b\r\n\"c"}, {"", ""}, {"last"}});
  CHECK_THROWS_WITH(parse_csv("a\n\"b"), ContainsSubstring("line 2") && ContainsSubstring("not closed"));
  CHECK_THROWS_AS(parse_csv("\"a\"b"), InputError);
  CHECK_THROWS_AS(parse_csv("a\"b"), InputError);
}

TEST_CASE("roster: any bytes of a name survive, and none is a formula or more than a line", "[results]") {
  std::string all_bytes;
  for (int byte = 0; byte < 256; ++byte) all_bytes += static_cast<char>(byte);
  std::vector<RosterEntry> roster = sample_roster();
  for (const std::string& name : {all_bytes, std::string("=cmd|'/c calc'!A1"), std::string("\\x41 \\"), std::string("a;=b"),
                                  std::string("\xef\xbc\x9d"
                                              "1"),
                                  std::string("\xe2\x80\xae"
                                              "abc"),
                                  std::string()})
    roster.push_back({"id" + std::to_string(roster.size()), name});
  const std::string csv = roster_csv(roster);
  const std::vector<RosterEntry> read = parse_roster(csv);
  REQUIRE(read.size() == roster.size());
  for (std::size_t i = 0; i < roster.size(); ++i) {
    CHECK(read[i].id == roster[i].id);
    CHECK(read[i].name == roster[i].name);
  }
  CHECK(occurrences(csv, "\n") == roster.size() + 1);
  for (const std::vector<std::string>& line : parse_csv(csv))
    for (const std::string& cell : line) CHECK(csv_text(cell) == cell);
  CHECK(contains(csv, "0a1b2c3d4e,Ada Lovelace\r\n"));
}

TEST_CASE("roster: what is no roster is refused, with the place", "[results]") {
  CHECK(parse_roster("id,name\n7,Ann\\b\n").front().name == "Ann\\b");
  CHECK_THROWS_WITH(parse_roster(""), ContainsSubstring("id,name"));
  CHECK_THROWS_WITH(parse_roster("7,Ann\n"), ContainsSubstring("id,name"));
  CHECK_THROWS_WITH(parse_roster("id,name\n7\n"), ContainsSubstring("entry 1"));
  CHECK_THROWS_WITH(parse_roster("id,name\n7,Ann\n7,Bob\n"), ContainsSubstring("entry 2") && ContainsSubstring("twice"));
}

TEST_CASE("roster: a name is found by its id, as plain text", "[results]") {
  CHECK(name_in(sample_roster(), sample(all_right).id) == "Ada Lovelace");
  CHECK(name_in(sample_roster(), "nobody").empty());
  CHECK(is_plain(name_in(sample_roster(), sample(hostile_text).id)));
}

// ---- The page of a student ------------------------------------------------------------------------------------------

namespace {

/// The data of a page.
Json data_in(const std::string& page) {
  const std::string start = "id=\"report\">";
  const std::size_t from = page.find(start) + start.size();
  return Json::parse(page.substr(from, page.find("</script>", from) - from));
}

}  // namespace

TEST_CASE("student page: it holds nothing of the course's own tests and images but their points", "[results]") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "images");
  for (const SubmissionResult& submission : sample_class().submissions) {
    const std::string page = student_page(submission, folder / "");
    CHECK_FALSE(contains(page, "SECRET"));
    CHECK_FALSE(contains(page, base64(secret).substr(0, 12)));
  }
  const Json data = data_in(student_page(sample(mistakes), folder / ""));
  CHECK(data["stages"][1]["course"] == Json{{"got", 0.5}, {"most", 2.0}});
  CHECK(data["stages"][1]["images"].size() == 1);
}

TEST_CASE("student page: images are in it; what is missing, no PNG or elsewhere is not", "[results]") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "submission");
  const std::string png = "\x89PNG\r\n\x1a\n and so on";
  folder.write("outside.png", png);
  folder.write("submission/mine.png", png);
  folder.write("submission/text.png", "no PNG");
  SubmissionResult submission = sample(mistakes);
  ImageResult& image = submission.stages[1].images[0];
  image.image = "mine.png";
  image.reference = "text.png";
  image.heat = "../outside.png";
  submission.stages[0].images[0].image = (folder / "outside.png").string();
  const Json stages = data_in(student_page(submission, folder / "submission"))["stages"];
  CHECK(stages[1]["images"][0]["image"] == "data:image/png;base64," + base64(png));
  CHECK(stages[1]["images"][0]["reference"] == "");
  CHECK(stages[1]["images"][0]["heat"] == "");
  CHECK(stages[0]["images"][0]["image"] == "");
  CHECK(stages[0]["images"][0]["heat"] == "");  // missing
}

TEST_CASE("student page: points are those that count, and it says where raylab failed", "[results]") {
  const Json data = data_in(student_page(sample(raylab_failed), "no such folder"));
  CHECK(data["points"] == Json{{"got", 7.0}, {"most", 8.0}});
  CHECK(data["needsNewRun"] == true);
  CHECK(data["newRunNote"] == new_run_note);
  CHECK(data["stages"][1]["tasks"][0]["points"]["got"] == 1.0);
  CHECK(data_in(student_page(sample(mistakes), "no such folder"))["needsNewRun"] == false);
}

TEST_CASE("pages: no text ends the script that it stands in", "[results]") {
  const std::string student = student_page(sample(hostile_text), "no such folder");
  const std::string class_wide = class_page(sample_class(), sample_roster(), sample_seconds());
  for (const std::string& page : {student, class_wide}) {
    CHECK(occurrences(page, "</script>") == 2);
    CHECK_FALSE(contains(page, "{{"));
    CHECK(is_plain(page));
  }
}

// ---- The page of a class --------------------------------------------------------------------------------------------

TEST_CASE("class: tasks come with the most missed first, with each verdict's count", "[results]") {
  const ClassSummary summary = summary_of(sample_class(), {}, {});
  REQUIRE(summary.tasks.size() == 7);
  CHECK(summary.tasks[0].label == "5.1");
  CHECK(summary.tasks[0].missed == 5);
  CHECK(to_json(summary.tasks[0].verdicts) ==
        R"([{"verdict":"right","count":1},{"verdict":"wrong","count":2},{"verdict":"not_written","count":1},)"
        R"({"verdict":"crashed","count":1},{"verdict":"infrastructure","count":1}])");
  CHECK(summary.tasks.back().missed == 3);
}

TEST_CASE("class: known mistakes and failed tests are counted by submissions, the most frequent first", "[results]") {
  ClassResults results = sample_class();
  results.submissions = {sample(mistakes), sample(all_right), sample(mistakes)};
  results.submissions[1].stages[0].tasks[0].mistake = "another one";
  const ClassSummary summary = summary_of(results, {}, {});
  REQUIRE(summary.mistakes.size() == 2);
  CHECK(to_json(summary.mistakes[0]) == R"({"label":"5.1","text":"plus for minus","count":2})");
  CHECK(summary.mistakes[1].text == "another one");
  REQUIRE(summary.failed_tests.size() == 3);
  CHECK(summary.failed_tests[0].text == "5.1 reflect: twice is where we began");
  CHECK(summary.failed_tests[0].count == 2);
}

TEST_CASE("class: a row has name, points that count, worst verdict, seconds and what raylab failed to judge", "[results]") {
  const ClassSummary summary = summary_of(sample_class(), sample_roster(), sample_seconds());
  const SubmissionRow& broken = summary.submissions[breaks];
  CHECK(broken.name == "\xd8\xa3\xd8\xad\xd9\x85\xd8\xaf");
  CHECK(broken.worst == Verdict::refused);
  CHECK(broken.seconds == 61.25);
  CHECK(broken.unjudged.empty());
  const SubmissionRow& failed = summary.submissions[raylab_failed];
  CHECK(points_text(failed.points) == "7 of 8");
  REQUIRE(failed.stages[1]);
  CHECK(points_text(*failed.stages[1]) == "5 of 5");
  CHECK(failed.unjudged.size() == 5);
  CHECK(failed.unjudged[0] == "5.1 reflect: The disk was full.");
  CHECK_FALSE(failed.seconds);
  CHECK(summary.submissions[nothing_written].name.empty());
  CHECK(summary.submissions[mistakes].notes.size() == 1);
  CHECK(summary.verdicts.back() == Verdict::infrastructure);
}

TEST_CASE("class: a submission may lack a stage that others have", "[results]") {
  ClassResults results = sample_class();
  results.submissions[0].stages.erase(results.submissions[0].stages.begin());
  const ClassSummary summary = summary_of(results, {}, {});
  CHECK(summary.stages.size() == 3);
  CHECK(summary.stages[0].number == 4);
  CHECK_FALSE(summary.submissions[0].stages[0]);
  CHECK(summary.submissions[0].stages[1]);
}
