// The program in which other people's code runs: raylab-worker LIBRARY TASKS [LIBRARY TASKS]...
// It answers what messages.hpp lists. A later library wins over an earlier one.

#include "core/calls/call_function.hpp"
#include "core/calls/call_task.hpp"
#include "core/calls/routed_table.hpp"
#include "core/render/driver.hpp"
#include "core/submission/limits.hpp"
#include "core/submission/messages.hpp"

#include <dlfcn.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

using namespace raylab;

namespace {

/// The line to raylab. A worker that cannot reach it has nothing left to do.
class Channel {
 public:
  /// As part of what is said about the request that was received last.
  void send(const std::string& message) {
    const std::string line = number_ + ' ' + message + '\n';
    for (std::string_view rest = line; !rest.empty();) {
      const ssize_t sent = write(worker_channel, rest.data(), rest.size());
      if (sent > 0)
        rest.remove_prefix(static_cast<std::size_t>(sent));
      else if (errno != EINTR)
        std::_Exit(EXIT_FAILURE);
    }
  }

  /// The next request, without its number. Nothing once raylab has closed the line.
  std::optional<std::string> receive() {
    for (std::size_t searched = 0;;) {
      if (const std::size_t end = received_.find('\n', searched); end != std::string::npos) {
        const std::string line = received_.substr(0, end);
        received_.erase(0, end + 1);
        const auto [number, request] = first_word(line);
        number_ = number;
        return std::string(request);
      }
      searched = received_.size();
      std::array<char, 65536> buffer;
      const ssize_t got = read(worker_channel, buffer.data(), buffer.size());
      if (got > 0)
        received_.append(buffer.data(), static_cast<std::size_t>(got));
      else if (got == 0 || errno != EINTR)
        return std::nullopt;
    }
  }

 private:
  std::string received_;
  std::string number_ = "0";  ///< of the request; before the first there is none
};

/// All tasks that this worker runs. What `fallback` has answers for a task that is not written.
struct Tasks {
  StageTable own;
  StageTable fallback;
};

/// Stands between the driver and the tasks while images are made.
class Guard {
 public:
  static Guard& current() {
    static Guard one;
    return one;
  }

  Tasks tasks;
  Channel* channel = nullptr;
  bool announcing = false;

  template <auto member, class... Parameters>
  ResultOf<member> call(const TaskInfo& task, const Parameters&... arguments) {
    static bool unwritten = false;
    if (!unwritten) {
      if (announcing) announce(task, arguments...);
      try {
        if (tasks.own.*member) return (tasks.own.*member)(arguments...);
        throw missing(task);
      } catch (const NotWritten& error) {
        if (!(tasks.fallback.*member) || tasks.fallback.*member == tasks.own.*member) throw;
        channel->send("stands-in " + json_string(error.what() + caller_of(task, error.what())));
        unwritten = true;
      }
    }
    return (tasks.fallback.*member)(arguments...);
  }

  static NotWritten missing(const TaskInfo& task) {
    return NotWritten("task " + std::string(task.label) + " is missing: no " + std::string(task.name) +
                      " is defined as stage.hpp declares it");
  }

 private:
  /// A task that is written may call one that is not.
  static std::string caller_of(const TaskInfo& task, std::string_view unwritten) {
    const std::string own = "task " + std::string(task.label) + " ";
    return unwritten.starts_with(own) ? "" : ", and task " + std::string(task.label) + " calls it";
  }

  template <class... Parameters>
  void announce(const TaskInfo& task, const Parameters&... arguments) {
    static const std::vector<std::string> names = parameter_names(task);
    channel->send("calling " + std::string(task.label) + ' ' + arguments_json(names, arguments...));
  }
};

/// The scene that is being traced.
struct Tracing {
  Tracing(const SceneMessage& message, const StageTable& table)
      : scene(message.scene),
        settings(message.settings),
        filters(ray_filters(table, settings.stage)),
        driver(scene, settings, table, filters, rays, never) {}

  std::string answer(const TraceMessage& wanted) {
    TraceAnswer answer;
    rays = {};
    for (int k = 0; k < wanted.pixels; ++k) answer.pixels.push_back(driver.pixel(wanted.column + k, wanted.row));
    answer.rays = rays;
    return to_json(answer);
  }

