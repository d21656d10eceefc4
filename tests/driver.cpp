// What the driver does around the tasks, seen in the colors of whole pixels.

#include "core/render/render.hpp"
#include "core/render/stages_engine.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <thread>
#include <vector>

using namespace raylab;
using namespace raylab::test;

namespace {

const std::atomic<bool> never = false;

/// One pixel that looks along -z from the origin, at a stage, with one sample.
Color look(Scene scene, int stage) {
  scene.image = {1, 1};
  const Settings settings{stage, {1, 1}, scene.max_bounces, AntiAliasing::none};
  Color pixel(0);
  RayCounts counts;
  make_stages(scene, settings, table())->trace_rows(0, {&pixel, 1}, counts, never);
  return pixel;
}

RayCounts count_rays(const Scene& scene, int stage) {
  const Settings settings{stage, {1, 1}, scene.max_bounces, AntiAliasing::none};
  Color pixel(0);
  RayCounts counts;
  make_stages(scene, settings, table())->trace_rows(0, {&pixel, 1}, counts, never);
  return counts;
}

std::vector<Color> render_all(const Scene& scene, Settings settings, unsigned threads) {
  std::vector<Color> image;
  render(
      *make_stages(scene, settings, table()), settings.size, threads,
      [&](int, std::span<const Color> rows) { image.insert(image.end(), rows.begin(), rows.end()); }, [](double) {}, never);
  return image;
}

SphereObject ball(const Vec3& center, double radius, const Color& color, double shininess = 0) {
  return {{center, radius}, {color, shininess, false, 1.5}};
}
SphereObject glass(const Vec3& center, double radius, double index = 1.5) {
  return {{center, radius}, {Color(1), 0, true, index}};
}
PlaneObject wall(double z, const Color& color, double shininess = 0) {
  return {{{0, 0, z}, {0, 0, 1}}, {color, shininess, false, 1.5}};
}

const Color red(1, 0, 0), green(0, 1, 0), blue(0, 0, 1);

/// A camera between two walls, in front of it and behind it, that shine and are lit by an ambient light alone.
Scene facing_mirrors(double shininess) {
  Scene scene;
  scene.planes = {wall(-1, Color(0.125), shininess), wall(1, Color(0.125), shininess)};
  scene.ambient_lights = {{1}};
  return scene;
}

}  // namespace

TEST_CASE("driver: pixels have the handout's coordinates, for even and odd sizes", "[driver]") {
  // Hard cases R02 and R03: x - 1/2 and y - 1/2 of every pixel.
  static std::vector<std::pair<double, double>> asked;
  StageTable spy = table();
  spy.camera_ray = [](const Camera&, int, int, double x, double y, double, double) {
    asked.emplace_back(x - 0.5, y - 0.5);
    return Ray{{0, 0, 0}, {0, 0, -1}, {}};
  };
  const auto pixels_of = [&](int width, int height) {
    asked.clear();
    const Scene scene;
    std::vector<Color> pixels(static_cast<std::size_t>(width * height));
    RayCounts counts;
    make_stages(scene, {1, {width, height}, 5, {}}, spy)->trace_rows(0, pixels, counts, never);
    return asked;
  };
  const std::vector<std::pair<double, double>> odd = pixels_of(5, 3), even = pixels_of(4, 2);
  REQUIRE(odd.size() == 15);
  CHECK(odd.front() == std::pair(-2.0, 1.0));
  CHECK(odd[1] == std::pair(-1.0, 1.0));
  CHECK(odd[7] == std::pair(0.0, 0.0));
  CHECK(odd.back() == std::pair(2.0, -1.0));
  REQUIRE(even.size() == 8);
  CHECK(even.front() == std::pair(-1.5, 0.5));
  CHECK(even.back() == std::pair(1.5, -0.5));
}

TEST_CASE("driver: stage 1 shows the direction, stage 2 flat colors and the background", "[driver]") {
  Scene scene;
  scene.background = blue;
  CHECK(look(scene, 1) == within(1e-16, Color(0.5, 0.5, 0)));
  CHECK(look(scene, 2) == blue);
  scene.spheres = {ball({0, 0, -5}, 1, red)};
  CHECK(look(scene, 2) == red);
}

