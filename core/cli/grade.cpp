#include "core/calls/call_task.hpp"
#include "core/cli/command.hpp"
#include "core/cli/engines.hpp"
#include "core/cli/grade_views.hpp"
#include "core/cli/progress_bar.hpp"
#include "core/cli/watched_render.hpp"
#include "core/grade/class_folder.hpp"
#include "core/grade/class_reports.hpp"
#include "core/grade/grade_submission.hpp"
#include "core/image/data_folder.hpp"
#include "core/image/file_hash.hpp"
#include "core/image/partial_file.hpp"
#include "core/results/counted.hpp"
#include "core/results/github.hpp"
#include "core/results/gradescope.hpp"
#include "core/results/plain_text.hpp"
#include "core/scene/read_file.hpp"
#include "core/submission/child_process.hpp"
#include "core/submission/compiler.hpp"
#include "tests/hints/hints.hpp"
#include "tests/runner.hpp"
#include "tests/selection.hpp"

#include <sys/resource.h>
#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <mutex>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace raylab::cli {
namespace {

namespace fs = std::filesystem;

struct Grade {
  std::vector<std::string> folders;
  std::string out;
  std::string config;
  std::string seed;
  std::string shard;
  unsigned jobs = 0;
  bool unsafe = false;
  std::string gradescope;
  bool github = false;
  std::string id;  ///< of `grade-one`
};

constexpr std::chrono::seconds time_beside_answers{1800};  // to compile a submission, and for all that raylab does

// ---- What all of it needs -------------------------------------------------------------------------------------------

Grading checked(GradingFile file) {
  for (const Diagnostic& diagnostic : file.diagnostics) std::cerr << to_string(diagnostic) << '\n';
  if (!file.grading) throw Failure("the grading file has mistakes: they stand above", wrong_usage);
  return std::move(*file.grading);
}

fs::path usual_config() { return data_folder("course/grading.toml"); }

/// Has the solution an answer to each hidden test?
void require_answers(const Grading& grading) {
  for (std::size_t k = 0; k < grading.hidden.size(); ++k) try {
      const HiddenTest& test = grading.hidden[k];
      TaskCaller(solution_table(), task_info(test.task)).result(test.call);
    } catch (const std::exception& error) {
      throw Failure("the grading file's hidden_test[" + std::to_string(k) + "].call: " + error.what(), wrong_usage);
    }
}

Grading grading_of(const std::string& config) {
  Grading grading = checked(read_grading(usual_config(), {}));
  if (!config.empty()) grading = checked(read_grading(config, grading));
  require_answers(grading);
  return grading;
}

/// All that decides a result.
std::string inputs_of(const TakenFiles& files, const std::string& config, const std::string& seed) {
  std::string all = std::string(RAYLAB_VERSION) + '\n' + seed + '\n' + file_hash(usual_config()) + '\n';
  if (!config.empty()) all += file_hash(config) + '\n';
  for (const auto& [stage, text] : files.texts)
    all += std::to_string(stage) + ' ' + std::to_string(text.size()) + '\n' + text;
  for (const auto& [stage, why] : files.refused) all += std::to_string(stage) + ' ' + why + '\n';
  for (const std::string& note : files.notes) all += note + '\n';
  return text_hash(all);
}

void require_safe(const Sandbox& sandbox, bool unsafe) {
  if (sandbox.is_safe() || unsafe) return;
  std::string text = "this machine cannot keep strangers' code from itself:\n";
  for (const Protection& protection : sandbox.protections())
    if (!protection.holds) text += "  not " + protection.name + ": " + protection.by + '\n';
  throw Failure(text +
                "Install bubblewrap, or see 'raylab doctor'; --unsafe grades all the same, and says so in the report");
}

// ---- One submission, in a process of its own ------------------------------------------------------------------------

/// Lines as they are printed below a test's name, without the blanks before all of them.
std::string without_indent(const std::string& text) {
  std::istringstream lines(text);
  std::string all;
  for (std::string line; std::getline(lines, line);) all += line.substr(std::min(line.size(), test::failure_indent)) + '\n';
  return all;
}

TestOutcome run_unit_tests(std::string_view task, const StageTable& table) {
  std::ostringstream nowhere;
  const auto no_images = [](const Scene&, const Settings&) -> std::unique_ptr<Engine> {
    throw std::logic_error("a task's tests need no image");
  };
  const test::Totals totals = test::tell_tests(test::tests_of_submission(task), table, no_images, with_submission, nowhere);
  TestOutcome outcome{static_cast<int>(totals.passed), {}};
  for (std::size_t k = 0; k < totals.failures.size(); ++k)
    outcome.failed.push_back({totals.failures[k], without_indent(totals.texts[k])});
  return outcome;
}

WrongTask look_at(std::string_view task, const AskTask& ask, int level) {
  const std::vector<test::Hint> hints = test::find_hints(solution_table(), ask, test::find_probes(solution_table(), {task}));
  if (hints.empty()) return {};
  return {level > 0 ? test::hints_text(hints, level) : "", hints.front().mistake};
}

double processor_seconds() {
  double seconds = 0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage used{};
    getrusage(who, &used);
    for (const timeval& time : {used.ru_utime, used.ru_stime})
      seconds += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  }
  return seconds;
}

