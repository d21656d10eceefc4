// The fast engine: the same bits from every instruction set, with a hierarchy and without, in any number of threads.

#include "reference/engine/engine.hpp"
#include "core/image/data_folder.hpp"
#include "core/render/render.hpp"
#include "core/render/stages_engine.hpp"
#include "core/scene/read_scene.hpp"
#include "reference/engine/hierarchy.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <vector>

using namespace raylab;
using namespace raylab::test;

namespace {

/// The bits of an image, a NaN included.
std::vector<std::uint64_t> bits_of(const Engine& engine, ImageSize size, unsigned threads = 1) {
  const Image image = render_image(engine, size, threads);
  std::vector<std::uint64_t> bits;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      for (int c = 0; c < 3; ++c) bits.push_back(std::bit_cast<std::uint64_t>(image.at(x, y)[c]));
  return bits;
}

/// Every way to run the engine against a single number at a time without a hierarchy.
void check_same_bits(const Scene& scene, const Settings& settings) {
  for (const Precision precision : {Precision::f32, Precision::f64}) {
    const auto expected = bits_of(*make_fast(scene, settings, {precision, "scalar", false, 1}), settings.size);
    for (const SimdTarget& target : simd_targets())
      for (const bool hierarchy : {false, true}) {
        INFO(target.name << (precision == Precision::f32 ? " f32" : " f64") << (hierarchy ? " hierarchy" : ""));
        const auto engine = make_fast(scene, settings, {precision, std::string(target.name), hierarchy, 2});
        CHECK(bits_of(*engine, settings.size, hierarchy ? 3 : 1) == expected);
      }
  }
}

Color random_color(Random& random) { return 0.5 * (random.point(1) + Vec3(1)); }

void add_lights(Scene& scene, double size) {
  scene.point_lights = {{{2 * size, 3 * size, 2 * size}, 9 * size * size}, {{-size, size, size}, 3 * size * size}};
  scene.directional_lights = {{{0.3, -1, -0.2}, 0.4}};
  scene.ambient_lights = {{0.1}};
}

/// A camera before a heap of spheres of all sizes, of every kind, some within others, over a plane and a giant.
Scene heap(unsigned seed, double size, const Vec3& at) {
  Random random(seed);
  Scene scene;
  scene.background = {0.1, 0.2, 0.3};
  scene.camera = {at + Vec3(0, 0.3 * size, 2.5 * size), {0, -0.1, -1}, {0, 1, 0}, 40};
  scene.planes = {{{at - Vec3(0, 1.4 * size, 0), {0.1, 1, 0}}, {Color(0.6), 40, false, 1.5}}};
  scene.spheres = {{{at - Vec3(0, 300 * size, 0), 298.7 * size}, {Color(0.4, 0.5, 0.3), 100, false, 1.5}}};
  for (int i = 0; i < 40; ++i) {
    const bool glass = i % 3 != 0;
    scene.spheres.push_back({{at + random.point(size), size * random.between(0.05, 0.25)},
                             {random_color(random), random.between(0, 900), glass, random.between(0.7, 1.8)}});
  }
  SphereCloud cloud;
  cloud.material = {Color(0.8), 200, false, 1.5};
  for (int i = 0; i < 500; ++i) {
    cloud.spheres.push_back({at + random.point(size), size * std::exp(random.between(-6, -2))});
    cloud.colors.push_back(random_color(random));
  }
  // Twins of another color, of which the first must win.
  for (std::size_t i = 0; i < 60; ++i) {
    cloud.spheres.push_back(cloud.spheres[3 * i]);
    cloud.colors.push_back(random_color(random));
  }
  scene.clouds = {cloud};
  add_lights(scene, size);
  for (PointLight& light : scene.point_lights) light.position += at;
  return scene;
}

std::vector<std::filesystem::path> all_scenes() {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(data_folder("scenes")))
    if (entry.path().extension() == ".toml") paths.push_back(entry.path());
  return paths;
}

std::vector<Sphere> random_spheres(std::size_t count, unsigned seed) {
  Random random(seed);
  std::vector<Sphere> spheres;
  for (std::size_t i = 0; i < count; ++i) spheres.push_back({random.point(1), std::exp(random.between(-9, -1))});
  return spheres;
}

/// Goes through a hierarchy and checks that each box holds what is below it, and that each sphere is in one leaf.
class HierarchyCheck {
 public:
  HierarchyCheck(const std::vector<Sphere>& spheres, fast::Hierarchy& hierarchy)
      : spheres_(spheres), order_(hierarchy.take_order()), hierarchy_(hierarchy), seen_(spheres.size(), 0) {}

