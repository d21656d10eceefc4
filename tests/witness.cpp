// The oracle's word on a pixel: margin, sensitivity, ranges, both ways to clamp. Scenes of one pixel, with answers by hand.

#include "core/scene/read_scene.hpp"
#include "reference/oracle/oracle.hpp"
#include "tests/support.hpp"

#include <atomic>
#include <string>
#include <vector>

using namespace raylab;
using namespace raylab::test;

namespace {

/// Looks from (0, 0, 5) along -z, with one pixel.
PixelWord word(const std::string& toml, int stage, int max_bounces = 5) {
  const std::string head =
      "background = [0.25, 0.5, 0.75]\n[camera]\nposition = [0, 0, 5]\nfacing = [0, 0, -1]\nup = [0, 1, 0]\n[image]\nwidth "
      "= 1\nheight "
      "= 1\n";
  const SceneFile file = parse_scene(head + toml, "scene.toml");
  REQUIRE(file.scene.has_value());
  std::vector<PixelWord> words(1);
  std::vector<Color> pixels(1);
  RayCounts counts;
  const std::atomic<bool> never = false;
  make_witness(*file.scene, {stage, {1, 1}, max_bounces, AntiAliasing::none}, words, 1)
      ->trace_rows(0, pixels, counts, never);
  CHECK((pixels[0] == words[0].together.value));
  return words[0];
}

std::string sphere(const std::string& center, const std::string& radius, const std::string& more = "") {
  return "[[sphere]]\ncenter = " + center + "\nradius = " + radius + "\ncolor = [1, 1, 1]\n" + more;
}
const std::string floor_below = "[[plane]]\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\ncolor = [1, 1, 1]\n";  // below the camera
/// A place so far from the origin, up and to the right, where the camera does not see it before the floor.
std::string on_the_way(double distance) {
  const std::string x = text(distance * std::sqrt(0.5));
  return "[" + x + ", 0, " + x + "]";
}
std::string lamp_at(double distance) { return "[[point_light]]\nposition = " + on_the_way(distance) + "\nintensity = 9\n"; }
const std::string lamp_above = "[[point_light]]\nposition = [0, 0, 2]\nintensity = 9\n";  // gives 1 at the origin

}  // namespace

TEST_CASE("witness: a ray that hits a sphere has the slack of its discriminant", "[witness]") {
  const PixelWord hit = word(sphere("[0.6, 0, 0]", "1"), 2);
  CHECK(hit.margin == within(1e-14, 1 - 0.36));  // disc / R^2
  CHECK(hit.object == 0);
  const PixelWord passes = word(sphere("[2.2, 0, 0]", "2"), 2);
  CHECK(passes.margin == within(1e-14, 1.1 * 1.1 - 1));
  CHECK(passes.object == no_geometry);
}

TEST_CASE("witness: what cannot become visible has no say", "[witness]") {
  const std::string wall = "[[plane]]\npoint = [0, 0, 1]\nnormal = [0, 0, 1]\ncolor = [1, 1, 1]\n";
  CHECK(word(wall + sphere("[1, 0, -3]", "1"), 2).margin == within(1e-14, 0.5));  // grazed, but 4 behind the wall: (8 - 4)/8
  CHECK(word(sphere("[1, 0, 9]", "1"), 2).margin == within(1e-14, 0.8));          // grazed 4 behind the camera at z = 5
}

TEST_CASE("witness: two surfaces at nearly one distance are a decision", "[witness]") {
  const std::string walls =
      "[[plane]]\npoint = [0, 0, 1]\nnormal = [0, 0, 1]\ncolor = [1, 1, 1]\n[[plane]]\npoint = [0, 0, 0.5]\nnormal = [0, 0, "
      "1]\ncolor "
      "= [0, 1, 1]\n";
  CHECK(word(walls, 2).margin == within(1e-14, 0.5 / 4.5));
}

