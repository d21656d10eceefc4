// What textbook formulas make of the scenes of scenes/hard, beside the oracle and the engine. Prints the page
// docs/hard_scenes.md; exit code 1 if a verdict of the page does not hold: that the textbook is wrong there, and the engine
// in double is not.
//   raylab-hard-scenes [FOLDER]      writes the page's pictures too

#include "bench/variants/handout_renderer.hpp"
#include "core/image/diff.hpp"
#include "core/image/diff_pictures.hpp"
#include "core/image/image_file.hpp"
#include "reference/engine/engine.hpp"
#include "tests/subjects.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

using namespace raylab;
using namespace raylab::test;
using namespace raylab::bench;

namespace {

constexpr double visible = 4.0 / 255;      // of a component
constexpr double wrong_share = 0.03;       // of the pixels, visibly off: nobody overlooks them
constexpr double right_share = 0.001;      // the same as in docs/tolerance.md
constexpr double largest_of_right = 1e-7;  // for the engine in double, on every pixel; half of it is the references' storing

const char* const introduction = R"(# The hard scenes

Whole pictures that rounding spoils: what textbook formulas make of them in `double` and `float`, and what cures it. The scenes are in
[`scenes/hard`](../scenes/hard), with a reference each, at the last stage. They are for comparing arithmetic: nobody's program is graded
with them, and [the calibration](calibration.md) leaves them out.

*The textbook* is the renderer of `bench/variants/handout_renderer.cpp`, which is right on all other scenes, in `float` too: `b^2 - 4ac` with
`c = |o - C|^2 - R^2`, rays that start an epsilon of 0.001 off their surface, angles by `acos` and `asin`. *The engine* is the fast one
([its formulas](engine.md)). Each picture shows, from the left: the oracle's reference, the textbook in `double` and in `float`, the engine
in `float`. The engine in `double` cannot be told from the oracle.

| column | |
|---|---|
| off | pixels with a component that is off by more than 4 of 255 levels |
| beyond | pixels that are not in their range at the [tolerance](tolerance.md) for `float`; those near decisions, which `raylab diff` lets pass, count |
| largest error, PSNR | against the reference, which is stored in `float`: 3e-8 and about 155 dB are nothing but that |

    build/release/bin/raylab-hard-scenes docs/images/hard >docs/hard_scenes.md

`ctest` runs the same without the pictures, and fails unless the textbook is wrong where this page says so, in 3 % of the pixels, right where
it says so, and the engine in `double` right to 1e-7 in every pixel of every scene.
)";

/// A scene, and what the page says of it.
struct HardScene {
  const char* name;
  bool hard_in_double;  ///< for the textbook; in float each is
  const char* text;
};

