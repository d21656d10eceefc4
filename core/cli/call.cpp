#include "core/calls/call_task.hpp"

#include "core/cli/command.hpp"
#include "core/cli/engines.hpp"
#include "core/explain/handbook.hpp"
#include "core/scene/diagnostic.hpp"
#include "core/scene/nearest_name.hpp"
#include "core/submission/remote_table.hpp"

#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace raylab::cli {
namespace {

struct Call {
  std::string task;
  std::string arguments;
  bool from_input = false;  ///< no arguments were given
  WithOptions submissions;
  std::string precision;
  bool list = false;
};

const TaskInfo& find_task(const std::string& text) {
  const auto tasks = task_list();
  const auto found = std::find_if(tasks.begin(), tasks.end(),
                                  [&](const TaskInfo& task) { return task.label == text || task.name == text; });
  if (found != tasks.end()) return *found;
  std::vector<std::string_view> names;
  for (const TaskInfo& task : tasks) names.push_back(task.name);
  const std::string_view nearest = nearest_name(text, names);
  const std::string help =
      nearest.empty() ? ": 'raylab call --list' lists them" : ", did you mean '" + std::string(nearest) + "'?";
  throw Failure("there is no task '" + shortened(text) + "'" + help, wrong_usage);
}

void list_task(const TaskInfo& task) {
  const TaskSignature signature = signature_of(task);
  std::cout << '\n' << task.label << ' ' << task.name << ": " << task.summary << '\n';
  for (const auto& [name, type] : signature.parameters) std::cout << "    " << name << ": " << type << '\n';
  std::cout << "    -> " << signature.result << '\n';
  std::cout << "    raylab call " << task.label << " '" << task.example << "'\n";
}

void list_tasks() {
  std::cout << "Each task with its arguments, its result and an example. A field marked ? may be left out.\n";
  for (const StageInfo& stage : stage_list()) {
    std::cout << "\nStage " << stage.number << ", " << stage.name << ": what each argument means, in which unit, is in "
              << in_handbook(std::string(stage.folder) + "/stage.hpp") << '\n';
    for (const TaskInfo& task : task_list())
      if (stage_of(task.label) == stage.number) list_task(task);
  }
}

constexpr std::size_t longest_line = std::size_t{4} << 20U;  // its values take up to some fifty times as much memory

/// Reads one line, without its end. Of one that is too long a byte more than may be, and the rest is skipped.
bool read_line(std::istream& in, std::string& line) {
  line.clear();
  for (char c = 0; in.get(c) && c != '\n';)
    if (line.size() <= longest_line) line += c;
  return in || !line.empty();
}

bool is_blank(const std::string& line) { return line.find_first_not_of(" \t\r") == line.npos; }

/// At once, for whoever waits for it.
void print(const std::string& line) {
  std::cout << line << std::endl;
  if (!std::cout) throw Failure("standard output cannot be written");
}

/// Answers each line of standard input with a line. Returns whether all answers are results.
bool answer_lines(const TaskCaller& caller) {
  std::ios::sync_with_stdio(false);  // a third of the time for long lines
  bool all_good = true;
  for (std::string line; read_line(std::cin, line);) {
    if (is_blank(line)) continue;
    const CallAnswer answer = line.size() > longest_line
                                  ? caller.mistake("the line is longer than " + std::to_string(longest_line) + " bytes")
                                  : caller.answer(line);
    print(answer.json);
    all_good = all_good && answer.good;
  }
  return all_good;
}

/// "solution" or "fast", or nothing for the default; a folder is a submission's.
std::string whose(const Call& call) { return call.submissions.with.empty() ? "" : call.submissions.with.back(); }

/// The functions of a submission, if one is asked.
std::unique_ptr<RemoteTable> remote_table(const Call& call, const TaskInfo& task) {
  if (whose(call).empty() || whose(call) == "solution" || whose(call) == "fast") return nullptr;
  if (!call.precision.empty()) throw Failure("--precision goes with --with solution and --with fast", wrong_usage);
  const int stage = stage_of(task.label);
  const std::vector<Chosen> all = chosen_submissions(call.submissions);
  if (std::none_of(all.begin(), all.end(), [&](const Chosen& chosen) { return stage_files(chosen.folder).contains(stage); }))
    throw Failure("--with: there is no " + stage_file(stage) + " in " + whose(call), wrong_usage);
  return std::make_unique<RemoteTable>(build_with(call.submissions, stage, stage));
}

void run(const Call& call) {
  if (call.list) return list_tasks();
  if (call.task.empty()) throw Failure("name a task; 'raylab call --list' lists them", wrong_usage);
  const TaskInfo& task = find_task(call.task);
  const std::unique_ptr<RemoteTable> remote = remote_table(call, task);
  const TaskCaller caller(remote ? remote->table() : table_for(whose(call), call.precision), task);
  if (call.from_input) {
    if (!answer_lines(caller)) throw CLI::RuntimeError(failure);
    return;
  }
  try {
    print(caller.call(call.arguments));
  } catch (const InputError& error) {
    throw Failure(error.what(), wrong_usage);
  }
}

}  // namespace

void add_call(CLI::App& app) {
  CLI::App* command = app.add_subcommand("call", "Call one task's function on given data; the result as JSON");
  const auto call = std::make_shared<Call>();
  CLI::Option* task = command->add_option("TASK", call->task, "A task, by label (2.2) or name (sphere_hit)");
  const CLI::Option* arguments = command->add_option(
      "JSON", call->arguments, "Its arguments, a JSON object; default: one such object a line from standard input");
  command->add_option("--with", call->submissions.with, "Whose function: solution (default), fast, or a submission's folder")
      ->type_name("WHOSE")
      ->allow_extra_args(false)
      ->take_all();
  command->add_flag("--sanitize", call->submissions.sanitize,
                    "Run a submission with checks of addresses and of undefined behaviour");
  command->add_option("--precision", call->precision, "f64 (default), f32, or oracle: the nearest doubles to the truth")
      ->check(CLI::IsMember({"f32", "f64", "oracle"}))
      ->type_name("PRECISION");
  command->add_flag("--list", call->list, "List the tasks, each with its arguments and an example")->excludes(task);
  command->footer(
      "Without JSON it answers each line of standard input with one line, at once; a line with a mistake gets\n"
      "{\"task\":...,\"error\":...}, and the rest goes on. Blank lines get no answer. docs/call.md has the format.\n"
      "Exit code: 0 all calls have a result, 1 a line or the function failed, 2 wrong usage or wrong JSON.\n\n"
      "Examples:\n"
      "  raylab call --list\n"
      "  raylab call reflect '{\"d\": [0.6, -0.8, 0], \"n\": [0, 1, 0]}'\n"
      "  raylab call 6.2 '{\"cos_theta\": \"0x1p-1\", \"refractive_index\": 1.5}' --precision oracle\n"
      "  raylab call 2.2 <cases.jsonl >answers.jsonl\n"
      "  raylab call 2.2 --with my-lab <cases.jsonl");
  command->callback([call, arguments] {
    call->from_input = arguments->count() == 0;
    run(*call);
  });
}

}  // namespace raylab::cli
