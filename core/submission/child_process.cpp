#include "core/submission/child_process.hpp"

#include "core/render/engine.hpp"
#include "core/submission/messages.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <thread>
#include <utility>

extern char** environ;

namespace raylab {
namespace {

[[noreturn]] void fail(const std::string& what, int error) { throw std::runtime_error(what + ": " + std::strerror(error)); }

/// A descriptor beyond those that a child is given, closed when another program starts.
int moved_up(int descriptor) {
  const int high = fcntl(descriptor, F_DUPFD_CLOEXEC, 10);
  const int error = errno;
  close(descriptor);
  if (high < 0) fail("no more files can be opened", error);
  return high;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> all;
  for (std::string& text : texts) all.push_back(text.data());
  all.push_back(nullptr);
  return all;
}

class FileActions {
 public:
  FileActions() { posix_spawn_file_actions_init(&actions_); }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;

  void duplicate(int from, int to) { posix_spawn_file_actions_adddup2(&actions_, from, to); }
  void open_nothing(int descriptor) { posix_spawn_file_actions_addopen(&actions_, descriptor, "/dev/null", O_RDWR, 0); }
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

/// This program's own, where these "NAME=VALUE" win.
std::vector<std::string> environment_with(const std::vector<std::string>& more) {
  std::vector<std::string> environment = more;
  for (char** entry = environ; *entry; ++entry) {
    const std::string own = *entry, name = own.substr(0, own.find('=') + 1);
    const auto is_replaced = [&](const std::string& other) { return other.starts_with(name); };
    if (std::none_of(more.begin(), more.end(), is_replaced)) environment.push_back(own);
  }
  return environment;
}

/// Starts a program in a group of its own: a Ctrl-C in the terminal reaches raylab alone, which ends the child in its way.
pid_t start(std::vector<std::string> arguments, const std::vector<std::string>& more_environment, const FileActions& files) {
  std::vector<std::string> environment = environment_with(more_environment);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &all);
  pid_t pid = -1;
  const int error = posix_spawnp(&pid, arguments.front().c_str(), files.get(), &attributes, pointers(arguments).data(),
                                 pointers(environment).data());
  posix_spawnattr_destroy(&attributes);
  if (error != 0) fail(arguments.front() + " cannot be started", error);
  return pid;
}

int wait_for_end(pid_t pid) {
  int status = 0;
  while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::string crash_in_words(int signal) {
  switch (signal) {
    case SIGSEGV:
    case SIGBUS:
      return "crashed: memory that it may not touch (a bad index or pointer), or a recursion without end";
    case SIGFPE:
      return "crashed: a whole number divided by zero";
    case SIGABRT:
      return "crashed: abort, as after a failed assertion or what a sanitizer has found";
    case SIGILL:
      return "crashed: an impossible instruction, as at the end of a function without a return";
    case SIGKILL:
      return "was killed, as for taking too much memory";
    case SIGXCPU:
      return "was killed, for taking too much processor time";
    case SIGXFSZ:
      return "was killed, for writing a file";
    default:
      return std::string("crashed: ") + strsignal(signal);
  }
}

std::string crash(int signal) { return crash_in_words(signal) + " (signal " + std::to_string(signal) + ")"; }

ChildEnded ending(int status, bool codes_are_signals) {
  constexpr int first_signal_code = 128;
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
  if (codes_are_signals && code > first_signal_code) return {crash(code - first_signal_code), code - first_signal_code};
  if (WIFEXITED(status)) return {"ended the program with exit code " + std::to_string(code), 0};
  return {crash(WTERMSIG(status)), WTERMSIG(status)};
}

}  // namespace

ChildProcess::ChildProcess(const ChildSetup& setup)
    : codes_are_signals_(setup.codes_are_signals), longest_line_(setup.longest_line) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) fail("no line to a child process", errno);
  channel_ = moved_up(ends[0]);
  const int childs = moved_up(ends[1]);
  FileActions files;
  files.open_nothing(STDIN_FILENO);
  if (setup.silent) files.open_nothing(STDERR_FILENO);
  files.duplicate(STDERR_FILENO, STDOUT_FILENO);
  files.duplicate(childs, worker_channel);
  try {
    pid_ = start(setup.arguments, setup.environment, files);
  } catch (...) {
    close(channel_);
    close(childs);
    throw;
  }
  close(childs);
}