TEST_CASE("driver: of equal distances planes come first, then spheres, then clouds", "[driver]") {
  Scene scene;
  scene.clouds = {{{{{0, 0, -5}, 1}}, {}, {blue, 0, false, 1.5}}};
  CHECK(look(scene, 2) == blue);
  scene.spheres = {ball({0, 0, -5}, 1, red), ball({0, 0, -5}, 1, green)};
  CHECK(look(scene, 2) == red);
  scene.planes = {wall(-4, green)};
  CHECK(look(scene, 2) == green);
}

TEST_CASE("driver: each sphere of a cloud has its own color, if the table says so", "[driver]") {
  Scene scene;
  scene.clouds = {{{{{9, 0, -5}, 1}}, {}, {blue, 0, false, 1.5}},
                  {{{{5, 0, -5}, 1}, {{0, 0, -5}, 1}}, {green, red}, {blue, 0, false, 1.5}}};
  CHECK(look(scene, 2) == red);
}

TEST_CASE("driver: a plane is lit on the side that is seen", "[driver]") {
  Scene scene;
  scene.planes = {{{{0, 0, -2}, {0, 0, -7}}, {Color(1), 0, false, 1.5}}};  // its normal points away from the camera
  scene.directional_lights = {{{0, 0, -1}, 0.5}};
  CHECK(look(scene, 3) == within(1e-15, Color(0.5)));
}

TEST_CASE("driver: shadows begin at stage 4", "[driver]") {
  Scene scene;
  scene.planes = {wall(-3, Color(1))};
  scene.spheres = {ball({0, 3, -1}, 0.5, red)};
  scene.point_lights = {{{0, 6, 1}, 64}};  // the sphere is half way to the light
  const double lit = look(scene, 3).r;
  CHECK(lit > 0.1);
  CHECK(look(scene, 4) == Color(0));
  scene.spheres[0].material.transparent = true;
  CHECK(look(scene, 4).r == lit);
  scene.spheres[0] = ball({0, 9, 3}, 0.5, red);  // behind the light
  CHECK(look(scene, 4).r == lit);
}

TEST_CASE("driver: a blocker nearer than 0.1 casts its shadow, and touching blocks", "[driver]") {
  Scene scene;
  scene.planes = {wall(-3, Color(1))};
  scene.directional_lights = {{{0, -0.01, -1}, 1}};
  scene.spheres = {ball({0, 0.0002, -2.96}, 0.01, red)};
  // The ray passes the small sphere on its way: look at the wall past it.
  scene.camera.position = {0, 0, -2.999};
  CHECK(look(scene, 3).r > 0.9);
  CHECK(look(scene, 4) == Color(0));
}

TEST_CASE("driver: a point inside an opaque sphere is in the dark of its far side", "[driver]") {
  Scene scene;
  scene.camera.position = {0, 0, 0};
  scene.spheres = {ball({0, 0, 0}, 2, Color(1))};
  scene.point_lights = {{{0, 0, 5}, 49}};
  CHECK(look(scene, 3).r > 0.5);  // the light shines on the inside of the far wall
  CHECK(look(scene, 4) == Color(0));
  scene.point_lights = {{{0, 0, 1.5}, 49}};  // inside, with the camera
  CHECK(look(scene, 4).r > 0.5);
}

TEST_CASE("driver: no shadow is asked for below the surface", "[driver]") {
  Scene scene;
  scene.planes = {wall(-3, Color(1))};
  scene.directional_lights = {{{0, 0, 1}, 1}, {{0, 0, -1}, 1}};
  CHECK(count_rays(scene, 4).shadow == 1);
  CHECK(count_rays(scene, 3).shadow == 0);
}

TEST_CASE("driver: a mirror sees the background, and black beyond the last bounce", "[driver]") {
  Scene scene;
  scene.background = Color(0.5, 0, 0);
  scene.spheres = {ball({0, 0, -5}, 1, Color(0), infinity)};
  CHECK(look(scene, 5) == within(1e-15, Color(0.5, 0, 0)));
  scene.max_bounces = 0;
  CHECK(look(scene, 5) == Color(0));
}

