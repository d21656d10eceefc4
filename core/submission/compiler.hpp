#pragma once

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
  bool sanitize = false;  ///< with checks of addresses and of undefined behaviour
  bool color = false;     ///< in messages
};

/// Compiles the files of submissions, each a stage, to libraries that a worker loads. What has been compiled once is kept in
/// the user's cache folder ($XDG_CACHE_HOME/raylab or ~/.cache/raylab) and found again by its content; so is the precompiled
/// header with the contracts' types.
class StageCompiler {
 public:
  /// Throws std::runtime_error if there is no compiler or no place for the cache.
  explicit StageCompiler(const CompilerOptions& options);

  struct Built {
    std::filesystem::path library;
    std::string warnings;  ///< what the compiler said, if anything
  };
  /// Throws DoesNotCompile. Messages name the file as `source` does.
  Built build(int stage, const std::filesystem::path& source) const;

  /// What a worker's environment needs for the libraries: "NAME=VALUE".
  std::vector<std::string> worker_environment() const;

 private:
  std::filesystem::path prepared(const std::string& name, const std::vector<std::string>& arguments) const;

  CompilerOptions options_;
  std::vector<std::string> command_;  ///< the compiler and its flags
  std::filesystem::path folder_;      ///< in the cache: for this compiler, these flags and these contracts
};

}  // namespace raylab
