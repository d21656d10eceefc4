#pragma once

#include "core/submission/confinement.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace raylab {

/// What a program in a sandbox may use.
struct SandboxLimits {
  std::int64_t address_space;   ///< bytes
  std::int64_t processor_time;  ///< seconds
  std::int64_t file_size;       ///< bytes
};

/// A program that is to run in one.
struct SandboxJob {
  std::vector<std::string> command;             ///< the program's full path, and its arguments
  std::vector<std::filesystem::path> readable;  ///< beside the system's libraries
  std::filesystem::path writable;               ///< a folder; empty for none
  bool compiles = false;                        ///< may read the system's headers and compilers, and start other programs
  SandboxLimits limits;
};

/// Something that strangers' code cannot do here, or can.
struct Protection {
  std::string name;  ///< "no network"
  bool holds;
  std::string by;  ///< what gives it, or what is missing
};

/// Keeps strangers' code from the rest of the machine, in layers, of which it uses all that this machine permits: Linux
/// namespaces by bubblewrap, a user of its own (if raylab is root), Landlock, a system call filter, limits. docs/sandbox.md
/// says what each is for.
class Sandbox {
 public:
  /// Tries what this machine permits, by running programs: some tens of milliseconds. From then on this process lets
  /// everybody read the files that it makes, since jobs run as somebody else.
  Sandbox();
  ~Sandbox();
  Sandbox(const Sandbox&) = delete;
  Sandbox& operator=(const Sandbox&) = delete;

  /// The command line that runs it.
  std::vector<std::string> command(const SandboxJob& job) const;

  /// A folder of this sandbox's own, which goes with it. Jobs can reach what is in it, whoever they run as.
  const std::filesystem::path& room() const { return room_; }

  /// A copy of the file in the room, under its name, made once.
  std::filesystem::path inside(const std::filesystem::path& file) const;

  /// A new folder in the room that a job can write to.
  std::filesystem::path writable_folder() const;

  /// Does the exit code 128 + N of a command mean signal N?
  bool passes_signals_as_codes() const { return !bubblewrap_.empty(); }

  std::vector<Protection> protections() const;

  /// The layers that this machine does not permit, and why.
  const std::vector<std::pair<std::string, std::string>>& missing() const { return missing_; }

  /// Do files, network and other processes stay out of reach?
  bool is_safe() const;

 private:
  bool works(const SandboxJob& job, const std::string& layer);
  Confinement inner(const SandboxJob& job) const;
  std::vector<std::string> namespaces(const SandboxJob& job) const;

  std::filesystem::path room_;
  std::string confine_;     ///< the program raylab-confine, in the room
  std::string bubblewrap_;  ///< the program bwrap; empty if it does not work here
  int uid_ = 0;
  bool landlock_ = false;
  bool seccomp_ = false;
  std::vector<std::pair<std::string, std::string>> missing_;
};

/// From now on what a child leaves behind becomes this process's child.
void adopt_orphans();

/// Ends every child of this process, however it tries to stay, and waits for it.
void end_children();

/// The processor time of this process, and of all children that it has waited for.
double processor_seconds();

}  // namespace raylab
