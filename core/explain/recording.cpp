#include "core/explain/recording.hpp"

#include "core/calls/call_function.hpp"
#include "core/calls/call_task.hpp"
#include "core/calls/routed_table.hpp"
#include "core/render/driver.hpp"

#include <utility>

namespace raylab {
namespace {

/// Hands each call on to a table, and writes it down.
class Recorder {
 public:
  static Recorder& current() {
    static Recorder one;
    return one;
  }

  void start(const StageTable& table) {
    table_ = table;
    events_.clear();
  }
  std::vector<Event> take() { return std::exchange(events_, {}); }
  void note(const Seen& seen) { events_.emplace_back(seen); }

  template <auto member, class... Parameters>
  ResultOf<member> call(const TaskInfo& task, const Parameters&... arguments) {
    static const std::vector<std::string> names = parameter_names(task);
    const std::size_t place = events_.size();
    events_.emplace_back(RecordedCall{&task, arguments_json(names, arguments...), {}});
    const ResultOf<member> result = (table_.*member)(arguments...);
    PlainJson<ResultOf<member>>::write(std::get<RecordedCall>(events_[place]).result, result, json_number);
    return result;
  }

 private:
  StageTable table_;
  std::vector<Event> events_;
};

/// A ray filter that changes nothing.
Color note_seen(const Seen& seen) {
  Recorder::current().note(seen);
  return seen.color;
}

}  // namespace

StageTable start_recording(const StageTable& table) {
  Recorder::current().start(table);
  return routed_table<Recorder>();
}

std::vector<Event> stop_recording() { return Recorder::current().take(); }

Recording record_pixel(const Scene& scene, const Settings& settings, const StageTable& table, int i, int j) {
  const StageTable recording = start_recording(table);
  std::vector<RayFilter> filters = ray_filters(recording, settings.stage);
  filters.push_back(note_seen);
  RayCounts counts;
  const std::atomic<bool> never = false;
  Driver<StageTable> driver(scene, settings, recording, filters, counts, never);
  const Color color = driver.pixel(i, j);
  return {color, stop_recording()};
}

}  // namespace raylab