void grade_one(const Grade& wanted) {
  adopt_orphans();
  const ClassFolder out(wanted.out, wanted.seed);
  const Grading grading = grading_of(wanted.config);
  const TakenFiles files = take_files(wanted.folders.front());
  const Sandbox sandbox;
  require_safe(sandbox, wanted.unsafe);
  const GradingTools tools{sandbox, solution_table(), run_unit_tests, look_at};
  const std::vector<View> views = grading_views(grading, wanted.seed, out.path() / "views");
  SubmissionResult result = grade_submission(files, grading, views, tools, out.submission(wanted.id));
  result.id = wanted.id;
  result.inputs = inputs_of(files, wanted.config, wanted.seed);
  end_children();
  out.finish(result, processor_seconds());
}

// ---- A class --------------------------------------------------------------------------------------------------------

std::string drawn_seed() {
  std::random_device device;
  return text_hash(std::to_string(device()) + ' ' + std::to_string(device()) + ' ' + std::to_string(device())).substr(0, 16);
}

std::vector<Submitted> wanted_shard(const Grade& wanted, const std::vector<Submitted>& all) {
  if (wanted.shard.empty()) return all;
  std::size_t k = 0, n = 0;
  char slash = 0;
  std::istringstream text(wanted.shard);
  if (!(text >> k >> slash >> n) || slash != '/' || !text.eof() || k < 1 || k > n)
    throw Failure("--shard: wanted I/N, from 1/N to N/N, got '" + wanted.shard + "'", wrong_usage);
  return shard(all, k - 1, n);
}

/// Runs this program on one submission. What goes wrong is raylab's fault, and becomes a result too.
void run_one(const Grade& wanted, const Submitted& submitted, const ClassFolder& out, const Grading& grading) {
  std::vector<std::string> command{fs::read_symlink("/proc/self/exe").string(),
                                   "grade-one",
                                   submitted.folder.string(),
                                   "--id",
                                   submitted.id,
                                   "--out",
                                   wanted.out,
                                   "--seed",
                                   out.seed()};
  if (!wanted.config.empty()) command.insert(command.end(), {"--config", wanted.config});
  if (wanted.unsafe) command.emplace_back("--unsafe");
  const std::chrono::seconds answers(static_cast<long>(grading.submission_seconds));
  const Finished finished = run_program(command, {answers + time_beside_answers, std::size_t{16} << 10U});
  if (finished.good) return;
  SubmissionResult result = not_graded(grading, "raylab could not grade it: " + finished.output);
  result.id = submitted.id;
  out.finish(result, 0);
}

