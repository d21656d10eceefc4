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

/// How a child ended: "crashed: ...", "ended by itself with exit code 0".
struct ChildEnded : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// It said nothing in time, or far too much.
struct ChildSilent : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A program in a process group of its own, with a line to it in both directions on descriptor `worker_channel`. What it
/// prints goes to this program's standard error. It ends, with all that it started and that stayed in its group, when this
/// object does.
class ChildProcess {
 public:
  /// `arguments`: the program's path, then its arguments. environment: "NAME=VALUE", in addition to this program's own, or
  /// in its place. Throws std::runtime_error if it cannot be started.
  explicit ChildProcess(const std::vector<std::string>& arguments, const std::vector<std::string>& environment = {});
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Sends `line` and an end of line. Throws ChildEnded, ChildSilent, and Cancelled once `cancel` is set.
  void send(std::string_view line, Clock::time_point deadline, const std::atomic<bool>* cancel = nullptr);

  /// The next line that it sends, without the end. Throws the same.
  std::string receive(Clock::time_point deadline, const std::atomic<bool>* cancel = nullptr);

 private:
  [[noreturn]] void fail_ended();
  void wait_for(short events, Clock::time_point deadline, const std::atomic<bool>* cancel);

  pid_t pid_ = -1;
  int channel_ = -1;
  std::string received_;
};

/// Runs a program to its end; whether its exit code was 0, and what it printed on both streams.
struct Finished {
  bool good;
  std::string output;
};
Finished run_program(const std::vector<std::string>& arguments);

}  // namespace raylab
