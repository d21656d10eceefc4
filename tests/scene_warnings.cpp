// What the reader warns of.
#include "tests/scene_text.hpp"

using namespace raylab;
using namespace raylab::test;

TEST_CASE("scene: the camera inside a sphere is a warning", "[scene]") {
  CHECK(warnings(camera + sphere("[0, 0, 1]", "1.5")) ==
        Messages{"scene.toml:1:22: warning: camera.position: inside sphere[0]"});
  CHECK(warnings(camera + sphere("[0, 0, 1]", "1")) == Messages{});
  CHECK(warnings(camera + sphere("[9, 0, 0]", "1") + sphere("[0, 0, 1]", "1.5") + sphere("[0, 0, 2]", "3")) ==
        Messages{"scene.toml:1:22: warning: camera.position: inside sphere[1] and 1 more"});
}

TEST_CASE("scene: glass that holds or cuts another geometry is a warning", "[scene]") {
  const std::string glass = camera + sphere("[0, 0, -9]", "2", "transparent = true\n");
  const std::string plane = "[[plane]]\nnormal = [0, 3, 0]\ncolor = [1, 1, 1]\npoint = ";
  const std::string begin = "scene.toml:2:1: warning: sphere[0]: transparent, but it holds or cuts ";

  CHECK(warnings(glass + sphere("[0.5, 0, -9]", "1")) == Messages{begin + "sphere[1]"});
  CHECK(warnings(glass + sphere("[0, 2.9, -9]", "1")) == Messages{begin + "sphere[1]"});
  CHECK(warnings(glass + plane + "[7, 1.9, 7]\n") == Messages{begin + "plane[0]"});
  CHECK(warnings(glass + sphere("[0, 0, -9]", "1") + plane + "[0, 0, 0]\n" + sphere("[0, 0, -10]", "0.5")) ==
        Messages{begin + "plane[0] and 2 more"});

  CHECK(warnings(glass + sphere("[0, 3, -9]", "1")) == Messages{});  // touches from outside
  CHECK(warnings(glass + plane + "[7, -2, 7]\n") == Messages{});     // lies on it
  CHECK(warnings(glass + sphere("[0, 0, -9]", "3")) == Messages{});  // an opaque shell around it
  CHECK(warnings(camera + sphere("[0, 0, -9]", "2") + sphere("[0, 0, -9]", "1")) == Messages{});
}

TEST_CASE("scene: what touches in decimals is not cut in doubles", "[scene]") {
  // 0.1 + 0.2 is more than 0.3 in doubles.
  CHECK(warnings(camera + sphere("[0.3, 0, -9]", "0.1", "transparent = true\n") + sphere("[0, 0, -9]", "0.2")) ==
        Messages{});
}

TEST_CASE("scene: glass that cuts glass is one warning, glass in glass is the outer one's", "[scene]") {
  const std::string glass = "transparent = true\n";
  CHECK(warnings(camera + sphere("[0, 0, -9]", "2", glass) + sphere("[3, 0, -9]", "2", glass)) ==
        Messages{"scene.toml:2:1: warning: sphere[0]: transparent, but it holds or cuts sphere[1]"});
  CHECK(warnings(camera + sphere("[0, 0, -9]", "1", glass) + sphere("[0, 0, -9]", "2", glass)) ==
        Messages{"scene.toml:7:1: warning: sphere[1]: transparent, but it holds or cuts sphere[0]"});
}

TEST_CASE("scene: identical geometry is a warning", "[scene]") {
  const std::string plane = "[[plane]]\npoint = [0, -2, 0]\nnormal = [0, 1, 0]\ncolor = [1, 1, 1]\n";
  CHECK(warnings(camera + plane + plane + plane) == Messages{"scene.toml:6:1: warning: plane[1]: identical to plane[0]",
                                                             "scene.toml:10:1: warning: plane[2]: identical to plane[0]"});
  CHECK(warnings(camera + plane + plane + "shininess = 1\n") == Messages{});
  CHECK(warnings(camera + sphere("[0, 0, -9]", "2") + sphere("[0, -0.0, -9]", "2", "refractive_index = 2\n")) ==
        Messages{"scene.toml:6:1: warning: sphere[1]: identical to sphere[0]"});
  CHECK(warnings(camera + sphere("[0, 0, -9]", "2") + sphere("[0, 0, -9]", "2", "shininess = 1\n")) == Messages{});
}

TEST_CASE("scene: glass of another index is not identical", "[scene]") {
  const auto two_of_glass = [](const std::string& index) {
    const std::string more = "transparent = true\nrefractive_index = ";
    return warnings(camera + sphere("[0, 0, -9]", "2", more + "1.5\n") + sphere("[0, 0, -9]", "2", more + index + "\n"));
  };
  const Messages both_hold{"scene.toml:2:1: warning: sphere[0]: transparent, but it holds or cuts sphere[1]",
                           "scene.toml:8:1: warning: sphere[1]: transparent, but it holds or cuts sphere[0]"};
  CHECK(two_of_glass("1.6") == both_hold);
  CHECK(two_of_glass("1.50") ==
        Messages{both_hold[0], both_hold[1], "scene.toml:8:1: warning: sphere[1]: identical to sphere[0]"});
}

TEST_CASE("scene: a scene with a mistake gets no warnings about what it would be", "[scene]") {
  const SceneFile file = parse_scene(camera + sphere("[0, 0, 0]", "1") + "[image]\nwidth = 0\n", "scene.toml");
  CHECK(messages(file) == Messages{"scene.toml:7:9: image.width: must be between 1 and 65536, got 0"});
}