/// Those that are not finished yet, each by a process of its own, so that one can neither harm nor slow another one.
void run_all(const Grade& wanted, const std::vector<Submitted>& all, const ClassFolder& out, const Grading& grading) {
  std::vector<const Submitted*> rest;
  for (const Submitted& submitted : all)
    if (!out.finished(submitted.id, inputs_of(take_files(submitted.folder), wanted.config, out.seed())))
      rest.push_back(&submitted);
  const std::size_t kept = all.size() - rest.size();
  if (kept > 0) std::cerr << "raylab: " << kept << " of " << all.size() << " submissions are graded already\n";
  std::atomic<std::size_t> next = 0, done = 0;
  std::mutex mutex;
  std::exception_ptr error;
  const std::atomic<bool>& stop = interrupt_flag();
  const auto work = [&] {
    for (std::size_t k = next++; k < rest.size() && !stop; k = next++) {
      try {
        run_one(wanted, *rest[k], out, grading);
      } catch (...) {  // a full disk, say: the others would fail too
        const std::lock_guard lock(mutex);
        error = std::current_exception();
        next = rest.size();
      }
      ++done;
    }
  };
  std::vector<std::thread> threads;
  for (unsigned k = 0; k < thread_count(wanted.jobs); ++k) threads.emplace_back(work);
  {
    ProgressBar bar("grading");
    while (done < rest.size() && !stop && next < rest.size() + threads.size()) {
      bar.show(static_cast<double>(done) / static_cast<double>(std::max<std::size_t>(1, rest.size())),
               "graded " + std::to_string(kept + done) + " of " + std::to_string(all.size()));
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
  }
  for (std::thread& thread : threads) thread.join();
  if (error) std::rethrow_exception(error);
  if (stop)
    throw Failure("interrupted: " + std::to_string(kept + done) + " of " + std::to_string(all.size()) +
                      " submissions are graded, and kept; the same command does the rest",
                  interrupted);
}

void print_marks(const std::vector<Submitted>& all, const ClassResults& results) {
  constexpr std::size_t most_lines = 50;
  for (std::size_t k = 0; k < std::min(all.size(), most_lines); ++k)
    for (const SubmissionResult& result : results.submissions)
      if (result.id == all[k].id)
        std::cout << plain_line(all[k].name) << ": " << points_text(counted_points(result)) << ", bonus "
                  << points_text(counted_bonus(result)) << (needs_new_run(result) ? ", to be graded again" : "") << '\n';
  if (all.size() > most_lines) std::cout << "and " << all.size() - most_lines << " more\n";
}

ClassRun run_in(const Sandbox& sandbox, bool unsafe) {
  ClassRun run{RAYLAB_VERSION, unsafe && !sandbox.is_safe(), {}};
  for (const Protection& protection : sandbox.protections())
    run.guarantees.push_back({protection.name, protection.holds, protection.by});
  return run;
}

/// The one submission of a run that says it to somebody else.
const SubmissionResult& only(const ClassResults& results, const std::vector<Submitted>& all) {
  const auto found = std::find_if(results.submissions.begin(), results.submissions.end(),
                                  [&](const SubmissionResult& result) { return result.id == all.front().id; });
  if (all.size() != 1 || found == results.submissions.end())
    throw Failure("--gradescope and --github are for one submission, and these are " + std::to_string(all.size()),
                  wrong_usage);
  return *found;
}

/// Adds to the file that GitHub shows as the step's summary, and prints what it shows beside the lines.
void tell_github(const SubmissionResult& result) {
  if (const char* const file = std::getenv("GITHUB_STEP_SUMMARY")) {
    std::ofstream stream(file, std::ios::app);
    stream << github_summary(result);
    if (!stream.flush()) throw Failure(std::string(file) + ": cannot be written");
  }
  std::cout << github_annotations(result);
}

ClassResults graded(Grade& wanted, std::vector<Submitted>& all) {
  const Grading grading = grading_of(wanted.config);
  if (wanted.seed.empty()) wanted.seed = ClassFolder::seed_of(wanted.out).value_or(drawn_seed());
  all = wanted_shard(wanted, find_submissions(wanted.folders, wanted.seed));
  const Sandbox sandbox;
  require_safe(sandbox, wanted.unsafe);
  const ClassFolder out(wanted.out, wanted.seed);
  out.write_run(run_in(sandbox, wanted.unsafe));
  std::vector<RosterEntry> roster;
  for (const Submitted& submitted : all) roster.push_back({submitted.id, submitted.name});
  out.enroll(roster);
  grading_views(grading, wanted.seed, out.path() / "views");
  StageCompiler({false, false, &sandbox}).prepare();
  run_all(wanted, all, out, grading);
  return write_reports(out);
}

void grade(Grade wanted) {
  umask(S_IWGRP | S_IWOTH);  // the sandbox's user reads some of what is written
  const auto write_gradescope = [&](const std::string& json) {
    if (!wanted.gradescope.empty()) write_file(wanted.gradescope, [&](std::ostream& stream) { stream << json; });
  };
  write_gradescope(gradescope_failure("raylab did not come to an end; ask your instructor to run it again"));
  std::vector<Submitted> all;
  try {
    const ClassResults results = graded(wanted, all);
    print_marks(all, results);
    if (!wanted.gradescope.empty()) write_gradescope(gradescope_json(only(results, all)));
    if (wanted.github) tell_github(only(results, all));
  } catch (const std::exception& error) {
    write_gradescope(gradescope_failure(error.what()));
    throw;
  }
  std::cout << (fs::path(wanted.out) / "index.html").string() << '\n';
}

struct Merge {
  std::vector<std::string> folders;
  std::string out;
};

void merge(const Merge& wanted) {
  const std::optional<std::string> seed = ClassFolder::seed_of(wanted.folders.front());
  if (!seed) throw Failure(wanted.folders.front() + ": was not written by 'raylab grade'", wrong_usage);
  const ClassFolder out(wanted.out, *seed);
  out.write_run(ClassFolder(wanted.folders.front(), *seed).run());
  for (const std::string& folder : wanted.folders) {
    const std::optional<std::string> own = ClassFolder::seed_of(folder);
    if (!own) throw Failure(folder + ": was not written by 'raylab grade'", wrong_usage);
    out.take_over(ClassFolder(folder, *own));
  }
  const ClassResults results = write_reports(out);
  std::cout << results.submissions.size() << " submissions: " << (fs::path(wanted.out) / "index.html").string() << '\n';
}

void add_common(CLI::App& command, Grade& wanted) {
  command.add_option("--out", wanted.out, "The folder for results and reports")->required()->type_name("OUT");
  command.add_option("--config", wanted.config, "A grading.toml, in place of the usual one")
      ->check(CLI::ExistingFile)
      ->type_name("FILE");
  command.add_option("--seed", wanted.seed, "Decides the hidden cameras and the ids; default: a new one")->type_name("TEXT");
  command.add_flag("--unsafe", wanted.unsafe, "Grade even where this machine cannot keep strangers' code from itself");
}

}  // namespace

