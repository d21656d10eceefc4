#include "core/submission/worker.hpp"

#include "core/image/data_folder.hpp"
#include "core/render/stage_table.hpp"

#include <algorithm>
#include <csignal>
#include <stdexcept>

namespace raylab {
namespace {

constexpr std::chrono::seconds time_to_load{20};
constexpr std::size_t longest_line = std::size_t{256} << 10U;  // in a sandbox; an answer has some thousand bytes
constexpr std::size_t longest_text = 4000;                     // that is thrown
constexpr int most_asides = 30;                                // each may take as long as the answer
// In a sandbox: for as long as a worker lives, which is for the tests of a stage or for an image.
constexpr std::int64_t processor_seconds = 300;

ChildSetup child_of(const WorkerSetup& setup) {
  const Sandbox* const sandbox = setup.sandbox;
  SandboxJob job{{}, {}, {}, false, {setup.limits.memory, processor_seconds, 0}};
  const auto reachable = [&](const std::filesystem::path& file) {
    if (!sandbox) return file.string();
    job.readable.push_back(sandbox->inside(file));
    return job.readable.back().string();
  };
  job.command.push_back(reachable(program_part("raylab-worker")));
  for (const StageLibrary& library : setup.libraries) {
    std::string tasks;
    for (const std::string& task : library.tasks) tasks += (tasks.empty() ? "" : ",") + task;
    job.command.insert(job.command.end(), {reachable(library.file), tasks});
  }
  if (!sandbox) return {job.command, setup.environment};
  return {sandbox->command(job), {}, true, sandbox->passes_signals_as_codes(), longest_line};
}

std::string text_of(std::string_view json) {
  try {
    return from_json<std::string>(json).substr(0, longest_text);
  } catch (const InputError&) {
    return "gave an answer that is none";
  }
}

Trouble trouble_of(const ChildEnded& end) {
  return end.signal == SIGXCPU ? Trouble::too_slow : end.signal == SIGKILL ? Trouble::out_of_memory : Trouble::crashed;
}

}  // namespace

Worker::Worker(const WorkerSetup& setup) : process_(child_of(setup)), end_(setup.limits.end) {
  std::string line;
  try {
    line = process_.receive(std::min(Clock::now() + time_to_load, setup.limits.end));
  } catch (const ChildEnded& error) {
    throw NoAnswer(trouble_of(error), "the submission " + std::string(error.what()) +
                                          ", while it was loaded: before any task was called (a global variable?)");
  } catch (const ChildSilent& error) {
    throw NoAnswer(Trouble::too_slow,
                   "the submission " + std::string(error.what()) + ". It was being loaded (a global variable?)");
  } catch (const ChildFloods& error) {
    throw NoAnswer(Trouble::no_value, "the submission " + std::string(error.what()) + ", while it was loaded");
  }
  const auto [verb, rest] = first_word(reply(line));
  if (verb != "ready") throw NoAnswer(Trouble::threw, "the submission cannot be loaded: " + text_of(rest));
}

/// What a line says, if it is about what was asked last.
std::string_view Worker::reply(std::string_view line) const {
  const auto [number, message] = first_word(line);
  if (number != std::to_string(asked_)) throw NoAnswer(Trouble::no_value, "sent something that is no answer");
  return message;
}

std::string Worker::ask(std::string_view request, std::chrono::milliseconds limit, const Aside& aside,
                        const std::atomic<bool>* cancel) {
  try {
    process_.send(std::to_string(++asked_) + ' ' + std::string(request), std::min(Clock::now() + limit, end_), cancel);
    const auto last_deadline = std::min(Clock::now() + most_asides * limit, end_);
    for (;;) {
      const std::string line = process_.receive(std::min(Clock::now() + limit, last_deadline), cancel);
      const auto [verb, rest] = first_word(reply(line));
      if (verb == "answer") return std::string(rest);
      if (verb == "unwritten") throw NotWritten(text_of(rest));
      if (verb == "failed") throw NoAnswer(Trouble::threw, text_of(rest));
      if (verb == "exhausted") throw NoAnswer(Trouble::out_of_memory, text_of(rest));
      if (verb != "calling" && verb != "stands-in") throw NoAnswer(Trouble::no_value, "sent something that is no answer");
      if (aside) aside(verb, rest);
    }
  } catch (const ChildEnded& error) {
    throw NoAnswer(trouble_of(error), error.what());
  } catch (const ChildSilent& error) {
    throw NoAnswer(Trouble::too_slow, error.what());
  } catch (const ChildFloods& error) {
    throw NoAnswer(Trouble::no_value, error.what());
  }
}

std::string repeated_call(const WorkerSetup& setup, std::string_view label, std::string_view arguments) {
  return "It was asked\n  raylab call " + std::string(label) + " '" + std::string(arguments) + "' " + setup.with;
}

std::filesystem::path solution_library(int stage) {
  return program_part("raylab-solution") / (std::string(stage_info(stage).folder) + ".so");
}

}  // namespace raylab
