// The reports of grading: that each says what the results say, tells students nothing of the course's own tests, and lets
// nothing through that a submission wrote.

#include "core/results/results.hpp"

#include "core/results/counted.hpp"
#include "core/results/gradescope.hpp"
#include "core/results/plain_text.hpp"
#include "core/results/shown.hpp"
#include "tests/catch.hpp"
#include "tests/sample_results.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <string>

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
