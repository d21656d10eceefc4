#include "core/cli/command.hpp"
#include "core/cli/grade_views.hpp"
#include "core/cli/grading_options.hpp"
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
#include "core/submission/child_process.hpp"
#include "core/submission/compiler.hpp"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <memory>
#include <mutex>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace raylab::cli {
namespace {

namespace fs = std::filesystem;

struct Grade {
  GradingOptions options;
  std::vector<std::string> folders;
  std::string shard;
  unsigned jobs = 0;
  std::string gradescope;
  bool github = false;
};

constexpr std::chrono::seconds time_beside_answers{1800};  // to compile a submission, and for all that raylab does

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
  std::vector<std::string> command{running_program().string(),
                                   "grade-one",
                                   submitted.folder.string(),
                                   "--id",
                                   submitted.id,
                                   "--out",
                                   wanted.options.out,
                                   "--seed",
                                   out.seed()};
  if (!wanted.options.config.empty()) command.insert(command.end(), {"--config", wanted.options.config});
  if (wanted.options.unsafe) command.emplace_back("--unsafe");
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
    if (!out.finished(submitted.id, inputs_of(take_files(submitted.folder), wanted.options))) rest.push_back(&submitted);
  const std::size_t kept = all.size() - rest.size();
  if (kept > 0) std::cerr << "raylab: " << kept << " of " << all.size() << " submissions are graded already\n";
  std::atomic<std::size_t> next = 0, done = 0;
  std::atomic<unsigned> running = thread_count(wanted.jobs);
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
    --running;
  };
  std::vector<std::thread> threads;
  for (unsigned k = running; k > 0; --k) threads.emplace_back(work);
  {
    ProgressBar bar("grading");
    while (running > 0) {
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

ClassRun run_in(const Sandbox& sandbox, bool unsafe) {
  ClassRun run{RAYLAB_VERSION, unsafe && !sandbox.is_safe(), {}};
  for (const Protection& protection : sandbox.protections())
    run.guarantees.push_back({protection.name, protection.holds, protection.by});
  return run;
}

void require_one(const Grade& wanted, const std::vector<Submitted>& all) {
  if (all.size() != 1 && (wanted.github || !wanted.gradescope.empty()))
    throw Failure("--gradescope and --github are for one submission, and these are " + std::to_string(all.size()),
                  wrong_usage);
}

const SubmissionResult& result_of(const Submitted& submitted, const ClassResults& results) {
  for (const SubmissionResult& result : results.submissions)
    if (result.id == submitted.id) return result;
  throw std::logic_error("a submission has no result");
}

void print_marks(const std::vector<Submitted>& all, const ClassResults& results) {
  constexpr std::size_t most_lines = 50;
  for (std::size_t k = 0; k < std::min(all.size(), most_lines); ++k) {
    const SubmissionResult& result = result_of(all[k], results);
    std::cout << plain_line(all[k].name) << ": " << points_text(counted_points(result)) << ", bonus "
              << points_text(counted_bonus(result)) << (needs_new_run(result) ? ", to be graded again" : "") << '\n';
  }
  if (all.size() > most_lines) std::cout << "and " << all.size() - most_lines << " more\n";
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
  const Grading grading = grading_of(wanted.options.config);
  if (wanted.options.seed.empty()) wanted.options.seed = ClassFolder::seed_of(wanted.options.out).value_or(drawn_seed());
  all = wanted_shard(wanted, find_submissions(wanted.folders, wanted.options.seed));
  require_one(wanted, all);
  const Sandbox sandbox;
  require_safe(sandbox, wanted.options.unsafe);
  const ClassFolder out(wanted.options.out, wanted.options.seed);
  out.write_run(run_in(sandbox, wanted.options.unsafe));
  std::vector<RosterEntry> roster;
  for (const Submitted& submitted : all) roster.push_back({submitted.id, submitted.name});
  out.enroll(roster);
  grading_views(grading, wanted.options.seed, out.path() / "views");
  StageCompiler({false, false, &sandbox}).prepare();
  run_all(wanted, all, out, grading);
  return write_reports(out);
}

void grade(Grade wanted) {
  const auto write_gradescope = [&](const std::string& json) {
    if (!wanted.gradescope.empty()) write_file(wanted.gradescope, json);
  };
  write_gradescope(gradescope_failure("raylab did not come to an end; ask your instructor to run it again"));
  std::vector<Submitted> all;
  try {
    const ClassResults results = graded(wanted, all);
    print_marks(all, results);
    if (!wanted.gradescope.empty()) write_gradescope(gradescope_json(result_of(all.front(), results)));
    if (wanted.github) tell_github(result_of(all.front(), results));
  } catch (const std::exception& error) {
    write_gradescope(gradescope_failure(error.what()));
    throw;
  }
  std::cout << (fs::path(wanted.options.out) / "index.html").string() << '\n';
}

}  // namespace

void add_grade(CLI::App& app) {
  const auto wanted = std::make_shared<Grade>();
  CLI::App* command = app.add_subcommand("grade", "Grade submissions: one, or a folder of hundreds");
  command->add_option("DIR", wanted->folders, "A submission, or a folder of submissions")->required();
  add_grading_options(*command, wanted->options);
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
}

}  // namespace raylab::cli
