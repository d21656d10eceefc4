#include "core/explain/explanation.hpp"

#include "core/cli/command.hpp"
#include "core/cli/engines.hpp"
#include "core/cli/hints.hpp"
#include "core/cli/load_scene.hpp"
#include "core/cli/watched_render.hpp"
#include "core/explain/explain_image.hpp"
#include "core/image/partial_file.hpp"
#include "core/submission/remote_table.hpp"
#include "core/submission/worker_engine.hpp"

#include <charconv>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace raylab::cli {
namespace {

constexpr int longer_side_to_compare = 160;  // pixels, of images that are searched for differences
constexpr std::size_t most_pixels = 60;      // that are asked about

struct Explain {
  std::string scene;
  RenderOptions options;
  std::string pixel;
  bool json = false;
  std::string svg;
  int hint = 0;
};

struct Pixel {
  int column, row;
};

Pixel parse_pixel(const std::string& text, ImageSize size) {
  Pixel pixel{};
  const char* const end = text.data() + text.size();
  const auto [comma, error] = std::from_chars(text.data(), end, pixel.column);
  if (error == std::errc{} && comma != end && *comma == ',') {
    const auto [last, second] = std::from_chars(comma + 1, end, pixel.row);
    if (second == std::errc{} && last == end && pixel.column >= 0 && pixel.column < size.width && pixel.row >= 0 &&
        pixel.row < size.height)
      return pixel;
  }
  throw Failure("--pixel: wanted X,Y, from 0,0 at the top left to " + std::to_string(size.width - 1) + "," +
                    std::to_string(size.height - 1) + " at the bottom right, got '" + text + "'",
                wrong_usage);
}

/// Somebody's tasks, asked one at a time, and images by them.
class Submission {
 public:
  explicit Submission(const WorkerSetup& setup) : setup_(setup), tasks_(setup) {}

  AskTask ask() {
    return [this](const TaskInfo& task, const std::string& arguments) { return tasks_.ask(task, arguments); };
  }
  std::unique_ptr<Engine> engine(const Scene& scene, const Settings& settings, unsigned threads) const {
    return make_worker_engine(scene, settings, setup_, threads, tell_stand_in);
  }
  const std::string& with() const { return setup_.with; }

