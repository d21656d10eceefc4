#pragma once

// Scenes as texts, for the tests of the reader.

#include "core/scene/read_scene.hpp"
#include "tests/catch.hpp"

#include <span>
#include <string>
#include <vector>

namespace raylab::test {

using Messages = std::vector<std::string>;

/// The first line of most scenes here, so that what a test is about begins in line 2.
inline const std::string camera = "camera = {position = [0, 0, 0], facing = [0, 0, -1], up = [0, 1, 0]}\n";

/// As the user reads them.
inline Messages messages(const SceneFile& file) {
  Messages result;
  for (const Diagnostic& diagnostic : file.diagnostics) result.push_back(to_string(diagnostic));
  return result;
}

/// The scene of a text without a mistake or a warning.
inline Scene good(const std::string& toml) {
  const SceneFile file = parse_scene(toml, "scene.toml");
  INFO(toml);
  CHECK(messages(file) == Messages{});
  REQUIRE(file.scene.has_value());
  return *file.scene;
}

/// The messages on a text without a mistake.
inline Messages warnings(const std::string& toml) {
  const SceneFile file = parse_scene(toml, "scene.toml");
  INFO(toml);
  CHECK(file.scene.has_value());
  for (const Diagnostic& diagnostic : file.diagnostics) CHECK(diagnostic.severity == Diagnostic::Severity::warning);
  return messages(file);
}

inline std::string sphere(const std::string& center, const std::string& radius, const std::string& more = "") {
  return "[[sphere]]\ncenter = " + center + "\nradius = " + radius + "\ncolor = [1, 1, 1]\n" + more;
}

/// A text with mistakes, and what is said of it.
struct BadScene {
  std::string what;
  std::string toml;
  Messages messages;
};

inline void check_bad(std::span<const BadScene> scenes) {
  for (const BadScene& bad : scenes) {
    INFO(bad.what);
    const SceneFile file = parse_scene(bad.toml, "scene.toml");
    CHECK(messages(file) == bad.messages);
    CHECK_FALSE(file.scene.has_value());
  }
}

}  // namespace raylab::test
