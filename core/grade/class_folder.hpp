#pragma once

#include "core/results/results.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace raylab {

/// A submission as it lies on disk.
struct Submitted {
  std::string name;  ///< its folder's, which the roster keeps
  std::filesystem::path folder;
  std::string id;  ///< opaque: from name and seed
};

/// The submissions that these folders are or hold, by name: a folder that has a stage's file is one, and so is each folder
/// in one that has none. Throws std::runtime_error if there is none, or a folder cannot be read.
std::vector<Submitted> find_submissions(const std::vector<std::string>& folders, const std::string& seed);

/// The K-th of N parts, 0 <= K < N: every N-th submission.
std::vector<Submitted> shard(const std::vector<Submitted>& all, std::size_t k, std::size_t n);

/// What holds for all submissions of a folder: run.json.
struct ClassRun {
  std::string raylab;  ///< its version
  bool unsafe = false;
  std::vector<Guarantee> guarantees;
};
RAYLAB_FIELDS(ClassRun, RAYLAB_FIELD(raylab) RAYLAB_FIELD(unsafe) RAYLAB_FIELD(guarantees))

/// The folder that grading writes to. It is readable for its owner alone.
class ClassFolder {
 public:
  /// Makes it. Throws std::runtime_error if it is another class's, graded with another seed, and if it cannot be written.
  ClassFolder(std::filesystem::path folder, const std::string& seed);

  /// The seed that a folder was graded with; nothing if it is none, or not there yet.
  static std::optional<std::string> seed_of(const std::filesystem::path& folder);

  const std::filesystem::path& path() const { return folder_; }
  const std::string& seed() const { return seed_; }
  std::filesystem::path submission(const std::string& id) const { return folder_ / "submissions" / id; }

  /// What is known of a submission; nothing if it has not been graded, or from other inputs than these.
  std::optional<SubmissionResult> finished(const std::string& id, const std::string& inputs) const;

  /// Writes a result, whole or not at all, and beside it the processor time that it took.
  void finish(const SubmissionResult& result, double seconds) const;

  /// All finished ones, by id; and the processor seconds of each.
  std::vector<SubmissionResult> results() const;
  std::vector<std::pair<std::string, double>> seconds() const;

  /// Adds submissions to the roster, which holds whose is whose.
  void enroll(const std::vector<RosterEntry>& entries) const;
  std::vector<RosterEntry> roster() const;

  /// What was written with write_run(). Throws std::runtime_error if nothing was.
  ClassRun run() const;
  void write_run(const ClassRun& run) const;

  /// Takes over what another folder, graded with the same seed, has finished. Throws std::runtime_error if that was graded
  /// otherwise: with another seed, version of raylab or sandbox.
  void take_over(const ClassFolder& other) const;

 private:
  std::filesystem::path folder_;
  std::string seed_;
};

}  // namespace raylab
