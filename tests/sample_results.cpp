#include "tests/sample_results.hpp"

#include "core/calls/plain_json.hpp"

namespace raylab::test {
namespace {

FailedTest hidden_test() { return {std::string(secret) + " test", std::string(secret) + " text"}; }

TaskResult right_task(const std::string& label, const std::string& name) {
  TaskResult task;
  task.label = label;
  task.name = name;
  task.verdict = Verdict::right;
  task.points = {1, 1};
  task.tests_passed = 6;
  task.hidden_passed = 2;
  return task;
}

std::string png(const std::string& stage, const std::string& kind) { return "images/" + stage + "_" + kind + ".png"; }

ImageResult right_image(const std::string& scene, const std::string& stage) {
  ImageResult image;
  image.scene = scene;
  image.verdict = Verdict::right;
  image.width = 640;
  image.height = 480;
  image.allowed = 307;
  image.image = png(stage, "image");
  image.reference = png(stage, "reference");
  image.heat = png(stage, "heat");
  return image;
}

ImageResult hidden_image(const std::string& stage) {
  ImageResult image = right_image(std::string(secret) + "-camera", stage);
  image.hidden = true;
  image.points = {2, 2};
  image.reason = image.difference = image.image = image.reference = image.heat = std::string(secret);
  return image;
}

StageResult stage_of(int number, const std::string& name, const std::string& scene,
                     const std::vector<std::string>& functions) {
  StageResult stage;
  stage.number = number;
  stage.name = name;
  stage.bonus = number == 6;
  stage.file = "0" + std::to_string(number) + "_" + name + ".cpp";
  for (const std::string& function : functions)
    stage.tasks.push_back(right_task(std::to_string(number) + "." + std::to_string(stage.tasks.size() + 1), function));
  stage.images = {right_image(scene, stage.file.substr(0, 2)), hidden_image(stage.file.substr(0, 2))};
  return stage;
}

SubmissionResult right_submission(const std::string& id) {
  SubmissionResult submission;
  submission.id = id;
  submission.inputs = std::string(secret) + "-hash";
  submission.stages = {stage_of(4, "shadows", "scene2", {"blocked"}),
                       stage_of(5, "reflections", "scene3", {"reflect", "mirror_bounce", "go_on"}),
                       stage_of(6, "refraction", "scene4", {"through_sphere", "schlick", "glass_bounces"})};
  return submission;
}

void set(TaskResult& task, Verdict verdict, const std::string& reason) {
  task.verdict = verdict;
  task.points.got = verdict == Verdict::right ? task.points.most : 0;
  task.reason = reason;
  task.tests_passed = verdict == Verdict::wrong ? 4 : 0;
  task.hidden_passed = 0;
}

void set(ImageResult& image, Verdict verdict, const std::string& reason) {
  image.verdict = verdict;
  image.points.got = 0;
  image.reason = reason;
  if (verdict == Verdict::wrong) {
    image.outside = 48213;
    return;
  }
  image.image.clear();
  image.heat.clear();
}

void set_all(StageResult& stage, Verdict verdict, const std::string& reason) {
  for (TaskResult& task : stage.tasks) set(task, verdict, reason);
  for (ImageResult& image : stage.images) set(image, verdict, image.hidden ? std::string(secret) : reason);
}

/// The sums that the parts make.
SubmissionResult summed(SubmissionResult submission) {
  for (StageResult& stage : submission.stages) {
    for (const TaskResult& task : stage.tasks) stage.points += task.points;
    for (const ImageResult& image : stage.images) stage.points += image.points;
    (stage.bonus ? submission.bonus : submission.points) += stage.points;
  }
  return submission;
}

SubmissionResult with_mistakes(const std::string& id) {
  SubmissionResult submission = right_submission(id);
  StageResult& reflections = submission.stages[1];
  TaskResult& reflect = reflections.tasks[0];
  set(reflect, Verdict::wrong, "2 of 6 tests failed.");
  reflect.failed = {{"5.1 reflect: twice is where we began",
                     "reflect(reflect(d, n), n) == d\n  asked     d = (0.6, -0.8, 0), n = (0, 1, 0)\n"
                     "  expected  (0.6, -0.8, 0)\n  got       (0.6, 2.4, 0)"},
                    {"5.1 reflect: the length stays", "|reflect(d, n)| == 1\n  expected  1\n  got       1.16619"}};
  reflect.hidden_failed = {hidden_test()};
  reflect.hint = "Only the part of d along n changes its sign.\nHow often do you subtract it?";
  reflect.mistake = "plus for minus";
  set(reflections.tasks[1], Verdict::wrong, "1 of 5 tests failed.");
  reflections.tasks[1].points = {0.5, 1};
  set(reflections.images[0], Verdict::wrong, "48213 pixels of 307200 are outside their range, 307 may be.");
  reflections.images[0].difference =
      "pixel 211,305, ray 2: 5.1 reflect({\"d\": [0.6, -0.8, 0], \"n\": [0, 1, 0]})\n"
      "  reference  [0.6, 0.8, 0]\n  yours      [0.6, 0, 0]";
  set(reflections.images[1], Verdict::wrong, std::string(secret));
  reflections.images[1].points = {0.5, 2};
  reflections.compiler =
      "05_reflections.cpp:31:9: warning: unused variable 'k' [-Wunused-variable]\n   31 |  double k = 2 * dot(d, n);\n      "
      "|         ^";
  set_all(submission.stages[2], Verdict::not_written, "It is not written yet.");
  submission.notes = {std::string(secret) + ": 6_refraction.cpp was not taken: no stage has this name"};
  return summed(submission);
}

SubmissionResult that_breaks(const std::string& id) {
  SubmissionResult submission = right_submission(id);
  set_all(submission.stages[0], Verdict::does_not_compile, "04_shadows.cpp does not compile.");
  submission.stages[0].compiler =
      "04_shadows.cpp: In function 'bool blocked(...)':\n04_shadows.cpp:12:7: error: 'foo' was not declared in this scope\n"
      "   12 |   if (foo < 0) return true;\n      |       ^~~\n04_shadows.cpp:14:1: warning: no return statement";
  StageResult& reflections = submission.stages[1];
  set(reflections.tasks[0], Verdict::crashed, "It ended with a segmentation fault.");
  reflections.tasks[0].call = R"({"d": [0.6, -0.8, 0], "n": [0, 1, 0]})";
  set(reflections.tasks[1], Verdict::too_slow, "A call took longer than 2 s.");
  set(reflections.tasks[2], Verdict::out_of_memory, "It asked for more than 4 GiB.");
  for (ImageResult& image : reflections.images)
    set(image, Verdict::crashed, image.hidden ? std::string(secret) : "It crashed.");
  set_all(submission.stages[2], Verdict::refused, "06_refraction.cpp is a link.");
  return summed(submission);
}

/// Puts hostile text into every text of plain data, but the labels, by which reports put a class together.
struct Spoil {
  template <class T>
  void operator()(const Field& field, T& value) const {
    if (field.name == std::string_view("label")) return;
    if constexpr (std::is_same_v<T, std::string>) {
      value = std::string(hostile) + value;
    } else if constexpr (HasFields<T>) {
      for_each_field(value, *this);
    }
  }
  template <class T>
  void operator()(const Field& field, std::vector<T>& list) const {
    for (T& element : list) (*this)(field, element);
  }
};

SubmissionResult with_hostile_text(const std::string& id) {
  SubmissionResult submission = with_mistakes(id);
  for_each_field(submission, Spoil{});
  submission.id = "../" + id + "\"'<b>";
  return submission;
}

SubmissionResult where_raylab_failed(const std::string& id) {
  SubmissionResult submission = right_submission(id);
  set(submission.stages[0].tasks[0], Verdict::wrong, "1 of 6 tests failed.");
  set_all(submission.stages[1], Verdict::infrastructure, "The disk was full.");
  return summed(submission);
}

SubmissionResult with_nothing_written(const std::string& id) {
  SubmissionResult submission = right_submission(id);
  for (StageResult& stage : submission.stages) {
    stage.file.clear();
    set_all(stage, Verdict::not_written, "The submission has no such file.");
  }
  return summed(submission);
}

}  // namespace

ClassResults sample_class() {
  ClassResults results;
  results.raylab = "0.1.0";
  results.seed = std::string(secret) + "-seed";
  results.guarantees = {{"no network", true, "a network namespace of its own"},
                        {"files cannot be read", false, "Landlock is missing in this kernel: <b>old</b>"},
                        {"memory is limited", true, "a control group"}};
  results.submissions = {
      summed(right_submission("0a1b2c3d4e")), with_mistakes("1b2c3d4e5f"),       that_breaks("2c3d4e5f60"),
      with_hostile_text("3d4e5f6071"),        where_raylab_failed("4e5f607182"), with_nothing_written("5f60718293")};
  return results;
}

std::vector<RosterEntry> sample_roster() {
  const ClassResults results = sample_class();
  const auto id = [&](std::size_t k) { return results.submissions[k].id; };
  return {{id(all_right), "Ada Lovelace"},
          {id(mistakes), "Zo\xc3\xab O'Hara, \"Zee\""},
          {id(breaks), "\xd8\xa3\xd8\xad\xd9\x85\xd8\xaf"},
          {id(hostile_text), std::string(hostile)},
          {id(raylab_failed), " =1+1"}};
}

std::vector<std::pair<std::string, double>> sample_seconds() {
  const ClassResults results = sample_class();
  return {{results.submissions[all_right].id, 12.4},
          {results.submissions[breaks].id, 61.25},
          {results.submissions[mistakes].id, 8.0}};
}

}  // namespace raylab::test