TEST_CASE("driver: between facing mirrors the bounces add up to the series, and end", "[driver]") {
  Scene scene = facing_mirrors(infinity);
  for (const int limit : {0, 1, 5}) {
    scene.max_bounces = limit;
    CHECK(look(scene, 5) == within(1e-15, Color(0.125 * (limit + 1))));
    CHECK(count_rays(scene, 5).reflected == static_cast<std::uint64_t>(limit));
  }
  scene = facing_mirrors(1000);
  CHECK(look(scene, 5) == within(1e-14, Color(0.7253452785745494873)));  // hard case X02
}

TEST_CASE("driver: the reflection is not tinted by the mirror's color", "[driver]") {
  Scene scene;
  scene.background = Color(0.5, 0.5, 0.5);
  scene.planes = {wall(-3, red, infinity)};
  CHECK(look(scene, 5) == within(1e-15, Color(0.5)));
}

TEST_CASE("driver: glass is opaque before stage 6", "[driver]") {
  Scene scene;
  scene.planes = {wall(-9, green)};
  scene.spheres = {glass({0, 0, -4}, 1)};
  scene.spheres[0].material.color = red;
  scene.ambient_lights = {{1}};
  CHECK(look(scene, 5) == red);
  // Straight through the middle: 4 % of the black behind the camera, 96 % of the wall.
  CHECK(look(scene, 6) == within(1e-15, Color(0, 0.96, 0)));
}

TEST_CASE("driver: a ray that has passed glass does not meet it again, but the floor under it", "[driver]") {
  Scene scene;
  scene.planes = {wall(-6, green)};
  scene.spheres = {glass({0, 0, -5}, 1)};  // it stands on the wall
  scene.ambient_lights = {{1}};
  CHECK(look(scene, 6) == within(1e-15, Color(0, 0.96, 0)));
}

TEST_CASE("driver: what is inside a glass ball is not seen through it", "[driver]") {
  Scene scene;
  scene.spheres = {glass({0, 0, -5}, 2), ball({0, 0, -5}, 1, red)};
  scene.ambient_lights = {{1}};
  scene.background = Color(0, 0, 1);
  CHECK(look(scene, 6) == within(1e-15, Color(0, 0, 1)));
}

TEST_CASE("driver: from inside glass the ray goes out, and the reflected one stays in", "[driver]") {
  Scene scene;
  scene.spheres = {glass({0, 0, 0}, 1)};
  scene.background = green;
  scene.max_bounces = 1;
  // Straight on: 96 % leave at once; the 4 % that stay in meet the far side, where the bounces end in black.
  CHECK(look(scene, 6) == within(1e-15, Color(0, 0.96, 0)));
  scene.max_bounces = 2;
  CHECK(look(scene, 6) == within(1e-15, Color(0, 0.96 + 0.04 * 0.96, 0)));
  CHECK(count_rays(scene, 6).reflected == 2);
  CHECK(count_rays(scene, 6).refracted == 2);
}

TEST_CASE("driver: thin glass beyond the critical angle is a mirror", "[driver]") {
  Scene scene;
  scene.camera.position = {0.9, 0, 5};  // sin(theta_1) = 0.9 > 0.75
  scene.spheres = {glass({0, 0, 0}, 1, 0.75)};
  scene.background = green;
  CHECK(look(scene, 6) == within(1e-15, green));
  CHECK(count_rays(scene, 6).refracted == 0);
}

TEST_CASE("driver: --aa patterns work at any stage, and none at stage 7", "[driver]") {
  Scene scene;
  scene.planes = {{{{0, 0, -1}, {0, 0, 1}}, {Color(1), 0, false, 1.5}}};
  const auto samples = [&](int stage, std::optional<AntiAliasing> aa) {
    const Settings settings{stage, {1, 1}, 5, aa};
    Color pixel(0);
    RayCounts counts;
    make_stages(scene, settings, table())->trace_rows(0, {&pixel, 1}, counts, never);
    return counts.primary;
  };
  CHECK(samples(2, {}) == 1);
  CHECK(samples(7, {}) == 4);
  CHECK(samples(7, AntiAliasing::none) == 1);
  CHECK(samples(2, AntiAliasing::grid4) == 4);
  CHECK(samples(2, AntiAliasing::rotated4) == 4);
  CHECK(samples(3, AntiAliasing::grid16) == 16);
  CHECK(samples(7, AntiAliasing::grid64) == 64);
}