  const Scene scene;
  const Settings settings;
  const std::vector<RayFilter> filters;
  RayCounts rays;
  const std::atomic<bool> never = false;
  Driver<StageTable> driver;
};

std::string answer_call(const Tasks& tasks, std::string_view label, std::string_view arguments) {
  std::string answer;
#define RAYLAB_CALL(name, function, summary, example)                                         \
  if (label == name) {                                                                        \
    static const TaskInfo& task = task_list()[static_cast<std::size_t>(TaskIndex::function)]; \
    static const std::vector<std::string> names = parameter_names(task);                      \
    if (!tasks.own.function) throw Guard::missing(task);                                      \
    answer = to_json(call_function(tasks.own.function, names, parse_json(arguments)));        \
  }
  RAYLAB_TASKS(RAYLAB_CALL)
#undef RAYLAB_CALL
  return answer;
}

class Service {
 public:
  explicit Service(Guard& guard) : guard_(guard), table_(routed_table<Guard>()) {}

  std::string answer(std::string_view request) {
    const auto [verb, rest] = first_word(request);
    if (verb == "call") {
      const auto [label, arguments] = first_word(rest);
      return answer_call(guard_.tasks, label, arguments);
    }
    if (verb == "scene") tracing_ = std::make_unique<Tracing>(from_json<SceneMessage>(rest), table_);
    if (verb == "trace") return tracing_->answer(from_json<TraceMessage>(rest));
    if (verb == "announce") guard_.announcing = true;
    return "{}";
  }

 private:
  Guard& guard_;
  const StageTable table_;
  std::unique_ptr<Tracing> tracing_;
};

StageTable load(const std::string& file) {
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) {
    const std::string why = dlerror(), before = file + ": ";
    throw std::runtime_error(why.starts_with(before) ? why.substr(before.size())
                                                     : why);  // the file has another name each time
  }
  using Export = const ExportedTasks* (*)();
  const auto exported = reinterpret_cast<Export>(dlsym(library, "raylab_tasks_submission"));
  if (!exported) throw std::runtime_error(file + ": is no stage");
  return import_some_tasks(*exported());
}

/// Puts the tasks with these labels, "4.1,4.2", of `stage` into `table`.
void add(StageTable& table, const StageTable& stage, std::string_view labels) {
  for (std::size_t start = 0; start <= labels.size();) {
    const std::string_view label = labels.substr(start, labels.find(',', start) - start);
    mix(table, stage, label);
    start += label.size() + 1;
  }
}

/// Of each task the last library's function, and the first one's to fall back on.
Tasks load_all(const std::vector<std::string>& arguments) {
  Tasks tasks;
  std::vector<StageTable> stages;
  for (std::size_t k = 0; k + 1 < arguments.size(); k += 2) {
    stages.push_back(load(arguments[k]));
    add(tasks.own, stages.back(), arguments[k + 1]);
  }
  for (std::size_t k = stages.size(); k-- > 0;) add(tasks.fallback, stages[k], arguments[2 * k + 1]);
  return tasks;
}

}  // namespace

int main(int argc, char** argv) {
  Channel channel;
  Guard& guard = Guard::current();
  guard.channel = &channel;
  std::setvbuf(stdout, nullptr, _IONBF, 0);  // what a task prints is seen before it crashes
  try {
    limit_this_process();
    guard.tasks = load_all({argv + 1, argv + argc});
    channel.send("ready {}");
  } catch (const std::exception& error) {
    channel.send("failed " + json_string(error.what()));
    return EXIT_FAILURE;
  }
  Service service(guard);
  while (const std::optional<std::string> request = channel.receive()) {
    try {
      channel.send("answer " + service.answer(*request));
    } catch (const NotWritten& error) {
      channel.send("unwritten " + json_string(error.what()));
    } catch (const std::bad_alloc&) {
      channel.send("exhausted " + json_string("took more memory than there is for it"));
    } catch (const std::exception& error) {
      channel.send("failed " + json_string(std::string("threw an exception: ") + error.what()));
    } catch (...) {
      channel.send("failed " + json_string("threw something that is no std::exception"));
    }
  }
  std::_Exit(EXIT_SUCCESS);
}