void add_grade(CLI::App& app) {
  const auto wanted = std::make_shared<Grade>();
  CLI::App* command = app.add_subcommand("grade", "Grade submissions: one, or a folder of hundreds");
  command->add_option("DIR", wanted->folders, "A submission, or a folder of submissions")->required();
  add_common(*command, *wanted);
  command->add_option("--jobs", wanted->jobs, "How many to grade at a time; default: as many as there are cores")
      ->type_name("N");
  command
      ->add_option("--shard", wanted->shard, "Only the I-th of N parts of them: 1/4; 'raylab merge' makes one of the parts")
      ->type_name("I/N");
  command->add_option("--gradescope", wanted->gradescope, "Write Gradescope's results.json there, for one submission")
      ->type_name("FILE");
  command->add_flag("--github", wanted->github, "Write GitHub's step summary and annotations, for one submission");
  command->footer(
      "The submissions' code runs in a sandbox ('raylab doctor' says in which). Each finished submission is kept: the same\n"
      "command goes on after an interruption, and grades anew what has changed since. OUT/index.html shows all of it.\n\n"
      "Exit code: 0 graded, whatever the marks; 1 something went wrong, 2 wrong usage, 130 interrupted.\n\n"
      "Examples:\n"
      "  raylab grade submissions --out graded\n"
      "  raylab grade submissions/mia --out graded-mia --config grading.toml\n"
      "  raylab grade submissions --out part-1 --shard 1/4 --seed spring");
  command->callback([wanted] { grade(*wanted); });

  const auto one = std::make_shared<Grade>();
  CLI::App* inner = app.add_subcommand("grade-one", "What 'raylab grade' runs for each submission")->group("");
  inner->add_option("DIR", one->folders)->required()->expected(1);
  inner->add_option("--id", one->id)->required();
  add_common(*inner, *one);
  inner->callback([one] { grade_one(*one); });

  const auto merged = std::make_shared<Merge>();
  CLI::App* merger = app.add_subcommand("merge", "Make one class of what 'raylab grade --shard' has graded in parts");
  merger->add_option("OUT", merged->folders, "Folders that were graded with the same seed")->required();
  merger->add_option("--out", merged->out, "The folder for all of it")->required()->type_name("DIR");
  merger->footer("Example:\n  raylab merge part-1 part-2 part-3 part-4 --out graded");
  merger->callback([merged] { merge(*merged); });
}

}  // namespace raylab::cli
