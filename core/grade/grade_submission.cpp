#include "core/grade/grade_submission.hpp"

#include "core/calls/call_task.hpp"
#include "core/explain/explanation.hpp"
#include "core/image/diff.hpp"
#include "core/image/diff_pictures.hpp"
#include "core/image/image_file.hpp"
#include "core/render/render.hpp"
#include "core/results/plain_text.hpp"
#include "core/submission/compiler.hpp"
#include "core/submission/remote_table.hpp"
#include "core/submission/stage_files.hpp"
#include "core/submission/worker_engine.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace raylab {
namespace {

namespace fs = std::filesystem;

/// A verdict that is not `right`, and why.
struct Fault {
  Verdict verdict;
  std::string reason;
  std::string call = {};
};

/// What a submission had a hand in, fit for every report: some lines of UTF-8 without control characters.
std::string tamed(std::string_view text) {
  constexpr std::size_t most_lines = 40, longest = 2000, most_bytes = 8000;
  std::istringstream lines{std::string(text)};
  std::string tame;
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    if (count == most_lines || tame.size() > most_bytes) return tame + "...\n";
    tame += plain_text(line.substr(0, longest)) + '\n';
  }
  while (tame.ends_with('\n')) tame.pop_back();
  return tame;
}

Verdict verdict_of(Trouble trouble) {
  switch (trouble) {
    case Trouble::threw:
    case Trouble::crashed:
      return Verdict::crashed;
    case Trouble::too_slow:
      return Verdict::too_slow;
    case Trouble::out_of_memory:
      return Verdict::out_of_memory;
    case Trouble::no_value:
      return Verdict::refused;
  }
  throw std::logic_error("no such trouble");
}

Fault fault_of(const NoAnswer& error) {
  const std::string text = error.what();  // without the command that repeats the call: the student's page has the call
  return {verdict_of(error.trouble), tamed(text.substr(0, text.find(". It was asked"))), tamed(error.arguments)};
}

std::vector<std::string> labels_of(int stage) { return chosen_tasks({}, stage); }

/// Tasks and images of a stage as they are before anything is known.
StageResult blank_stage(int number, const Grading& grading, const std::vector<View>& views) {
  const StageGrading& plan = grading.stages[static_cast<std::size_t>(number - 1)];
  StageResult stage;
  stage.number = number;
  stage.name = stage_info(number).name;
  stage.bonus = plan.bonus;
  const auto hidden =
      std::count_if(views.begin(), views.end(), [&](const View& v) { return v.stage == number && v.hidden; });
  const std::vector<std::string> labels = labels_of(number);
  const double of_images = hidden > 0 ? plan.points * plan.images : 0;
  for (const std::string& label : labels) {
    TaskResult task;
    task.label = label;
    task.name = task_info(label).name;
    task.points.most = (plan.points - of_images) / static_cast<double>(labels.size());
    stage.tasks.push_back(std::move(task));
  }
  for (const View& view : views) {
    if (view.stage != number) continue;
    ImageResult image;
    image.scene = view.name;
    image.hidden = view.hidden;
    image.width = view.reference.value.width;
    image.height = view.reference.value.height;
    if (view.hidden) image.points.most = of_images / static_cast<double>(hidden);
    stage.images.push_back(std::move(image));
  }
  return stage;
}

void put(const Fault& fault, TaskResult& task) {
  task.verdict = fault.verdict;
  task.reason = fault.reason;
  task.call = fault.call;
}

void put(const Fault& fault, ImageResult& image) {
  image.verdict = fault.verdict;
  image.reason = fault.reason;
}

void put(const Fault& fault, StageResult& stage) {
  for (TaskResult& task : stage.tasks) put(fault, task);
  for (ImageResult& image : stage.images) put(fault, image);
}

// ---- Tasks ----------------------------------------------------------------------------------------------------------

/// A call that was answered.
struct Answered {
  const TaskInfo* task;
  std::string arguments, answer;
};

/// The tasks of a stage, asked in a worker that has nothing but the student's library.
class TaskJudge {
 public:
  TaskJudge(const WorkerSetup& setup, const Grading& grading, const GradingTools& tools)
      : setup_(setup),
        grading_(grading),
        tools_(tools),
        remote_(setup, {[this](const TaskInfo& task, const std::string& arguments, const std::string& answer) {
                          if (answered_.size() < most_repeated) answered_.push_back({&task, arguments, answer});
                        },
                        [this](const NoAnswer& error) {
                          if (!fault_) fault_ = fault_of(error);
                        }}) {}