  void run() {
    visit(fast::Hierarchy::Child::node(0), 0);
    CHECK(std::all_of(seen_.begin(), seen_.end(), [](int times) { return times == 1; }));
    CHECK(wrong_ == 0);
    CHECK(deepest_ < fast::Hierarchy::deepest);
  }

 private:
  using Box = std::array<float, 6>;

  /// The spheres below a child; `inside` gets the boxes that they must be in.
  void visit(fast::Hierarchy::Child child, int depth) {
    deepest_ = std::max(deepest_, depth);
    if (child.is_leaf()) {
      for (std::size_t k = child.begin(); k < child.begin() + child.count(); ++k) check_sphere(order_[k]);
      return;
    }
    const fast::Hierarchy::Node& node = hierarchy_.nodes()[child.number()];
    for (std::size_t slot = 0; slot < fast::Hierarchy::width; ++slot) {
      Box box;
      for (std::size_t plane = 0; plane < 6; ++plane) box[plane] = node.planes[plane / 3][plane % 3][slot];
      inside_.push_back(box);
      visit(node.child[slot], depth + 1);
      inside_.pop_back();
    }
  }

  void check_sphere(std::size_t number) {
    ++seen_[number];
    const Sphere& sphere = spheres_[number];
    const std::array<double, 3> center = {sphere.center.x, sphere.center.y, sphere.center.z};
    for (const Box& box : inside_)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double c = center[axis] - hierarchy_.middle()[axis];
        wrong_ += !(box[axis] <= c - sphere.radius && box[3 + axis] >= c + sphere.radius);
      }
  }

  const std::vector<Sphere>& spheres_;
  const std::vector<std::uint32_t> order_;
  const fast::Hierarchy& hierarchy_;
  std::vector<int> seen_;
  std::vector<Box> inside_;
  int wrong_ = 0;
  int deepest_ = 0;
};

void check_hierarchy(const std::vector<Sphere>& spheres) {
  fast::Hierarchy hierarchy(spheres, fast::Hierarchy::Numbers::doubles, Vec3(0), 1);
  HierarchyCheck(spheres, hierarchy).run();
}

Scene one_sphere(const Sphere& sphere) {
  Scene scene;
  scene.camera = {{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 30};
  scene.spheres = {{sphere, {Color(1, 0, 0), 0, false, 1.5}}};
  return scene;
}

Color first_pixel(const Engine& engine) {
  Color pixel(0);
  RayCounts counts;
  const std::atomic<bool> never = false;
  engine.trace_rows(0, {&pixel, 1}, counts, never);
  return pixel;
}

}  // namespace

TEST_CASE("engine: every instruction set gives the same bits, on every scene", "[engine]") {
  for (const auto& path : all_scenes()) {
    INFO(path);
    const SceneFile file = read_scene(path);
    REQUIRE(file.scene.has_value());
    for (const int stage : {1, 2, 4, 7}) check_same_bits(*file.scene, {stage, {19, 11}, file.scene->max_bounces, {}});
  }
}

TEST_CASE("engine: the same bits with a hierarchy and without, in a heap of spheres", "[engine]") {
  for (unsigned seed = 1; seed <= 3; ++seed) check_same_bits(heap(seed, 1, {0, 0, 0}), {6, {61, 47}, 4, {}});
}

TEST_CASE("engine: the same bits with a hierarchy and without, far from zero, tiny and huge", "[engine]") {
  check_same_bits(heap(4, 1, {3e5, -2e5, 1e5}), {6, {41, 31}, 3, {}});
  check_same_bits(heap(5, 1e-6, {0, 0, 0}), {6, {41, 31}, 3, {}});
  check_same_bits(heap(6, 1e6, {1e9, 0, 0}), {6, {41, 31}, 3, {}});
}

TEST_CASE("engine: the same bits where float has few left, and near its limits", "[engine]") {
  check_same_bits(heap(13, 40, {2e7, 1e7, -3e7}), {4, {41, 31}, 2, {}});
  Scene scene = heap(14, 1e12, {0, 0, 0});
  for (PointLight& light : scene.point_lights) light.intensity = 1e15;
  scene.camera.position = {0, 0, 4e12};
  check_same_bits(scene, {4, {31, 21}, 2, {}});
}

