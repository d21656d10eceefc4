// The parts of core/submission and core/explain that need no other process; tests/submission_test.sh has the rest.

#include "core/calls/call_task.hpp"
#include "core/explain/explanation.hpp"
#include "core/explain/first_difference.hpp"
#include "core/image/data_folder.hpp"
#include "core/render/render.hpp"
#include "core/render/stages_engine.hpp"
#include "core/scene/read_scene.hpp"
#include "core/submission/messages.hpp"
#include "core/submission/stage_files.hpp"
#include "tests/hints/observed.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

using namespace raylab;
using namespace raylab::test;

namespace {

using Labels = std::vector<std::string>;

Labels labels(const std::string& with, int stage) { return chosen_tasks(parse_chosen(with), stage); }

Scene scene_of(const std::string& name) { return read_scene(data_folder("scenes") / name).scene.value(); }

/// A pixel of 40 x 30, with all bounces.
struct Seen40x30 {
  Scene scene;
  Settings settings;
  Recording recording;
  std::vector<RayNode> trees;

  Seen40x30(const std::string& name, int stage, int i, int j)
      : scene(scene_of(name)),
        settings{stage, {40, 30}, scene.max_bounces, AntiAliasing::none},
        recording(record_pixel(scene, settings, table(), i, j)),
        trees(ray_trees(scene, recording)) {}
};

/// The color that a tree's parts give: what the driver does, from the other end.
Color assembled(const Scene& scene, const Settings& settings, const RayNode& node) {
  if (!node.t) return scene.background;
  if (settings.stage < 3) return node.color;
  Color sum(0);
  for (const LightTerm& term : node.lights) sum += term.color;
  for (const RayNode& child : node.children) sum += child.weight * assembled(scene, settings, child);
  return sum;
}

std::size_t rays_in(const RayNode& node) {
  std::size_t rays = 1;
  for (const RayNode& child : node.children) rays += rays_in(child);
  return rays;
}

}  // namespace

TEST_CASE("--with: a folder, and what of it counts", "[submissions]") {
  CHECK(parse_chosen("my lab").folder == "my lab");
  CHECK(labels("lab", 5) == Labels{"5.1", "5.2", "5.3"});
  CHECK(labels("lab:4,5.2", 5) == Labels{"5.2"});
  CHECK(labels("lab:4,5.2", 4) == Labels{"4.1"});
  CHECK(labels("lab:4,5.2", 3).empty());
  CHECK(labels("lab:4-5", 5) == Labels{"5.1", "5.2", "5.3"});
  CHECK(labels("lab:4-5", 6).empty());
  CHECK(parse_chosen("a:b:5").folder == "a:b");
  for (const char* const wrong :
       {"lab:", "lab:9", "lab:5.9", "lab:5,", "lab:x", "lab:1-", "lab:-3", "lab:5-4", "lab:1-99999999999"})
    CHECK_THROWS_AS(parse_chosen(wrong), std::invalid_argument);
  CHECK_THROWS_AS(stage_files("no such folder"), std::runtime_error);
}

TEST_CASE("messages: a scene comes back as it went, to the last bit", "[submissions]") {
  for (const char* const name : {"scene1.toml", "scene3.toml", "scene5.toml", "hard/telescope.toml"}) {
    const Scene scene = scene_of(name);
    const Settings settings{7, {3, 2}, 4, AntiAliasing::adaptive};
    const std::string text = to_json(SceneMessage{scene, settings});
    CHECK(to_json(from_json<SceneMessage>(text)) == text);
    const auto back = from_json<SceneMessage>(text);
    CHECK(render_image(*make_stages(back.scene, {7, {12, 9}, 3, {}}, table()), {12, 9}, 1).pixels ==
          render_image(*make_stages(scene, {7, {12, 9}, 3, {}}, table()), {12, 9}, 1).pixels);
  }
  CHECK_THROWS_AS(from_json<TraceAnswer>(R"({"pixels": [[1, 2]], "rays": {}})"), InputError);
  CHECK_THROWS_AS(from_json<TraceAnswer>("\x1b[2J"), InputError);
  CHECK(first_word("call 2.2 {}") == std::pair<std::string_view, std::string_view>("call", "2.2 {}"));
  CHECK(first_word("ready") == std::pair<std::string_view, std::string_view>("ready", ""));
}

TEST_CASE("explain: answers agree but for what right programs differ by", "[submissions]") {
  CHECK(answers_agree("1.0", "1.00001"));
  CHECK_FALSE(answers_agree("1.0", "1.001"));
  CHECK(answers_agree("1000.0", "1000.05"));
  CHECK(answers_agree("\"nan\"", "\"nan\""));
  CHECK_FALSE(answers_agree("\"nan\"", "0.0"));
  CHECK(answers_agree("\"inf\"", "\"inf\""));
  CHECK_FALSE(answers_agree("\"inf\"", "1e300"));
  CHECK(answers_agree("null", "null"));
  CHECK_FALSE(answers_agree("null", "0.0"));
  CHECK_FALSE(answers_agree("true", "false"));
  CHECK_FALSE(answers_agree("[1.0,2.0,3.0]", "[1.0,3.0,2.0]"));
  CHECK_FALSE(answers_agree("[[1.0,2.0,3.0]]", "[]"));
  const auto bounce = [](const std::string& origin, const std::string& side, const std::string& weight) {
    return R"({"ray":{"origin":)" + origin + R"(,"direction":[0.0,1.0,0.0],"leaves":{"geometry":1,"side":")" + side +
           R"("}},"weight":)" + weight + "}";
  };
  CHECK(answers_agree(bounce("[0.0,0.0,0.0]", "inwards", "0.5"), bounce("[0.0,0.001,0.0]", "inwards", "0.5")));
  CHECK_FALSE(answers_agree(bounce("[0.0,0.0,0.0]", "inwards", "0.5"), bounce("[0.0,0.1,0.0]", "inwards", "0.5")));
  CHECK_FALSE(answers_agree(bounce("[0.0,0.0,0.0]", "inwards", "0.5"), bounce("[0.0,0.0,0.0]", "outwards", "0.5")));
  CHECK(answers_agree(bounce("[0.0,0.0,0.0]", "inwards", "0.0"), bounce("[9.0,0.0,0.0]", "outwards", "0.0")));
}