TEST_CASE("driver: sample patterns lie evenly in the pixel", "[driver]") {
  for (const AntiAliasing pattern :
       {AntiAliasing::none, AntiAliasing::grid4, AntiAliasing::rotated4, AntiAliasing::grid16, AntiAliasing::grid64}) {
    double x = 0, y = 0;
    for (const SampleOffset& offset : sample_offsets(pattern)) {
      x += offset.dx;
      y += offset.dy;
      CHECK(std::max(std::abs(offset.dx), std::abs(offset.dy)) < 0.5);
    }
    CHECK(x == 0);
    CHECK(y == 0);
  }
  CHECK(sample_offsets(AntiAliasing::grid4)[0].dx == -0.25);  // from the top left
  CHECK(sample_offsets(AntiAliasing::grid4)[0].dy == 0.25);
}

TEST_CASE("driver: the clamp comes last", "[driver]") {
  Scene scene;
  scene.planes = {wall(-1, Color(3, 0.5, 1))};
  CHECK(look(scene, 2) == Color(1, 0.5, 1));
}

TEST_CASE("driver: any number of threads gives the same bits, in order", "[driver]") {
  Scene scene;
  scene.planes = {wall(-9, Color(0.2, 0.4, 0.6), 100)};
  scene.spheres = {ball({-1, 0, -5}, 1.2, red, 500), glass({1, 0.5, -4}, 0.8)};
  scene.point_lights = {{{2, 4, 1}, 40}};
  const Settings settings{7, {45, 37}, 4, {}};
  const std::vector<Color> alone = render_all(scene, settings, 1);
  CHECK(alone.size() == 45 * 37);
  CHECK(render_all(scene, settings, 2) == alone);
  CHECK(render_all(scene, settings, 7) == alone);
}

TEST_CASE("driver: a render stops soon after it is asked to", "[driver]") {
  Scene scene;
  scene.planes = {wall(-9, Color(1), 1000)};
  std::atomic<bool> cancel = false;
  std::chrono::steady_clock::time_point asked;
  const Settings settings{7, {4000, 4000}, 5, AntiAliasing::grid64};
  const auto engine = make_stages(scene, settings, table());
  std::thread later([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    asked = std::chrono::steady_clock::now();
    cancel = true;
  });
  CHECK_THROWS_AS(render(
                      *engine, settings.size, 2, [](int, std::span<const Color>) {}, [](double) {}, cancel),
                  Cancelled);
  const auto ended = std::chrono::steady_clock::now();
  later.join();
  CHECK(ended - asked < std::chrono::seconds(1));  // tests/cli_test.sh asks for 0.2 s of the whole program
}

TEST_CASE("driver: what a task or the sink throws comes out of render()", "[driver]") {
  const Scene scene;
  StageTable broken = table();
  broken.camera_ray = [](const Camera&, int, int, double, double, double, double) -> Ray { throw NotWritten("not yet"); };
  const Settings settings{1, {8, 8}, 5, {}};
  const auto nothing = [](int, std::span<const Color>) {};
  CHECK_THROWS_AS(render(
                      *make_stages(scene, settings, broken), {8, 8}, 2, nothing, [](double) {}, never),
                  NotWritten);
  CHECK_THROWS_AS(render(
                      *make_stages(scene, settings, table()), {8, 8}, 2,
                      [](int, std::span<const Color>) { throw std::runtime_error("disk full"); }, [](double) {}, never),
                  std::runtime_error);
}

TEST_CASE("driver: a choice of nearest hit that is none is named", "[driver]") {
  Scene scene;
  scene.planes = {wall(1, red)};  // behind the camera
  StageTable wrong = table();
  wrong.nearest_hit = [](std::span<const Candidate>) { return std::optional<std::size_t>(0); };
  RayCounts counts;
  Color pixel(0);
  CHECK_THROWS_WITH(make_stages(scene, {2, {1, 1}, 5, {}}, wrong)->trace_rows(0, {&pixel, 1}, counts, never),
                    ContainsSubstring("task 2.4 nearest_hit chose place 0 (from 0) of a list of 1"));
}

