#pragma once

#include "core/math/fields.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace raylab {

// What grading finds out: plain data, the one source of every report. docs/grading.md describes results.json, its JSON.
// All text in it is UTF-8 without control characters but line breaks, whatever a submission printed.

/// What became of a task or of an image. Only `right` and, for an image, a `wrong` with few pixels outside earn points;
/// `infrastructure` says that raylab failed and not the student: it costs no mark, and asks for a new run.
enum class Verdict {
  right,
  wrong,
  not_written,
  does_not_compile,
  crashed,
  too_slow,
  out_of_memory,
  refused,  ///< its file is not taken (a link, too large), or its process does not keep to the protocol
  infrastructure
};
RAYLAB_NAMES(Verdict, RAYLAB_NAME(right) RAYLAB_NAME(wrong) RAYLAB_NAME(not_written) RAYLAB_NAME(does_not_compile)
                          RAYLAB_NAME(crashed) RAYLAB_NAME(too_slow) RAYLAB_NAME(out_of_memory) RAYLAB_NAME(refused)
                              RAYLAB_NAME(infrastructure))

/// For people: "not written".
std::string in_words(Verdict verdict);

/// Points out of the most that there are.
struct Points {
  double got = 0;
  double most = 0;

  Points& operator+=(const Points& other) {
    got += other.got;
    most += other.most;
    return *this;
  }
};
RAYLAB_FIELDS(Points, RAYLAB_FIELD(got) RAYLAB_FIELD(most))

/// A test case that a task failed.
struct FailedTest {
  std::string name;  ///< "5.1 turns a ray back that meets the surface head on"
  std::string text;  ///< what was asked, what was expected, what came: some lines
};
RAYLAB_FIELDS(FailedTest, RAYLAB_FIELD(name) RAYLAB_FIELD(text))

/// A student sees all of it but what is called hidden; so reason, call and hint tell nothing of the course's own tests.
struct TaskResult {
  std::string label;  ///< "5.1"
  std::string name;   ///< "reflect"
  Verdict verdict = Verdict::infrastructure;
  Points points;
  std::string reason;              ///< one sentence; empty if right
  std::string call;                ///< the arguments of the call it died in, JSON, where there is one
  int tests_passed = 0;            ///< of the published tests
  std::vector<FailedTest> failed;  ///< of the published tests
  int hidden_passed = 0;           ///< of the course's own tests
  std::vector<FailedTest> hidden_failed;
  std::string hint;     ///< as far as the course allows; some lines
  std::string mistake;  ///< the known mistake that answers alike, if there is one: for the instructor
};
RAYLAB_FIELDS(TaskResult,
              RAYLAB_FIELD(label) RAYLAB_FIELD(name) RAYLAB_FIELD(verdict) RAYLAB_FIELD(points) RAYLAB_FIELD(reason)
                  RAYLAB_FIELD(call) RAYLAB_FIELD(tests_passed) RAYLAB_FIELD(failed) RAYLAB_FIELD(hidden_passed)
                      RAYLAB_FIELD(hidden_failed) RAYLAB_FIELD(hint) RAYLAB_FIELD(mistake))

/// An image of a stage, by the student's functions in this stage and the solution's in the others.
struct ImageResult {
  std::string scene;    ///< "scene3"
  bool hidden = false;  ///< from a camera drawn at grading time: earns points, and is not shown to the student
  Verdict verdict = Verdict::infrastructure;
  Points points;  ///< of a published image: 0 of 0
  std::string reason;
  int width = 0, height = 0;
  std::size_t outside = 0;  ///< pixels outside their range
  std::size_t allowed = 0;  ///< how many may be
  std::string image;        ///< PNG files, relative to the submission's folder; empty where there is none
  std::string reference;
  std::string heat;
  std::string difference;  ///< the first call that the student's functions answer differently, at the worst pixel; lines
};
RAYLAB_FIELDS(ImageResult,
              RAYLAB_FIELD(scene) RAYLAB_FIELD(hidden) RAYLAB_FIELD(verdict) RAYLAB_FIELD(points) RAYLAB_FIELD(reason)
                  RAYLAB_FIELD(width) RAYLAB_FIELD(height) RAYLAB_FIELD(outside) RAYLAB_FIELD(allowed) RAYLAB_FIELD(image)
                      RAYLAB_FIELD(reference) RAYLAB_FIELD(heat) RAYLAB_FIELD(difference))

struct StageResult {
  int number = 0;
  std::string name;  ///< "reflections"
  bool bonus = false;
  std::string file;      ///< "05_reflections.cpp"; empty if the submission has none
  std::string compiler;  ///< what the compiler said of it
  Points points;
  std::vector<TaskResult> tasks;
  std::vector<ImageResult> images;
};
RAYLAB_FIELDS(StageResult, RAYLAB_FIELD(number) RAYLAB_FIELD(name) RAYLAB_FIELD(bonus) RAYLAB_FIELD(file)
                               RAYLAB_FIELD(compiler) RAYLAB_FIELD(points) RAYLAB_FIELD(tasks) RAYLAB_FIELD(images))

/// Everything about one submission. Who handed it in stands in the roster alone.
struct SubmissionResult {
  std::string id;      ///< opaque: "7f3a91c02d"
  std::string inputs;  ///< a hash of all that decides this result: files, grading.toml, seed, raylab's version
  Points points;       ///< of the stages that are no bonus
  Points bonus;
  std::vector<std::string> notes;  ///< what the instructor should know: files that were not taken, and why
  std::vector<StageResult> stages;
};
RAYLAB_FIELDS(SubmissionResult, RAYLAB_FIELD(id) RAYLAB_FIELD(inputs) RAYLAB_FIELD(points) RAYLAB_FIELD(bonus)
                                    RAYLAB_FIELD(notes) RAYLAB_FIELD(stages))

/// What kept the submissions' code from doing harm on the machine that graded.
struct Guarantee {
  std::string name;  ///< "no network"
  bool holds = false;
  std::string by;  ///< what gives it, or why it is missing
};
RAYLAB_FIELDS(Guarantee, RAYLAB_FIELD(name) RAYLAB_FIELD(holds) RAYLAB_FIELD(by))

/// A whole class: results.json.
struct ClassResults {
  int format = 1;  ///< of this file
  std::string raylab;
  std::string seed;
  bool unsafe = false;  ///< graded although no guarantee held
  std::vector<Guarantee> guarantees;
  std::vector<SubmissionResult> submissions;  ///< by id
};
RAYLAB_FIELDS(ClassResults, RAYLAB_FIELD(format) RAYLAB_FIELD(raylab) RAYLAB_FIELD(seed) RAYLAB_FIELD(unsafe)
                                RAYLAB_FIELD(guarantees) RAYLAB_FIELD(submissions))

/// Who handed in what: roster.csv, which stays with the instructor.
struct RosterEntry {
  std::string id;
  std::string name;  ///< the submission's folder, as it was given: any text
};

/// results.json and back. Throws InputError if it is something else.
std::string results_json(const ClassResults& results);
ClassResults parse_results(std::string_view json);

}  // namespace raylab
