#pragma once

#include "core/math/seen.hpp"
#include "core/render/engine.hpp"
#include "core/render/stage_table.hpp"
#include "core/scene/scene.hpp"

#include <string>
#include <variant>
#include <vector>

namespace raylab {

/// One call of a task, as it was made: arguments, an object, and result as JSON that reads back to the same bits.
struct RecordedCall {
  const TaskInfo* task;
  std::string arguments;
  std::string result;
};

/// What happens while a pixel is computed: a task is called, or a ray has been followed to its end.
using Event = std::variant<RecordedCall, Seen>;

/// A pixel, and all that happened in it.
struct Recording {
  Color color;
  std::vector<Event> events;
};

/// A table that does what `table` does, and of each call writes down what happened. One recording at a time, in one thread.
StageTable start_recording(const StageTable& table);

/// The events since start_recording().
std::vector<Event> stop_recording();

/// Computes the pixel in column i from the left and row j from the top with `table`, recording. One thread at a time.
Recording record_pixel(const Scene& scene, const Settings& settings, const StageTable& table, int i, int j);

}  // namespace raylab