TEST_CASE("explain: the ray tree of a pixel gives its color", "[submissions]") {
  for (const char* const name : {"scene1.toml", "scene3.toml", "scene4.toml", "06_refraction/inside_glass.toml"}) {
    for (int stage = 1; stage <= 6; ++stage)
      for (int k = 0; k < 24; ++k) {
        const Seen40x30 seen(name, stage, k * 7 % 40, k * 11 % 30);
        REQUIRE(seen.trees.size() == 1);
        const Color sum = stage == 1 ? seen.trees[0].color : assembled(seen.scene, seen.settings, seen.trees[0]);
        const Color clamped = clamp(sum, Color(0), Color(1));
        CHECK(clamped == within(1e-12, seen.recording.color));
      }
  }
}

TEST_CASE("explain: rays are counted as the driver counts them", "[submissions]") {
  const Seen40x30 seen("scene4.toml", 6, 20, 14);
  std::vector<Color> row(40);
  RayCounts counts;
  const std::atomic<bool> never = false;
  std::size_t rays = 0;
  for (int i = 0; i < 40; ++i) rays += rays_in(Seen40x30("scene4.toml", 6, i, 14).trees[0]);
  make_stages(seen.scene, seen.settings, table())->trace_rows(14, row, counts, never);
  CHECK(rays == counts.primary + counts.reflected + counts.refracted);
}

TEST_CASE("explain: the first call that is answered differently, and nothing where all is right", "[submissions]") {
  const Seen40x30 seen("scene3.toml", 5, 20, 15);
  const auto asking = [](const StageTable& asked) {
    return [asked](const TaskInfo& task, const std::string& arguments) { return TaskCaller(asked, task).result(arguments); };
  };
  CHECK_FALSE(first_difference(seen.recording, asking(table())).has_value());
  StageTable wrong = table();
  wrong.mirror_bounce = [](const Hit& hit, double k_s) { return Bounce{{hit.point, hit.direction, hit.leaves}, k_s}; };
  wrong.sum_lights = [](std::span<const Color>) { return Color(0.125); };
  const auto found = first_difference(seen.recording, asking(wrong));
  REQUIRE(found.has_value());
  CHECK(found->call.task->label == "3.6");
  CHECK(found->got == "[0.125,0.125,0.125]");
  StageTable throwing = table();
  throwing.nearest_hit = [](std::span<const Candidate>) -> std::optional<std::size_t> { throw NotWritten("not yet"); };
  CHECK(first_difference(seen.recording, asking(throwing))->error == "not yet");
}

TEST_CASE("hints: what wrong answers have in common", "[submissions]") {
  const auto pattern = [](std::vector<std::pair<std::string, std::string>> pairs) {
    std::vector<WrongAnswer> wrong;
    for (const auto& [wanted, got] : pairs) wrong.push_back({"{}", wanted, got, {}});
    return common_pattern(wrong);
  };
  CHECK(pattern({{"[1.0,2.0,3.0]", "[-1.0,-2.0,-3.0]"}, {"[0.5,0.0,1.0]", "[-0.5,0.0,-1.0]"}}) ==
        "Every answer has the opposite sign.");
  CHECK(pattern({{"2.0", "1.0"}, {"5.0", "2.5"}}) == "Every answer is 0.5 times the right one.");
  CHECK(pattern({{"2.0", "1.0"}, {"5.0", "2.6"}}).empty());
  CHECK(pattern({{"[1.0,2.0,3.0]", "[1.0,-2.0,3.0]"}}) ==
        "Every answer has the opposite sign in y, and is right otherwise.");
  CHECK(pattern({{"[1.0,2.0,3.0]", "[2.0,1.0,3.0]"}, {"[4.0,2.0,3.0]", "[2.0,4.0,3.0]"}}) ==
        "In every answer x and y have changed places.");
  CHECK(pattern({{"[0.5,2.0,3.0]", "[0.5,1.0,1.0]"}, {"[4.0,2.0,-3.0]", "[1.0,1.0,0.0]"}}) ==
        "Every answer is the right one, clamped to 0..1.");
  CHECK(pattern({{"[0.6,0.8,0.0]", "[1.2,1.6,0.0]"}, {"[0.0,0.8,0.6]", "[0.0,2.4,1.8]"}}) ==
        "Every direction is right, but its length is not.");
  CHECK(pattern({{"1.0", "\"nan\""}, {"2.0", "\"inf\""}}) == "Every wrong answer is not a finite number.");
  CHECK(pattern({{"1.5", "null"}, {"2.0", "null"}}) == "2 times it says \"nothing\" where there is something.");
  CHECK(pattern({{"null", "3.0"}}) == "1 time it finds something where there is nothing.");
  CHECK(pattern({{"true", "false"}}) == "1 time it says false where true is right.");
}