ChildProcess::~ChildProcess() {
  if (channel_ >= 0) close(channel_);
  if (pid_ < 0) return;
  kill(-pid_, SIGKILL);
  wait_for_end(pid_);
}

void ChildProcess::fail_ended() {
  // It has closed the line, so it is ending; what it does instead is its last chance.
  const auto deadline = Clock::now() + std::chrono::seconds(2);
  int status = 0;
  while (waitpid(pid_, &status, WNOHANG) == 0) {
    if (Clock::now() > deadline) {
      kill(-pid_, SIGKILL);
      status = wait_for_end(pid_);
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  kill(-pid_, SIGKILL);
  pid_ = -1;
  throw ending(status, codes_are_signals_);
}

/// Until the line can be read or written.
void ChildProcess::wait_for(short events, Clock::time_point deadline, const std::atomic<bool>* cancel) {
  for (;;) {
    if (cancel && *cancel) throw Cancelled{};
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) throw ChildSilent("gave no answer in time, as in a loop without end");
    pollfd line{channel_, events, 0};
    if (poll(&line, 1, static_cast<int>(std::min<long>(left, 20))) > 0) return;
  }
}

void ChildProcess::send(std::string_view line, Clock::time_point deadline, const std::atomic<bool>* cancel) {
  const std::string message = std::string(line) + '\n';
  for (std::string_view rest = message; !rest.empty();) {
    wait_for(POLLOUT, deadline, cancel);
    const ssize_t sent = ::send(channel_, rest.data(), rest.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (sent >= 0)
      rest.remove_prefix(static_cast<std::size_t>(sent));
    else if (errno != EAGAIN && errno != EINTR)
      fail_ended();
  }
}

std::string ChildProcess::receive(Clock::time_point deadline, const std::atomic<bool>* cancel) {
  std::size_t searched = 0;
  for (;;) {
    if (const std::size_t end = received_.find('\n', searched); end != std::string::npos) {
      std::string line = received_.substr(0, end);
      received_.erase(0, end + 1);
      return line;
    }
    searched = received_.size();
    if (searched > longest_line_) throw ChildFloods("gave an answer without end");
    wait_for(POLLIN, deadline, cancel);
    std::array<char, 65536> buffer;
    const ssize_t got = recv(channel_, buffer.data(), buffer.size(), MSG_DONTWAIT);
    if (got > 0)
      received_.append(buffer.data(), static_cast<std::size_t>(got));
    else if (got == 0 || (errno != EAGAIN && errno != EINTR))
      fail_ended();
  }
}

Finished run_program(const std::vector<std::string>& arguments, const RunLimits& limits) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) fail("no pipe to a child process", errno);
  const int output = moved_up(ends[0]), childs = moved_up(ends[1]);
  FileActions files;
  files.open_nothing(STDIN_FILENO);
  files.duplicate(childs, STDOUT_FILENO);
  files.duplicate(childs, STDERR_FILENO);
  pid_t pid = -1;
  try {
    pid = start(arguments, {}, files);
  } catch (...) {
    close(output);
    close(childs);
    throw;
  }
  close(childs);
  Finished finished{false, {}};
  const auto deadline = Clock::now() + limits.time;
  std::array<char, 65536> buffer;
  bool late = false;
  for (ssize_t got = 1; got != 0 && !late;) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    pollfd line{output, POLLIN, 0};
    late = left <= 0;
    if (late || poll(&line, 1, static_cast<int>(std::min<long>(left, 1000))) <= 0) continue;
    got = read(output, buffer.data(), buffer.size());
    if (got > 0)
      finished.output.append(buffer.data(), std::min(static_cast<std::size_t>(got), limits.output - finished.output.size()));
    if (got < 0 && errno != EINTR) break;
  }
  close(output);
  if (late) finished.output += "\nit took more than " + std::to_string(limits.time.count()) + " seconds and was ended\n";
  if (late) kill(-pid, SIGKILL);
  const int status = wait_for_end(pid);
  kill(-pid, SIGKILL);
  finished.good = !late && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  return finished;
}

std::string find_program(const std::string& name) {
  if (name.find('/') != std::string::npos) return name;
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (const std::string file = folder + '/' + name; access(file.c_str(), X_OK) == 0) return file;
  return {};
}

}  // namespace raylab
