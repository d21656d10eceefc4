#pragma once

#include "core/submission/child_process.hpp"
#include "core/submission/sandbox.hpp"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace raylab {

/// What the compiler says of a file that it does not take; what() is its output.
struct DoesNotCompile : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct CompilerOptions {
  bool sanitize = false;             ///< with checks of addresses and of undefined behaviour
  bool color = false;                ///< in messages
  const Sandbox* sandbox = nullptr;  ///< for strangers' code
};

/// Compiles the files of submissions, each a stage, to libraries that a worker loads. What has been compiled once is kept in
/// the user's cache folder ($XDG_CACHE_HOME/raylab or ~/.cache/raylab) and found again by its content; so is the precompiled
/// header with the contracts' types. Strangers' files are compiled in the sandbox, and what they become is kept in its room.
class StageCompiler {
 public:
  /// Throws std::runtime_error if there is no compiler or no place for the cache.
  explicit StageCompiler(const CompilerOptions& options);

  /// Makes what all files need, which otherwise the first one makes.
  void prepare() const;

  struct Built {
    std::filesystem::path library;
    std::string warnings;  ///< what the compiler said, if anything
  };
  /// Throws DoesNotCompile, and std::runtime_error if the file cannot be read. Messages name the file as `source` does.
  Built build(int stage, const std::filesystem::path& source) const;

  /// The same for a text that messages call `name`.
  Built build_text(int stage, const std::string& text, const std::string& name) const;

  /// What a worker's environment needs for the libraries: "NAME=VALUE".
  std::vector<std::string> worker_environment() const;

 private:
  std::filesystem::path header() const;
  std::filesystem::path exports(int stage) const;
  std::filesystem::path prepared(const std::string& name, const std::vector<std::string>& arguments) const;
  Finished compile(std::vector<std::string> arguments, const std::filesystem::path& text,
                   const std::filesystem::path& library) const;

  CompilerOptions options_;
  std::vector<std::string> command_;  ///< the compiler and its flags
  std::filesystem::path root_;        ///< of the contracts
  std::filesystem::path folder_;      ///< in the cache: for this compiler, these flags and these contracts
  std::filesystem::path made_;        ///< where libraries are kept
};

}  // namespace raylab