TEST_CASE("driver: pixels that are no numbers are counted", "[driver]") {
  StageTable wrong = table();
  wrong.camera_ray = [](const Camera&, int, int, double x, double, double, double) {
    return Ray{{0, 0, 0}, {x > 0 ? std::nan("") : 0, 0, -1}, {}};
  };
  const Scene scene;
  const RenderTotals totals = render(
      *make_stages(scene, {1, {4, 80}, 5, {}}, wrong), {4, 80}, 3, [](int, std::span<const Color>) {}, [](double) {}, never);
  CHECK(totals.non_finite_pixels == 160);
  REQUIRE(totals.first_non_finite);
  CHECK(totals.first_non_finite->column == 2);
  CHECK(totals.first_non_finite->row == 0);
  CHECK(totals.rays.primary == 320);
}

TEST_CASE("stage table: tasks mix by stage and by label", "[driver]") {
  StageTable other = table();
  other.reflect = [](const Vec3&, const Vec3&) { return Vec3(9); };
  other.go_on = [](int, int, double) { return false; };
  StageTable one = table(), stage = table();
  mix(one, other, "5.1");
  CHECK(one.reflect == other.reflect);
  CHECK(one.go_on == table().go_on);
  mix(stage, other, "5");
  CHECK(stage.reflect == other.reflect);
  CHECK(stage.go_on == other.go_on);
  CHECK_THROWS_AS(mix(one, other, "5.9"), std::invalid_argument);
  CHECK_THROWS_AS(mix(one, other, ""), std::invalid_argument);
}

TEST_CASE("stage table: every task's label has the number of its stage, in order", "[driver]") {
  std::pair last(0, 0);
  for (const TaskInfo& task : task_list()) {
    const std::string label(task.label);
    const std::pair number(stage_of(label), std::stoi(label.substr(label.find('.') + 1)));
    CHECK(number.first <= static_cast<int>(stage_list().size()));
    CHECK(number > last);
    last = number;
  }
}

TEST_CASE("driver: shadows do not depend on the size of the scene", "[driver]") {
  for (const double scale : {1e-60, 1e-11, 1.0, 1e50}) {
    Scene scene;
    scene.planes = {wall(-3 * scale, Color(1))};
    scene.spheres = {ball({0, 3 * scale, -1 * scale}, 0.5 * scale, red)};
    scene.point_lights = {{{0, 6 * scale, 1 * scale}, 64}};
    CHECK(look(scene, 4) == Color(0));
  }
}

TEST_CASE("unit: has length 1 for any length but zero, which it keeps", "[math]") {
  for (const double size : {5e-324, 1e-310, 1e-200, 1.0, 1e200, 1.7e308}) {
    CHECK(unit(Vec3(0, -size, 0)) == Vec3(0, -1, 0));
    CHECK(length(unit(Vec3(size, size, -size))) == within(4e-16, 1.0));
  }
  CHECK(unit(Vec3(0)) == Vec3(0));
  CHECK(std::isnan(unit(Vec3(std::nan(""), 1, 0)).y));
}

TEST_CASE("driver: a lamp in a ceiling lights the floor without a speck", "[driver]") {
  for (const Vec3& normal : {Vec3(0, -1, 0), Vec3(0.3, -1, 0.2)}) {
    Scene scene;
    scene.camera = {{0, 1, 5}, {0, -0.6, -1}, {0, 1, 0}, 30};
    scene.planes = {{{{0, 0, 0}, {0, 1, 0}}, {Color(0.8), 0, false, 1.5}},
                    {{{0.31, 2.7, 0.2}, normal}, {Color(0.8), 0, false, 1.5}}};
    scene.point_lights = {{{0.31, 2.7, 0.2}, 20}};
    const std::vector<Color> lit = render_all(scene, {3, {48, 36}, 0, {}}, 2);
    CHECK(render_all(scene, {4, {48, 36}, 0, {}}, 2) == lit);
  }
}

TEST_CASE("driver: more threads than the image has rows, or than the system gives, do no harm", "[driver]") {
  Scene scene;
  scene.background = green;
  CHECK(render_all(scene, {2, {3, 20}, 0, {}}, 1000).size() == 60);
}
