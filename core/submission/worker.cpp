#include "core/submission/worker.hpp"

#include "core/image/data_folder.hpp"
#include "core/render/stage_table.hpp"

#include <stdexcept>

namespace raylab {
namespace {

constexpr std::chrono::seconds time_to_load{20};

std::vector<std::string> command(const WorkerSetup& setup) {
  std::vector<std::string> arguments{program_part("raylab-worker").string()};
  for (const StageLibrary& library : setup.libraries) {
    arguments.push_back(library.file.string());
    std::string tasks;
    for (const std::string& task : library.tasks) tasks += (tasks.empty() ? "" : ",") + task;
    arguments.push_back(tasks);
  }
  return arguments;
}

std::string text_of(std::string_view json) {
  try {
    return from_json<std::string>(json);
  } catch (const InputError&) {
    return "gave an answer that is none";
  }
}

}  // namespace

Worker::Worker(const WorkerSetup& setup) : process_(command(setup), setup.environment) {
  std::string line;
  try {
    line = process_.receive(Clock::now() + time_to_load);
  } catch (const ChildEnded& error) {
    throw std::runtime_error("the submission " + std::string(error.what()) +
                             ", while it was loaded: before any task was called (a global variable?)");
  } catch (const ChildSilent& error) {
    throw std::runtime_error("the submission " + std::string(error.what()) + " It was being loaded (a global variable?)");
  }
  const auto [verb, rest] = first_word(line);
  if (verb != "ready") throw std::runtime_error("the submission cannot be loaded: " + text_of(rest));
}

std::string Worker::ask(std::string_view request, std::chrono::milliseconds limit, const Aside& aside,
                        const std::atomic<bool>* cancel) {
  process_.send(request, Clock::now() + limit, cancel);
  for (;;) {
    const std::string line = process_.receive(Clock::now() + limit, cancel);
    const auto [verb, rest] = first_word(line);
    if (verb == "answer") return std::string(rest);
    if (verb == "unwritten") throw NotWritten(text_of(rest));
    if (verb == "failed") throw std::runtime_error(text_of(rest));
    if (aside) aside(verb, rest);
  }
}

std::string repeated_call(const WorkerSetup& setup, std::string_view label, std::string_view arguments) {
  return "It was asked\n  raylab call " + std::string(label) + " '" + std::string(arguments) + "' " + setup.with;
}

std::filesystem::path solution_library(int stage) {
  return program_part("raylab-solution") / (std::string(stage_info(stage).folder) + ".so");
}

}  // namespace raylab