TEST_CASE("witness: a grazing plane is a decision, and a parallel one where nothing is nearer", "[witness]") {
  const auto floor = [](const std::string& normal) {
    return "[[plane]]\npoint = [0, -1, 0]\nnormal = " + normal + "\ncolor = [1, 1, 1]\n";
  };
  CHECK(word(floor("[0, 1, 0]"), 2).margin == 0);
  CHECK(word(floor("[0, 4, 3]"), 2).margin == within(1e-14, 0.6));  // behind
  CHECK(word(floor("[0, 1, 0]") + sphere("[0, 0, 0]", "1"), 2).margin > 0.2);
}

TEST_CASE("witness: the terminator is a decision where there is a highlight", "[witness]") {
  const std::string light = "[[directional_light]]\ndirection = [1, 0, -0.001]\nintensity = 1\n";
  const std::string floor = floor_below;
  CHECK(word(floor + light, 3).margin > 0.9);
  CHECK(word(floor + "shininess = 50\n" + light, 3).margin == within(1e-6, 0.001));
}

TEST_CASE("witness: near total reflection is a decision", "[witness]") {
  // From inside a sphere of index 2 the ray of this pixel meets the surface at sin = 0.5, the critical angle.
  const PixelWord glass = word(sphere("[1, 0, 5]", "2", "transparent = true\nrefractive_index = 2.0\n"), 6);
  CHECK(glass.margin < 1e-15);
}

TEST_CASE("witness: shadow shifts leap over near blockers", "[witness]") {
  const auto lit = [](const std::string& blocker) { return word(floor_below + lamp_at(2) + blocker, 4).together; };
  const double bright = std::sqrt(0.5);  // L.N
  const ColorRange bead = lit(sphere(on_the_way(0.05), "0.02"));
  CHECK(bead.value.r == 0);
  CHECK(bead.least.r == 0);
  CHECK(bead.greatest.r == within(1e-14, bright));
  const ColorRange ball = lit(sphere(on_the_way(0.15), "0.1"));  // its far side blocks from within
  CHECK(ball.value.r == 0);
  CHECK(ball.greatest.r == 0);
  const ColorRange none = lit("");
  CHECK(none.value.r == within(1e-14, bright));
  CHECK(none.least == none.value);
  CHECK(none.greatest == none.value);
}

TEST_CASE("witness: a lamp nearer than the shift is lit, and one behind a bead may be", "[witness]") {
  const ColorRange range = word(floor_below + lamp_at(0.08) + sphere(on_the_way(0.05), "0.02"), 4).together;
  CHECK(range.value.r == 0);
  CHECK(range.greatest.r == 1);  // more, and clamped
}

TEST_CASE("witness: bounce shifts leap over what is nearer than 0.001", "[witness]") {
  // The mirror sends the ray back up, to a sheet 0.0005 above, or else, with a shift, to the background.
  const std::string sheet = "[[plane]]\npoint = [0, 0, 4.0005]\nnormal = [0, 0, 1]\ncolor = [1, 0, 0]\n";
  const std::string mirror = "[[plane]]\npoint = [0, 0, 4]\nnormal = [0, 0, 1]\ncolor = [0, 0, 0]\nshininess = inf\n";
  const std::string from_between =
      "[camera]\nposition = [0, 0, 4.0002]\nfacing = [0, 0, -1]\nup = [0, 1, 0]\n[image]\nwidth = 1\nheight = 1\n";
  const SceneFile file = parse_scene(
      "background = [0.25, 0.5, 0.75]\n" + from_between + sheet + mirror + "[[ambient_light]]\nintensity = 1\n", "s.toml");
  REQUIRE(file.scene.has_value());
  std::vector<PixelWord> words(1);
  std::vector<Color> pixels(1);
  RayCounts counts;
  const std::atomic<bool> never = false;
  make_witness(*file.scene, {5, {1, 1}, 5, {}}, words, 1)->trace_rows(0, pixels, counts, never);
  CHECK(words[0].together.value == within(1e-14, Color(1, 0, 0)));
  // A lift leaps over it, too, and the parabola through the lifts overshoots a jump by less than a fifth.
  const Color& least = words[0].together.least;
  const Color& greatest = words[0].together.greatest;
  CHECK(least.r <= 0.25 + 1e-14);
  CHECK(least.r > 0.25 - 0.75 / 5);
  CHECK((least.g == 0 && least.b == 0));
  CHECK(greatest.r == within(1e-14, 1.0));
  CHECK(greatest.g >= 0.5 - 1e-14);
  CHECK(greatest.g < 0.5 + 0.5 / 5);
  CHECK(greatest.b >= 0.75 - 1e-14);
  CHECK(greatest.b < 0.75 + 0.75 / 5);
}