TEST_CASE("engine: a light in the very point that it would light does not spoil its neighbors", "[engine]") {
  // In the middle of the picture a small ball with a lamp on it; around that, the wall that the lamp lights through a swarm.
  Scene scene;
  scene.camera = {{0, 0, 9}, {0, 0, -1}, {0, 1, 0}, 20};
  scene.planes = {{{{0, 0, -20}, {0, 0, 1}}, {Color(0.7), 20, false, 1.5}}};
  scene.spheres = {{{{0, 0, -1.0625}, 0.0625}, {Color(0.5), 20, false, 1.5}}};
  scene.point_lights = {{{0, 0, -1}, 300}};
  Random random(15);
  SphereCloud swarm;
  swarm.material = {Color(0.2), 0, false, 1.5};
  for (int i = 0; i < 200; ++i) {
    const Vec3 place = random.point(1);
    swarm.spheres.push_back({{place.x, place.y, -10 + 2 * place.z}, 0.05});
  }
  scene.clouds = {swarm};
  // Of this size the middle pixel is in the middle of a block of 4 x 4 and of 4 x 2.
  check_same_bits(scene, {5, {35, 35}, 2, {}});
}

TEST_CASE("engine: a plane so far away that float has no square of its distance is dark, not NaN", "[engine]") {
  Scene scene = one_sphere({{0, 0, -5}, 1});
  scene.camera.position = {0, 1e14, 0};
  scene.planes = {{{{0, 0, 0}, {0, 1, 1e-7}}, {Color(0.5), 20, false, 1.5}}};  // met after 1e21
  scene.point_lights = {{{0, 2e14, 0}, 1e15}};
  scene.ambient_lights = {{0.25}};
  for (const SimdTarget& target : simd_targets()) {
    const FastOptions options{Precision::f32, std::string(target.name)};
    CHECK(first_pixel(*make_fast(scene, {5, {1, 1}, 2, {}}, options)) == Color(0.125));
  }
}

TEST_CASE("engine: a lamp within a tilted plane does not light it, whatever the sign of the rounded L.N", "[engine]") {
  Scene scene;
  const Vec3 normal{1, 2, 2}, along{2, -2, 1};
  scene.camera = {{1, 5, 9}, {-0.2, -1, -0.9}, {0, 1, 0}, 30};
  scene.planes = {{{{0, -2, 0}, normal}, {Color(1), 20, false, 1.5}}};
  scene.point_lights = {{Vec3(0, -2, 0) + 0.7 * along, 100}};
  scene.ambient_lights = {{0.25}};
  constexpr ImageSize size{40, 30};
  for (const Precision precision : {Precision::f32, Precision::f64})
    for (const SimdTarget& target : simd_targets()) {
      const auto engine = make_fast(scene, {4, size, 2, {}}, {precision, std::string(target.name)});
      const Image image = render_image(*engine, size, 1);
      CHECK(std::count(image.pixels.begin(), image.pixels.end(), Color(0.25)) == 40 * 30);
    }
}

TEST_CASE("engine: more bounces than it has room for are refused", "[engine]") {
  const Scene scene = one_sphere({{0, 0, -5}, 1});
  CHECK_NOTHROW(make_fast(scene, {5, {1, 1}, 100, {}}, {}));
  CHECK_THROWS_WITH(make_fast(scene, {5, {1, 1}, 101, {}}, {}), Catch::Contains("max_bounces"));
}

