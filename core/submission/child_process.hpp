#pragma once

#include <sys/types.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace raylab {

using Clock = std::chrono::steady_clock;

/// How a child ended: "crashed: ...", "ended the program with exit code 0".
struct ChildEnded : std::runtime_error {
  ChildEnded(const std::string& what, int by) : std::runtime_error(what), signal(by) {}
  int signal;  ///< that ended it, or 0
};
/// It said nothing in time.
struct ChildSilent : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// It said far too much.
struct ChildFloods : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// How a program is started.
struct ChildSetup {
  std::vector<std::string> arguments;         ///< the program's path, then its arguments
  std::vector<std::string> environment = {};  ///< "NAME=VALUE", in addition to this program's own, or in its place
  bool silent = false;             ///< is what it prints dropped? If not, it goes to this program's standard error
  bool codes_are_signals = false;  ///< does the exit code 128 + N mean signal N, as behind another program?
  std::size_t longest_line = std::size_t{64} << 20U;  ///< that it may send, in bytes
};

/// A program in a process group of its own, with a line to it in both directions on descriptor `worker_channel`. It ends,
/// with all that it started and that stayed in its group, when this object does.
class ChildProcess {
 public:
  /// Throws std::runtime_error if it cannot be started.
  explicit ChildProcess(const ChildSetup& setup);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Sends `line` and an end of line. Throws ChildEnded, ChildSilent, and Cancelled once `cancel` is set.
  void send(std::string_view line, Clock::time_point deadline, const std::atomic<bool>* cancel = nullptr);

  /// The next line that it sends, without the end. Throws the same, and ChildFloods.
  std::string receive(Clock::time_point deadline, const std::atomic<bool>* cancel = nullptr);

 private:
  [[noreturn]] void fail_ended();
  void wait_for(short events, Clock::time_point deadline, const std::atomic<bool>* cancel);

  pid_t pid_ = -1;
  int channel_ = -1;
  bool codes_are_signals_;
  std::size_t longest_line_;
  std::string received_;
};

/// Runs a program to its end; whether its exit code was 0, and what it printed on both streams. One that takes longer is
/// ended, with all that it started and that stayed in its group; what it prints beyond the limit is dropped.
struct Finished {
  bool good;
  std::string output;
};
struct RunLimits {
  std::chrono::seconds time{3600};
  std::size_t output = std::size_t{1} << 20U;  ///< bytes
};
Finished run_program(const std::vector<std::string>& arguments, const RunLimits& limits = {});

/// The path of a program that the user's PATH has, or that is a path; empty if there is none.
std::string find_program(const std::string& name);

}  // namespace raylab