TEST_CASE("witness: starts lifted along the normal move what a mirror shows", "[witness]") {
  // A mirror tilted by 45 degrees sends the ray along x, to a wall that a lamp above it lights by height.
  const std::string mirror = "[[plane]]\npoint = [0, 0, 0]\nnormal = [1, 0, 1]\ncolor = [0, 0, 0]\nshininess = inf\n";
  const std::string wall = "[[plane]]\npoint = [2, 0, 0]\nnormal = [-1, 0, 0]\ncolor = [1, 1, 1]\n";
  const std::string lamp = "[[point_light]]\nposition = [1, 0, 1]\nintensity = 1\n";
  const ColorRange range = word(mirror + wall + lamp, 5, 1).together;
  const auto on_wall = [](double height) {
    const double r = std::hypot(1, 1 - height);
    return 1 / r / (1 + r) / (1 + r);
  };
  CHECK(range.value.r == within(1e-14, on_wall(0)));
  CHECK(range.least.r == within(1e-14, on_wall(0)));
  CHECK(range.greatest.r == within(1e-14, on_wall(0.001 * std::sqrt(0.5))));
}

TEST_CASE("witness: each dot product clamped by itself lets a highlight through from below", "[witness]") {
  const std::string floor = "[[plane]]\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\ncolor = [1, 1, 1]\nshininess = 4\n";
  const std::string from_below = "[[directional_light]]\ndirection = [1, 0, 0.1]\nintensity = 1\n";
  const PixelWord shaded = word(floor + from_below, 3);
  CHECK(shaded.together.value.r == 0);
  CHECK(shaded.each.value.r > 1e-4);
  CHECK(shaded.each.least == shaded.each.value);
  const PixelWord shadowed = word(floor + from_below, 4);  // some ask for the shadow there
  CHECK(shadowed.each.value == shaded.each.value);
  CHECK(shadowed.each.least.r == 0);
  const PixelWord from_above = word(floor + lamp_above, 3);
  CHECK(from_above.each.value == from_above.together.value);
}

TEST_CASE("witness: sensitivity is what rounding does", "[witness]") {
  CHECK(word(floor_below, 1).sensitivity <= 0x1p-53);
  CHECK(word("", 2).sensitivity == 0);
  const std::string near_ball = sphere("[0.3, 0.2, 0]", "0.5", "shininess = inf\n");
  const std::string lit_wall =
      "[[plane]]\npoint = [0, 0, 9]\nnormal = [0, 0, 1]\ncolor = [1, 1, 1]\n[[ambient_light]]\nintensity = 0\n";
  const std::string lamp = "[[point_light]]\nposition = [0, 0, 8.5]\nintensity = 1\n";
  const double once = word(near_ball + lit_wall + lamp, 5).sensitivity;
  CHECK(once > 1e-18);
  CHECK(once < 1e-13);
}

TEST_CASE("witness: a sample of the pixels is evenly spread", "[witness]") {
  int sampled = 0;
  for (int row = 0; row < 120; ++row) {
    int in_row = 0;
    for (int column = 0; column < 160; ++column) in_row += is_sampled(column, row, 16) ? 1 : 0;
    CHECK(in_row == 10);
    sampled += in_row;
  }
  CHECK(sampled == 120 * 160 / 16);
}