 private:
  WorkerSetup setup_;
  RemoteTable tasks_;
};

OtherView view_of(Submission& submission, const Scene& scene, const Settings& settings, Pixel pixel,
                  const Recording& recording) {
  OtherView view;
  view.with = submission.with();
  for (const Event& event : recording.events) view.calls += std::holds_alternative<RecordedCall>(event);
  view.difference = first_difference(recording, submission.ask());
  try {
    std::vector<Color> row(static_cast<std::size_t>(settings.size.width));
    RayCounts counts;
    submission.engine(scene, settings, 1)->trace_rows(pixel.row, row, counts, interrupt_flag());
    view.color = row[static_cast<std::size_t>(pixel.column)];
  } catch (const std::runtime_error& error) {
    view.error = error.what();
  }
  return view;
}

/// Returns whether the submission, if there is one, differs.
bool explain_pixel(const Explain& explain, const Scene& scene, Submission* submission) {
  const Settings settings = settings_for(scene, explain.options);
  const Pixel pixel = parse_pixel(explain.pixel, settings.size);
  const Recording recording = record_pixel(scene, settings, solution_table(), pixel.column, pixel.row);
  Explanation explanation{explain.scene, settings, pixel.column, pixel.row, recording.color, ray_trees(scene, recording),
                          std::nullopt};
  if (submission) explanation.other = view_of(*submission, scene, settings, pixel, recording);
  if (!explain.svg.empty())
    write_file(explain.svg, [&](std::ostream& stream) { stream << explanation_svg(scene, explanation); });
  std::cout << (explain.json ? explanation_json(scene, explanation) : explanation_text(scene, explanation));
  if (!explain.svg.empty() && !explain.json) std::cout << '\n' << explain.svg << '\n';
  return explanation.other && (explanation.other->difference || !explanation.other->color);
}

/// Without a pixel: those that differ most, by what differs first in them. Returns whether there are any.
bool explain_image(const Explain& explain, const Scene& scene, Submission& submission) {
  Settings settings = settings_for(scene, explain.options);
  if (explain.options.size.empty()) settings.size = fitted(scene.image, longer_side_to_compare);
  const ImageDifferences found = find_differences(scene, settings, solution_table(),
                                                  *submission.engine(scene, settings, thread_count(explain.options.threads)),
                                                  submission.ask(), thread_count(explain.options.threads), most_pixels);
  std::cout << (explain.json ? differences_json(found)
                             : differences_text(explain.scene, settings, found, submission.with()));
  return found.differing > 0 || !found.error.empty();
}

std::vector<std::string_view> tasks_up_to(const Explain& explain) {
  std::vector<std::string_view> labels;
  for (const TaskInfo& task : task_list())
    if (stage_of(task.label) <= find_stage(explain.options.stage).number) labels.push_back(task.label);
  return labels;
}

/// Returns whether a submission differs.
bool run(const Explain& explain) {
  const Scene scene = load_scene(explain.scene);
  std::optional<Submission> submission;
  const bool with = !explain.options.submissions.with.empty();
  if (!with && explain.pixel.empty())
    throw Failure("name a pixel with --pixel X,Y, or somebody's code with --with DIR, or both", wrong_usage);
  if (!with && explain.hint > 0) throw Failure("--hint goes with --with", wrong_usage);
  if (explain.pixel.empty() && !explain.svg.empty()) throw Failure("--svg goes with --pixel", wrong_usage);
  if (with) {
    const int stage = settings_for(scene, explain.options).stage;
    submission.emplace(build_with(explain.options.submissions, 1, stage));
  }
  const bool differs = explain.pixel.empty() ? explain_image(explain, scene, *submission)
                                             : explain_pixel(explain, scene, submission ? &*submission : nullptr);
  if (submission && !explain.json) print_hints(submission->ask(), tasks_up_to(explain), explain.hint);
  return differs;
}

}  // namespace

void add_explain(CLI::App& app) {
  CLI::App* command = app.add_subcommand("explain", "Say how a pixel gets its color, and where somebody's code goes wrong");
  const auto explain = std::make_shared<Explain>();
  command->add_option("SCENE", explain->scene, "Scene file (TOML)")->required();
  command
      ->add_option("--stage", explain->options.stage,
                   "The last stage that takes part, by name or number; default: the last of all")
      ->type_name("STAGE");
  command->add_option("--pixel", explain->pixel, "Column and row, from 0,0 at the top left")->type_name("X,Y");
  add_common_options(*command, explain->options);
  add_hint_option(*command, explain->hint);
  command->add_flag("--json", explain->json, "Print JSON for programs");
  command->add_option("--svg", explain->svg, "Draw the pixel's rays, from above and from the side")->type_name("FILE");
  command->footer(
      "Prints the solution's tree of rays: what each meets, what each light gives, which rays follow with which weight.\n"
      "With --with it also puts each of the pixel's calls, bit for bit, to that code, and shows the first that is answered\n"
      "differently. Without --pixel it looks for the pixels that differ most (in an image of 160 pixels, unless --size "
      "says\n"
      "more) and groups them by that call.\n\n"
      "Exit code: 0 no difference, 1 a difference was found or there is an error, 2 wrong usage.\n\n"
      "Examples:\n"
      "  raylab explain scenes/scene2.toml --pixel 320,240\n"
      "  raylab explain scenes/scene4.toml --stage 6 --pixel 200,260 --svg rays.svg\n"
      "  raylab explain scenes/scene2.toml --stage 4 --pixel 320,240 --with my-lab\n"
      "  raylab explain scenes/scene2.toml --stage 4 --with my-lab --hint 1");
  command->callback([explain] {
    if (run(*explain)) throw CLI::RuntimeError(failure);
  });
}

}  // namespace raylab::cli
