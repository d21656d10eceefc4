// The numerically hard cases of tests/data/hard_cases.json. Each case has inputs that are exact doubles, an answer of 25
// digits and a tolerance class; `meta` in that file explains them. What is asked in each is in tests/hard.

#include "core/image/data_folder.hpp"
#include "tests/hard/case.hpp"
#ifdef RAYLAB_WITH_ENGINE
#include "reference/engine/tasks.hpp"
#endif
#ifdef RAYLAB_WITH_ORACLE
#include "reference/oracle/tasks.hpp"
#endif

#include <fstream>
#include <stdexcept>

using namespace raylab;
using namespace raylab::test;
using namespace raylab::test::hard;
using nlohmann::json;

namespace {

Tests all_tests() {
  Tests all = tests_of_rays_and_shapes();
  all.merge(tests_of_light());
  all.merge(tests_of_bounces_and_samples());
  return all;
}

/// The cases of a stage, or all for an empty name. Float gets those alone whose inputs are floats.
void run(const std::string& stage, const Asked& asked) {
  const Tests tests = all_tests();
  std::ifstream file(data_folder("tests/data") / "hard_cases.json");
  const json document = json::parse(file);
  std::size_t count = 0;
  for (const json& data : document["cases"]) {
    if (!stage.empty() && data["stage"] != stage) continue;
    if (asked.single_precision() && !data["float32_exact"]) continue;
    INFO("hard case " << data["id"] << ": " << data["title"]);
    const auto test = tests.find(data["op"]);
    REQUIRE(test != tests.end());
    if (asked.without_answer.contains(data["id"]))
      CHECK_THROWS_AS(test->second({data, asked}), std::domain_error);
    else
      test->second({data, asked});
    ++count;
  }
  CHECK(count > 0);
}

}  // namespace

TEST_CASE("hard cases of stage 1: rays", "[stage1][hard]") { run("rays", {table()}); }
TEST_CASE("hard cases of stage 2: intersections", "[stage2][hard]") { run("intersections", {table()}); }
TEST_CASE("hard cases of stage 3: Blinn-Phong", "[stage3][hard]") { run("blinn-phong", {table()}); }
TEST_CASE("hard cases of stage 4: shadows", "[stage4][hard]") { run("shadows", {table()}); }
TEST_CASE("hard cases of stage 5: reflections", "[stage5][hard]") { run("reflections", {table()}); }
TEST_CASE("hard cases of stage 6: refraction", "[stage6][hard]") { run("refraction", {table()}); }
TEST_CASE("hard cases of stage 7: anti-aliasing", "[stage7][hard]") { run("ssaa", {table()}); }

#ifdef RAYLAB_WITH_ENGINE
TEST_CASE("engine: hard cases in double", "[engine][hard]") { run("", {fast_table(Precision::f64)}); }
TEST_CASE("engine: hard cases in float", "[engine][hard]") { run("", {fast_table(Precision::f32), 0x1p-24}); }
#endif
#ifdef RAYLAB_WITH_ORACLE
TEST_CASE("oracle: hard cases", "[oracle][hard]") { run("", {oracle_table(), 0x1p-53, {"I32", "I33", "I39"}}); }
#endif