  void judge(TaskResult& result) {
    const TaskInfo& task = task_info(result.label);
    answered_.clear();
    fault_.reset();
    if (std::optional<std::string> unwritten = not_written(task)) return put({Verdict::not_written, *unwritten}, result);
    TestOutcome outcome = tools_.run_tests(task.label, remote_.table());
    result.tests_passed = outcome.passed;
    for (FailedTest& test : outcome.failed) result.failed.push_back({tamed(test.name), tamed(test.text)});
    if (!fault_) find_inconstancy();
    run_hidden_tests(task, result);
    if (fault_)
      put(*fault_, result);
    else if (!result.failed.empty())
      put({Verdict::wrong, "it fails " + counted(result.failed.size(), "test") + " of " +
                               std::to_string(result.failed.size() + static_cast<std::size_t>(result.tests_passed))},
          result);
    else if (!result.hidden_failed.empty())
      put({Verdict::wrong, "it fails tests of the course that are not published"}, result);
    else
      result.verdict = Verdict::right;
    if (result.verdict == Verdict::right) result.points.got = result.points.most;
    if (result.verdict != Verdict::wrong) return;
    const WrongTask wrong = tools_.look_at(task.label, asker(), grading_.hint);
    result.hint = tamed(wrong.hint);
    result.mistake = tamed(wrong.mistake);
  }

  /// The student's tasks, and the solution's where there is none.
  AskTask asker() {
    return [this](const TaskInfo& task, const std::string& arguments) {
      if (selected(task)) return remote_.ask(task, arguments);
      return TaskCaller(tools_.solution, task).result(arguments);
    };
  }

 private:
  static constexpr std::size_t most_repeated = 200;

  static std::string counted(std::size_t count, const std::string& what) {
    return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
  }

  bool selected(const TaskInfo& task) const {
    const std::vector<std::string>& own = setup_.libraries.back().tasks;
    return std::find(own.begin(), own.end(), task.label) != own.end();
  }

  std::optional<std::string> not_written(const TaskInfo& task) {
    try {
      remote_.ask(task, std::string(task.example));
    } catch (const NotWritten& error) {
      return tamed(error.what());
    } catch (const std::runtime_error&) {  // the tests will say more
    }
    return {};
  }

  /// Whatever happens in one, the published part of the result tells nothing of it, and nor can what is asked later.
  void run_hidden_tests(const TaskInfo& task, TaskResult& result) {
    const std::optional<Fault> published = fault_;
    for (const HiddenTest& test : grading_.hidden) {
      if (test.task != task.label) continue;
      const std::string wanted = TaskCaller(tools_.solution, task).result(test.call);
      std::string got;
      try {
        got = remote_.ask(task, test.call);
      } catch (const std::runtime_error& error) {
        got = error.what();
      }
      if (answers_agree_or_not(wanted, got))
        ++result.hidden_passed;
      else
        result.hidden_failed.push_back({tamed(test.task + " " + test.call), tamed("expected " + wanted + "\ngot " + got)});
    }
    if (result.hidden_passed > 0 || !result.hidden_failed.empty()) remote_.forget();
    fault_ = published;
  }

  /// What a submission sent need not be JSON.
  static bool answers_agree_or_not(const std::string& wanted, const std::string& got) {
    try {
      return answers_agree(wanted, got);
    } catch (const InputError&) {
      return false;
    }
  }

  /// The same calls again, in another process and the other order: is it a function of its inputs?
  void find_inconstancy() {
    std::optional<Worker> other;
    Clock::time_point end;
    for (std::size_t k = answered_.size(); k-- > 0 && !fault_;) {
      const auto& [task, arguments, answer] = answered_[k];
      std::string again;
      try {
        if (!other) {
          other.emplace(setup_);
          end = Clock::now() + setup_.limits.all_calls();
        }
        again = other->ask("call " + std::string(task->label) + ' ' + arguments, setup_.limits.call);
      } catch (const std::runtime_error& error) {
        again = error.what();
      }
      if (again != answer)
        fault_ = Fault{Verdict::wrong,
                       "it is no function of its inputs: asked the same twice, it answered " + tamed(answer) + " and " +
                           tamed(again) + " (a variable that is not set, or that outlives the call?)",
                       tamed(arguments)};
      else if (Clock::now() > end)
        fault_ = Fault{Verdict::too_slow, "it takes too long over its calls, all together, when it is asked again"};
    }
  }

