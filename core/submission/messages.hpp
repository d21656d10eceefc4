#pragma once

// What raylab and its worker say to each other: lines, each a number, a verb and JSON. Requests are numbered from 1; what is
// said about one has its number, so that nobody can answer before, or twice.
//
//   raylab -> worker                         worker -> raylab
//                                            0 ready {}                   once, when all code is loaded
//   1 call 2.2 {"ray": ..., "sphere": ...}   1 answer RESULT | unwritten "task 2.2 ..." | failed "what was thrown" |
//                                            exhausted "what is lacking: memory"
//   scene {"scene": ..., "settings": ...}    answer {} | unwritten ... | failed ...
//   trace {"row": 3, "column": 0, "pixels": 32}   answer {"pixels": [...], "rays": ...} | unwritten ... | failed ...
//   announce {}                              answer {}; from then on, before each call while it traces:
//                                            calling 2.2 {"ray": ...}
//                                            stands-in "task 2.3 ..."     once a task, before the answer

#include "core/calls/plain_json.hpp"
#include "core/render/engine.hpp"
#include "core/scene/scene.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace raylab {

struct SceneMessage {
  Scene scene;
  Settings settings;
};
RAYLAB_FIELDS(SceneMessage, RAYLAB_FIELD(scene) RAYLAB_FIELD(settings))

/// Some pixels of a row, from `column` to the right.
struct TraceMessage {
  int row = 0;
  int column = 0;
  int pixels = 0;
};
RAYLAB_FIELDS(TraceMessage, RAYLAB_FIELD(row) RAYLAB_FIELD(column) RAYLAB_FIELD(pixels))

struct TraceAnswer {
  std::vector<Color> pixels;
  RayCounts rays;
};
RAYLAB_FIELDS(TraceAnswer, RAYLAB_FIELD(pixels) RAYLAB_FIELD(rays))

/// The descriptor on which a worker finds the line to raylab.
inline constexpr int worker_channel = 3;

/// "call 2.2 {...}" taken apart at its first blank: "call" and the rest.
inline std::pair<std::string_view, std::string_view> first_word(std::string_view line) {
  const std::size_t blank = std::min(line.find(' '), line.size());
  return {line.substr(0, blank), line.substr(std::min(blank + 1, line.size()))};
}

}  // namespace raylab