// In the order of the page.
const std::vector<HardScene> hard_scenes{
    {"giant_floor", true, R"(**A floor that is a giant ball**, of radius 1e14, seen from 1.2 above.

*What goes wrong.* `c = |o - C|^2 - R^2` should be 2.4e14 at the camera, and 0 on the floor. It is computed from squares of 1e28, which a
`double` knows to 1e12 and a `float` to 1e21. So the floor is met at a wrong distance, and a shadow ray that starts 0.001 above the floor
cannot know on which side of it that is: all lies in shadow.

*What cures it.* The same `c`, without error: what each difference, square and sum rounds off is computed too, and added at the end.
That is `gap_to_sphere()` in `reference/engine/kernel/exact.hpp`, used where a ray starts near a surface (`meet()` in
`kernel/intersect.hpp`), and `height_above()` in `reference/solution/02_intersections.cpp`. And no epsilon: a ray knows what it leaves
([D6](errata.md#d6)).)"},
    {"far_spheres", true,
     R"(**Twelve equal shadows**, of balls that are 0.7 off the wall at twelve o'clock, and ten times as far at each hour after.

*What goes wrong.* `b^2 - 4ac` is `4 (R^2 - p^2)`, where `p` is how far from the center the ray passes. It is at most 0.36 here. It comes as a
difference of numbers near `4 D^2`, and with the distance `D` at 7e7 these are 2e16, which a `double` knows to 4. Half of all rays
seem to hit, wherever they go: the far balls darken the whole wall. In `float` those at 7e3 do so already.

*What cures it.* `R^2 - |p|^2` from the vector `p = f - (f.d) d` itself, with `f = o - C`: its error grows with `D`, and not with `D^2`.
That is `pass()` in `reference/engine/kernel/intersect.hpp`, and `sphere_hit()` in `reference/solution/02_intersections.cpp`. In `float` the
engine is right up to six o'clock; from eight on the balls' centers are rounded by more than their radius before any formula sees them.

(*Beyond* is nearly 0 here: the oracle finds that nearly all pixels hang on the rounding of rays. Rounded directions are no unit vectors any more,
which loses balls at such distances for its own `b^2 - c`, too.))"},
    {"facing_giants", true, R"(**Two mirrors face each other**, balls of radius 3e13 that are 6 apart; up to 30 bounces.

*What goes wrong.* What the giant floor does, at each bounce again: reflected rays find the mirror that they leave still before them, or
start behind the other. In `float` the room is not even there: 3e13 and 3e13 + 3 are the same number.

*What cures it.* The exact `c`, as above, and rays that know what they leave: `first_hit()` and `ask_all()` in `core/render/driver.hpp`,
`kernel/nearest.hpp` in the engine. Solution and engine then agree to 1e-13 after thirty bounces.)"},
    {"grazing_light", true, R"(**Grazing light**, from 1e-12 degrees above the horizon.

*What goes wrong.* A computed point of the floor lies some 1e-16 (in `float` 1e-7) above or below it. From below, the shadow ray meets the
floor on its way up. An epsilon of 0.001 along the ray lifts its start by 2e-17, which is not enough. One of 0.1 would be, in `double`, and
would lose the shadows of what is near; in `float` it takes 1e7.

*What cures it.* A plane never shadows its own points: the ray knows what it leaves ([D6](errata.md#d6)), in `core/render/driver.hpp` and
`reference/engine/kernel/shadow.hpp`. On which side of a plane a light is, is decided once, from the scene's own numbers: `sides_of()` in
`reference/engine/prepared.cpp`.)"},
    {"touching_inside", false,
     R"(**Balls that touch from inside**: each has a core and a coat, which has no thickness at one point that we see.

*What goes wrong.* Coat and core are met at distances near 63 that differ by less than 7e-4. In `float` the textbook's `t = (-b - sqrt(b^2 -
4ac))/2a` is wrong by as much, and the core is nearer by chance. In `double` it is wrong by 1e-12, and nothing is seen.

*What cures it.* The distance to the ray's foot, `-f.d`, less half the chord, `sqrt(R^2 - |p|^2)`: its error is some units in the last place
of the distance. That is `meet()` in `reference/engine/kernel/intersect.hpp`. In `float` a spot is left around the point where they touch:
there the coat is thinner than floats are apart.)"},
    {"snell_window", false, R"(**Snell's window**: a lake's surface from below, which is a glass ball of radius 2500.

*What goes wrong.* Near the critical angle the refracted ray runs along the surface, and so do rays that are reflected far away. An epsilon of
0.001 along them lifts them off by less than the 1e-4 by which a `float` `c` misses the surface: they meet it again, and are refracted or
reflected a second time.

*What cures it.* A ray that leaves the ball outwards never meets it again, and one that leaves it inwards meets the far side, at `-2 f.d`:
`far_side()` in `reference/engine/kernel/intersect.hpp` and in `core/render/driver.hpp`. The exit ray itself takes no angle
(`kernel/glass.hpp`).)"},
    {"telescope", true, R"(**Through a telescope**: a table 3e7 away, and half a field of view of 7e-6 degrees.

*What goes wrong.* In `double` what the far shadows show, here at the first hit: `b^2 - 4ac` is off by about 1, and `4 R^2` is 4 for a ball of
radius 1. In `float` it is worse: the whole picture is 1.8e-7 high, and the components of its rays, near 0.26 and 0.97, are 3e-8 and 6e-8 from the
next ones, so there are a handful of different rows.

*What cures it.* `pass()`, as above. For the engine in `float` there is none: its points are 2 apart where the balls are. (For *beyond*, what is said of the
far balls holds here, too.)"},
    {"wide_wall", false, R"(**A shadow theater, seen from the first row**: 89.9999999 degrees to each side.

*What goes wrong.* The nearest `float` to 89.9999999 is 90, and in radians it is a little more than a right angle. So `tan(theta)` is not 5.7e8
but -2.3e7, and the picture is upside down and 25 times too large.

*What cures it.* Angles and whatever else is made once for the picture are computed in `double`, and what comes out is rounded:
`prepare_camera()` in `reference/engine/prepared.cpp`. The step from pixel to pixel is then right to 6e-8, for a `float`.)"},
    {"huge_coordinates", false, R"(**A million units off** the origin in all three coordinates.

*What goes wrong.* Floats are 1/16 apart there. The epsilon of 0.001 vanishes when it is added to a point, and the point is as likely in the
ball as out of it: rings and steps of shadow. In `double`, 1e-10 apart, the textbook is right.

*What cures it.* No epsilon, so that no surface shadows itself. And a change of place: for a camera that is far from zero the engine subtracts
its position from all others, in `double`, before it rounds them to `float`: `origin_of()` in `reference/engine/prepared.cpp`.)"},
};

struct Renderer {
  const char* name;
  MakeEngine make;
};

MakeEngine textbook(bool single_precision) {
  Variant variant;
  variant.single_precision = single_precision;
  variant.shadow_shift = variant.bounce_shift = 0.001;
  variant.black_rim = true;
  const HandoutBuild build = handout_builds().front();
  return [=](const Scene& scene, const Settings& settings) { return build.make(scene, settings, variant); };
}

MakeEngine engine(Precision precision) {
  return [=](const Scene& scene, const Settings& settings) { return make_fast(scene, settings, {precision}); };
}

enum Who : std::size_t { textbook_double, textbook_float, engine_float, engine_double };
const std::array<Renderer, 4> renderers{{{"textbook, double", textbook(false)},
                                         {"textbook, float", textbook(true)},
                                         {"engine, float", engine(Precision::f32)},
                                         {"engine, double", engine(Precision::f64)}}};

/// What each of the renderers makes of a scene.
struct Trial {
  std::array<Image, renderers.size()> images;
  std::array<Comparison, renderers.size()> comparisons;
};

Trial tried(const Subject& subject) {
  Trial trial;
  for (std::size_t k = 0; k < renderers.size(); ++k) {
    trial.images[k] = rendered(subject, renderers[k].make);
    trial.comparisons[k] = compare(trial.images[k], NumberFormat::float64, subject.reference);
  }
  return trial;
}

double share(std::size_t count, const Comparison& comparison) {
  return static_cast<double>(count) / static_cast<double>(comparison.error.size());
}

double off(const Comparison& comparison) {
  const auto count = std::count_if(comparison.error.begin(), comparison.error.end(), [](double e) { return e > visible; });
  return share(static_cast<std::size_t>(count), comparison);
}

/// That rounding may decide a pixel is no excuse here: it is what is shown.
double beyond(const Comparison& comparison) { return share(comparison.outside + comparison.at_decision, comparison); }

bool holds(const HardScene& scene, const Trial& trial) {
  const double in_double = off(trial.comparisons[textbook_double]), in_float = off(trial.comparisons[textbook_float]);
  const Comparison& fast = trial.comparisons[engine_double];
  return in_float >= wrong_share && (scene.hard_in_double ? in_double >= wrong_share : in_double <= right_share) &&
         beyond(fast) == 0 && fast.non_finite == 0 && fast.max_error <= largest_of_right;
}

void write_picture(const std::filesystem::path& folder, const Subject& subject, const Trial& trial) {
  std::vector<Panel> panels{{"oracle", subject.reference.value}};
  for (const Who who : {textbook_double, textbook_float, engine_float})
    panels.push_back({renderers[who].name, trial.images[who]});
  write_image(folder / (subject.scene + ".png"), in_a_row(panels));
}

void print(const HardScene& scene, const Trial& trial) {
  std::cout << "\n## " << scene.name << "\n\n![The reference, and three renders](images/hard/" << scene.name << ".png)\n\n"
            << scene.text << "\n\n| [" << scene.name << "](../scenes/hard/" << scene.name
            << ".toml) | off | beyond | largest error | PSNR |\n|---|---|---|---|---|\n";
  for (std::size_t k = 0; k < renderers.size(); ++k) {
    const Comparison& c = trial.comparisons[k];
    std::array<char, 128> row;
    std::snprintf(row.data(), row.size(), "| %s | %.2f %% | %.2f %% | %.1e | %.1f dB |\n", renderers[k].name, 100 * off(c),
                  100 * beyond(c), c.max_error, c.psnr);
    std::cout << row.data();
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 2 || (argc > 1 && argv[1][0] == '-')) {
    std::cerr << "usage: raylab-hard-scenes [FOLDER-FOR-PICTURES]\n";
    return 2;
  }
  const std::vector<Subject> subjects = load_subjects(true);
  bool all_hold = true;
  const auto fail = [&](const std::string& sentence) {
    std::cerr << "FAILED: " << sentence << '\n';
    all_hold = false;
  };
  std::cout << introduction;
  for (const HardScene& scene : hard_scenes) {
    const auto subject =
        std::find_if(subjects.begin(), subjects.end(), [&](const Subject& s) { return s.scene == scene.name; });
    if (subject == subjects.end()) {
      fail(std::string(scene.name) + " has no reference");
      continue;
    }
    const Trial trial = tried(*subject);
    print(scene, trial);
    if (argc > 1) write_picture(argv[1], *subject, trial);
    if (!holds(scene, trial)) fail(std::string("what the page says of ") + scene.name + " does not hold");
  }
  if (subjects.size() > hard_scenes.size()) fail("a scene of scenes/hard is not on the page");
  return all_hold ? 0 : 1;
}