  const WorkerSetup& setup_;
  const Grading& grading_;
  const GradingTools& tools_;
  std::vector<Answered> answered_;
  std::optional<Fault> fault_;
  RemoteTable remote_;
};

// ---- Images ---------------------------------------------------------------------------------------------------------

/// The image by a worker. Throws NoAnswer, NotWritten.
Image rendered(const View& view, const Settings& settings, const WorkerSetup& setup, double seconds) {
  const auto engine = make_worker_engine(view.scene, settings, setup, 1, [](const std::string&) {});
  const auto deadline = Clock::now() + std::chrono::duration<double>(seconds);
  std::atomic<bool> late = false;
  const auto watch = [&](double) { late = Clock::now() > deadline; };
  try {
    return render_image(*engine, settings.size, 1, watch, late);
  } catch (const Cancelled&) {
    throw NoAnswer(Trouble::too_slow, "the image takes more than " + to_text(seconds) + " seconds");
  }
}

/// Of the pixel that is farthest from right: the first call that is answered differently.
std::string first_difference_at_worst(const View& view, const Settings& settings, const Comparison& comparison,
                                      const StageTable& solution, const AskTask& ask) {
  if (comparison.worst.empty()) return {};
  const OutsidePixel& pixel = comparison.worst.front();
  const auto found = first_difference(record_pixel(view.scene, settings, solution, pixel.column, pixel.row), ask);
  const std::string where = "pixel " + std::to_string(pixel.column) + "," + std::to_string(pixel.row);
  if (!found) return where + ": every call is answered as the solution does";
  return tamed(where + ":\n" + difference_text(*found, with_submission));
}

class ImageJudge {
 public:
  ImageJudge(const WorkerSetup& setup, const Grading& grading, const GradingTools& tools, const fs::path& folder)
      : setup_(setup), grading_(grading), tools_(tools), folder_(folder) {}

  void judge(const View& view, const AskTask& ask, ImageResult& result) const {
    const Settings settings{view.stage, {result.width, result.height}, view.scene.max_bounces, {}};
    try {
      const Image image = rendered(view, settings, setup_, grading_.image_seconds);
      const Comparison comparison = compare(image, NumberFormat::float64, view.reference);
      put(comparison, result);
      write(view, image, comparison, result);
      if (!comparison.same && !view.hidden)
        result.difference = first_difference_at_worst(view, settings, comparison, tools_.solution, ask);
    } catch (const NotWritten& error) {
      raylab::put({Verdict::not_written, tamed(error.what())}, result);
    } catch (const NoAnswer& error) {
      raylab::put(fault_of(error), result);
    }
  }

 private:
  void put(const Comparison& comparison, ImageResult& result) const {
    result.outside = comparison.outside;
    result.allowed = comparison.allowed;
    result.verdict = comparison.same ? Verdict::right : Verdict::wrong;
    // Few pixels outside are wrong too if they stand close together.
    const std::size_t counted = comparison.same ? 0 : std::max(comparison.outside, comparison.allowed + 1);
    const std::size_t pixels = static_cast<std::size_t>(result.width) * static_cast<std::size_t>(result.height);
    result.points.got = result.points.most * image_credit(counted, comparison.allowed, pixels, grading_.none_at);
    if (!comparison.same)
      result.reason = std::to_string(comparison.outside) + " of " + std::to_string(pixels) +
                      " pixels are not what they may be" +
                      (comparison.non_finite > 0 ? "; " + std::to_string(comparison.non_finite) + " are no numbers" : "");
  }

  void write(const View& view, const Image& image, const Comparison& comparison, ImageResult& result) const {
    const std::string name =
        std::string(view.hidden ? "hidden" : "images") + "/stage" + std::to_string(view.stage) + "-" + view.name;
    result.image = name + ".png";
    result.reference = name + "-reference.png";
    result.heat = name + "-heat.png";
    write_image(folder_ / result.image, image);
    write_image(folder_ / result.reference, view.reference.value);
    write_image(folder_ / result.heat, heat_map(comparison));
  }

