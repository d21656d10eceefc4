#include "core/grade/grading.hpp"

#include "core/render/stage_table.hpp"
#include "core/scene/read_file.hpp"
#include "core/scene/read_section.hpp"
#include "core/scene/read_toml.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace raylab {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t most_bytes = 1U << 20U;
constexpr std::array seconds_rules{must_be_finite,
                                   Rule{[](double x) { return x >= 0.1 && x <= 3600; }, "must be between 0.1 and 3600"}};
constexpr std::array points_rules{must_be_finite, not_negative};
constexpr std::array share_rules{must_be_finite, Rule{[](double x) { return x >= 0 && x <= 1; }, "must be between 0 and 1"}};

void read_limits(Section& section, Grading& grading) {
  section.number("call", Need::optional, grading.call_seconds, seconds_rules);
  section.number("image", Need::optional, grading.image_seconds, seconds_rules);
  section.number("submission", Need::optional, grading.submission_seconds, seconds_rules);
  section.whole("memory", Need::optional, grading.megabytes, 64, 1 << 20);
  section.finish();
}

void read_images(Section& section, Grading& grading) {
  section.number("none_at", Need::optional, grading.none_at, share_rules);
  section.whole("width", Need::optional, grading.size.width, 16, 1024);
  section.whole("height", Need::optional, grading.size.height, 16, 1024);
  section.finish();
}

void read_stage(Section& section, std::vector<StageGrading>& stages) {
  int number = 0;
  StageGrading ignored;
  const bool known = section.whole("stage", Need::required, number, 1, static_cast<int>(stages.size()));
  StageGrading& stage = known ? stages[static_cast<std::size_t>(number - 1)] : ignored;
  section.number("points", Need::optional, stage.points, points_rules);
  section.flag("bonus", Need::optional, stage.bonus);
  section.number("images", Need::optional, stage.images, share_rules);
  section.text("shown", Need::optional, stage.shown);
  section.texts("scenes", Need::optional, stage.scenes);
  section.finish();
}

void read_hidden(Section& section, std::vector<HiddenTest>& tests) {
  HiddenTest test;
  const bool task = section.text("task", Need::required, test.task);
  const bool call = section.text("call", Need::required, test.call);
  section.finish();
  const auto tasks = task_list();
  if (task && std::none_of(tasks.begin(), tasks.end(), [&](const TaskInfo& info) { return info.label == test.task; }))
    section.error("task", "there is no task " + raylab::quoted(test.task) + ": 'raylab stages' lists them");
  else if (task && call)
    tests.push_back(std::move(test));
}

}  // namespace

GradingFile read_grading(const fs::path& path, const Grading& defaults) {
  Report report(path.string());
  const FileText file = read_file(path, most_bytes);
  if (!file.text) {
    report.error({}, "", file.error);
    return {{}, report.sorted()};
  }
  const std::optional<TomlTable> toml = parse_toml(*file.text, report);
  if (!toml) return {{}, report.sorted()};
  Grading grading = defaults;
  grading.stages.resize(stage_list().size());
  Section whole(*toml, "", {1, 1}, report);
  if (auto section = whole.table("limits")) read_limits(*section, grading);
  if (auto section = whole.table("images")) read_images(*section, grading);
  if (auto section = whole.table("hints")) {
    section->whole("level", Need::optional, grading.hint, 0, 3);
    section->finish();
  }
  for (Section& section : whole.tables("stage")) read_stage(section, grading.stages);
  for (Section& section : whole.tables("hidden_test")) read_hidden(section, grading.hidden);
  whole.finish();
  if (report.has_error()) return {{}, report.sorted()};
  return {std::move(grading), report.sorted()};
}

double image_credit(std::size_t outside, std::size_t allowed, std::size_t pixels, double none_at) {
  if (outside <= allowed) return 1;
  const double all = static_cast<double>(pixels), least = std::max(static_cast<double>(allowed), 1.) / all;
  const double share = static_cast<double>(outside) / all;
  if (share >= none_at || none_at <= least) return 0;
  return std::min(1., std::log(none_at / share) / std::log(none_at / least));
}

}  // namespace raylab