TEST_CASE("engine: the same bits from a camera within the heap, looking along an axis", "[engine]") {
  Scene scene = heap(7, 1, {0, 0, 0});
  scene.camera = {{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 60};
  check_same_bits(scene, {6, {41, 41}, 3, {}});  // the middle pixel's ray has components of zero
}

TEST_CASE("engine: the same bits with each pattern of samples", "[engine]") {
  const Scene scene = heap(8, 1, {0, 0, 0});
  for (const AntiAliasing aa : {AntiAliasing::grid4, AntiAliasing::rotated4, AntiAliasing::grid16, AntiAliasing::adaptive})
    check_same_bits(scene, {5, {23, 19}, 2, aa});
}

TEST_CASE("engine: any size of image, and any part of it", "[engine]") {
  const Scene scene = heap(9, 1, {0, 0, 0});
  for (const ImageSize size : {ImageSize{1, 1}, {2, 3}, {3, 2}, {5, 9}, {4, 4}, {17, 1}, {1, 17}}) {
    INFO(size.width << " x " << size.height);
    check_same_bits(scene, {5, size, 2, {}});
  }
  const Settings settings{5, {19, 13}, 2, {}};
  const auto engine = make_fast(scene, settings, {Precision::f64});
  const Image whole = render_image(*engine, settings.size, 1);
  const std::atomic<bool> never = false;
  for (int first = 0; first < 13; ++first) {
    RayCounts counts;
    std::vector<Color> rows(19 * static_cast<std::size_t>(std::min(3, 13 - first)));
    engine->trace_rows(first, rows, counts, never);
    CHECK(std::equal(rows.begin(), rows.end(), &whole.at(0, first)));
    CHECK(counts.primary == rows.size());
  }
}

TEST_CASE("engine: a heap of spheres looks as the solution draws it", "[engine]") {
  Scene scene = heap(10, 1, {0, 0, 0});
  SphereCloud& cloud = scene.clouds[0];  // without the twins, which shade each other or not, as rounding will have it
  cloud.spheres.resize(500);
  cloud.colors.resize(500);
  for (const int stage : {2, 4, 6}) {
    const Settings settings{stage, {61, 47}, 3, {}};
    const Image expected = render_image(*make_stages(scene, settings, table()), settings.size, 2);
    for (const SimdTarget& target : simd_targets()) {
      INFO("stage " << stage << ", " << target.name);
      const Image image =
          render_image(*make_fast(scene, settings, {Precision::f64, std::string(target.name)}), settings.size, 2);
      int apart = 0;
      for (int y = 0; y < 47; ++y)
        for (int x = 0; x < 61; ++x) apart += deviation(image.at(x, y), expected.at(x, y)) > 1e-9;
      CHECK(apart == 0);  // where rounding decides an edge, or a path through glass, otherwise: nowhere in this heap
    }
  }
}

TEST_CASE("engine: rays are counted alike by every instruction set", "[engine]") {
  const Scene scene = heap(11, 1, {0, 0, 0});
  const Settings settings{6, {31, 22}, 4, AntiAliasing::adaptive};
  const auto count = [&](const std::string& simd) {
    const auto engine = make_fast(scene, settings, {Precision::f64, simd});
    const std::atomic<bool> never = false;
    return render(
               *engine, settings.size, 1, [](int, std::span<const Color>) {}, [](double) {}, never)
        .rays;
  };
  const RayCounts expected = count("scalar");
  CHECK(expected.refracted > 0);
  for (const SimdTarget& target : simd_targets()) {
    INFO(target.name);
    const RayCounts counts = count(std::string(target.name));
    CHECK(counts.primary == expected.primary);
    CHECK(counts.shadow == expected.shadow);
    CHECK(counts.reflected == expected.reflected);
    CHECK(counts.refracted == expected.refracted);
  }
}

TEST_CASE("engine: adaptive takes four samples where they agree, and sixteen elsewhere", "[engine]") {
  Scene scene;
  scene.camera = {{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 30};
  scene.background = Color(0.25);
  const Settings adaptive{2, {1, 1}, 0, AntiAliasing::adaptive};
  const auto run = [&](const Engine& engine, std::uint64_t& samples) {
    Color pixel(0);
    RayCounts counts;
    const std::atomic<bool> never = false;
    engine.trace_rows(0, {&pixel, 1}, counts, never);
    samples = counts.primary;
    return pixel;
  };
  const auto both = [&](std::uint64_t expected_samples) {
    std::uint64_t samples = 0;
    const Color by_stages = run(*make_stages(scene, adaptive, table()), samples);
    CHECK(samples == expected_samples);
    CHECK(run(*make_fast(scene, adaptive, {Precision::f64}), samples) == by_stages);
    CHECK(samples == expected_samples);
    return by_stages;
  };
  CHECK(both(4) == Color(0.25));
  scene.spheres = {{{{0, 2, -4}, 2}, {Color(0.25 + 1. / 32), 0, false, 1.5}}};  // its edge crosses the pixel
  both(4);
  scene.spheres[0].material.color = Color(0.25 + 1.1 / 32);
  const Color refined = both(16);
  const Settings grid{2, {1, 1}, 0, AntiAliasing::grid16};
  CHECK(deviation(refined, first_pixel(*make_fast(scene, grid, {Precision::f64}))) < 1e-15);
}

TEST_CASE("engine: adaptive takes more samples where one is no number", "[engine]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Color> same = {Color(0.5), Color(0.5), Color(0.5), Color(0.5)};
  CHECK(samples_agree(same));
  const std::vector<Color> bright = {Color(5), Color(1), Color(2), Color(9)};
  CHECK(samples_agree(bright));  // as they are shown
  const std::vector<Color> one_nan = {Color(0.5), Color(0.5), {0.5, nan, 0.5}, Color(0.5)};
  CHECK_FALSE(samples_agree(one_nan));
  const std::vector<Color> apart = {Color(0.5), Color(0.5), {0.5, 0.5, 0.54}, Color(0.5)};
  CHECK_FALSE(samples_agree(apart));
}

TEST_CASE("engine: instruction sets are named, and unknown ones refused", "[engine]") {
  const std::vector<SimdTarget> targets = simd_targets();
  REQUIRE_FALSE(targets.empty());
  CHECK(targets.back().name == "scalar");
  CHECK(targets.back().lanes_f32 == 1);
  for (std::size_t i = 1; i < targets.size(); ++i) CHECK(targets[i].lanes_f64 < targets[i - 1].lanes_f64);
  const Scene scene = one_sphere({{0, 0, -5}, 1});
  const Settings settings{2, {1, 1}, 0, {}};
  CHECK_THROWS_WITH(make_fast(scene, settings, {Precision::f64, "mmx"}),
                    Catch::Contains("mmx") && Catch::Contains("scalar"));
  for (const SimdTarget& target : targets)
    CHECK(make_fast(scene, settings, {Precision::f32, std::string(target.name)})->facts().simd == target.name);
}

TEST_CASE("hierarchy: every box holds its spheres, every sphere is in one leaf", "[engine]") {
  check_hierarchy(random_spheres(1, 1));
  check_hierarchy(random_spheres(9, 2));
  check_hierarchy(random_spheres(100, 3));
  check_hierarchy(random_spheres(20000, 4));
}

TEST_CASE("hierarchy: any spheres: all in one place, on a line, far apart in size and place", "[engine]") {
  check_hierarchy(std::vector<Sphere>(1000, Sphere{{1, 2, 3}, 4}));
  std::vector<Sphere> line, far;
  for (int i = 0; i < 500; ++i) {
    line.push_back({{i * 0.1, 0, 0}, 0.01});
    far.push_back({{std::pow(1.07, i), -std::pow(1.06, i), 1}, std::pow(1.05, i)});
  }
  check_hierarchy(line);
  check_hierarchy(far);
  std::vector<Sphere> crowd = random_spheres(3000, 5);  // in a single cell of the curve, for one sphere is far away
  crowd.push_back({{1e15, -1e15, 1e15}, 1});
  check_hierarchy(crowd);
}

TEST_CASE("hierarchy: the same for any number of threads", "[engine]") {
  const std::vector<Sphere> spheres = random_spheres(30000, 6);
  fast::Hierarchy alone(spheres, fast::Hierarchy::Numbers::doubles, Vec3(0), 1);
  fast::Hierarchy together(spheres, fast::Hierarchy::Numbers::doubles, Vec3(0), 5);
  CHECK(alone.take_order() == together.take_order());
  REQUIRE(alone.nodes().size() == together.nodes().size());
  const auto bits = [](const fast::Hierarchy::Node& node) {
    return std::bit_cast<std::array<std::uint32_t, sizeof node / sizeof(std::uint32_t)>>(node);
  };
  CHECK(std::equal(alone.nodes().begin(), alone.nodes().end(), together.nodes().begin(), together.nodes().end(),
                   [&](const auto& a, const auto& b) { return bits(a) == bits(b); }));
}

TEST_CASE("hierarchy: at most 40 bytes a sphere, and none for a few spheres", "[engine]") {
  Scene scene = heap(12, 1, {0, 0, 0});
  const Settings settings{2, {1, 1}, 0, {}};
  for (const std::size_t count : {std::size_t{500}, std::size_t{50000}}) {
    scene.clouds[0].spheres = random_spheres(count, 7);
    scene.clouds[0].colors.clear();
    const EngineFacts facts = make_fast(scene, settings, {Precision::f32})->facts();
    CHECK(facts.hierarchy_spheres >= count);
    CHECK(facts.hierarchy_bytes <= 40 * facts.hierarchy_spheres);
  }
  scene.clouds.clear();
  scene.spheres.resize(10);
  CHECK(make_fast(scene, settings, {Precision::f32})->facts().hierarchy_spheres == 0);
}