  const WorkerSetup& setup_;
  const Grading& grading_;
  const GradingTools& tools_;
  const fs::path folder_;
};

// ---- Stages ---------------------------------------------------------------------------------------------------------

WorkerSetup setup_for(int stage, const fs::path& library, bool with_earlier_stages, Clock::time_point end,
                      const Grading& grading, const GradingTools& tools) {
  WorkerSetup setup;
  for (int other = 1; with_earlier_stages && other < stage; ++other)
    setup.libraries.push_back({solution_library(other), labels_of(other)});
  setup.libraries.push_back({library, labels_of(stage)});
  setup.sandbox = &tools.sandbox;
  setup.with = with_submission;
  setup.limits.call = std::chrono::milliseconds(static_cast<long>(grading.call_seconds * 1000));
  setup.limits.end = end;
  setup.limits.memory = std::int64_t{grading.megabytes} << 20U;
  return setup;
}

void judge(StageResult& stage, const fs::path& library, Clock::time_point end, const Grading& grading,
           const std::vector<View>& views, const GradingTools& tools, const fs::path& folder) {
  const WorkerSetup alone = setup_for(stage.number, library, false, end, grading, tools);
  const WorkerSetup whole = setup_for(stage.number, library, true, end, grading, tools);
  TaskJudge tasks(alone, grading, tools);
  for (TaskResult& task : stage.tasks) tasks.judge(task);
  const ImageJudge images(whole, grading, tools, folder);
  auto image = stage.images.begin();
  for (const View& view : views)
    if (view.stage == stage.number) images.judge(view, tasks.asker(), *image++);
}

StageResult graded_stage(int number, const TakenFiles& files, const StageCompiler& compiler, Clock::time_point end,
                         const Grading& grading, const std::vector<View>& views, const GradingTools& tools,
                         const fs::path& folder) {
  StageResult stage = blank_stage(number, grading, views);
  const std::string name = stage_file(number);
  if (const auto refused = files.refused.find(number); refused != files.refused.end()) {
    stage.file = name;
    put({Verdict::refused, refused->second}, stage);
  } else if (const auto text = files.texts.find(number); text == files.texts.end()) {
    put({Verdict::not_written, "the submission has no " + name}, stage);
  } else {
    stage.file = name;
    try {
      const StageCompiler::Built built = compiler.build_text(number, text->second, name);
      stage.compiler = tamed(built.warnings);
      judge(stage, built.library, end, grading, views, tools, folder);
    } catch (const DoesNotCompile& error) {
      stage.compiler = tamed(error.what());
      put({Verdict::does_not_compile, "the compiler does not take " + name}, stage);
    }
  }
  for (const TaskResult& task : stage.tasks) stage.points += task.points;
  for (const ImageResult& image : stage.images) stage.points += image.points;
  return stage;
}

void add(StageResult stage, SubmissionResult& result) {
  (stage.bonus ? result.bonus : result.points) += stage.points;
  result.stages.push_back(std::move(stage));
}

}  // namespace

SubmissionResult grade_submission(const TakenFiles& files, const Grading& grading, const std::vector<View>& views,
                                  const GradingTools& tools, const fs::path& folder) {
  SubmissionResult result;
  for (const std::string& note : files.notes) result.notes.push_back(tamed(note));
  const StageCompiler compiler({false, false, &tools.sandbox});
  const Clock::time_point end =
      Clock::now() + std::chrono::ceil<Clock::duration>(std::chrono::duration<double>(grading.submission_seconds));
  for (const StageInfo& stage : stage_list())
    add(graded_stage(stage.number, files, compiler, end, grading, views, tools, folder), result);
  return result;
}

SubmissionResult not_graded(const Grading& grading, const std::string& why) {
  SubmissionResult result;
  result.notes.push_back(tamed(why));
  for (const StageInfo& info : stage_list()) {
    StageResult stage = blank_stage(info.number, grading, {});
    put({Verdict::infrastructure, tamed(why)}, stage);
    for (const TaskResult& task : stage.tasks) stage.points += task.points;
    add(std::move(stage), result);
  }
  return result;
}

}  // namespace raylab
