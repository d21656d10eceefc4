#include "core/submission/sandbox.hpp"

#include "core/calls/plain_json.hpp"
#include "core/image/data_folder.hpp"
#include "core/submission/child_process.hpp"

#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace raylab {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t most_processes = 64;
constexpr std::int64_t most_open_files = 64;
constexpr int first_own_user = 61184;  // systemd's range for users that exist only while something runs
constexpr int own_users = 4000;

/// What every program needs to start, and what compilers need beside. Not all of /usr: raylab may be installed there, with
/// the solution in it.
const std::vector<fs::path> library_folders{"/usr/lib", "/usr/lib32", "/usr/lib64",    "/lib",
                                            "/lib32",   "/lib64",     "/usr/local/lib"};
const std::vector<fs::path> compiler_folders{"/bin", "/usr/bin", "/usr/include", "/usr/libexec/gcc", "/usr/local/include"};

std::vector<fs::path> system_folders(const SandboxJob& job) {
  std::vector<fs::path> folders = library_folders;
  if (job.compiles) folders.insert(folders.end(), compiler_folders.begin(), compiler_folders.end());
  std::erase_if(folders, [](const fs::path& folder) { return !fs::is_directory(folder); });
  return folders;
}

fs::path new_folder(const fs::path& inside) {
  std::string name = (inside / "raylab-XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::system_error(errno, std::generic_category(), inside.string());
  return name;
}

void let_others_read(const fs::path& path) {
  constexpr auto read = fs::perms::group_read | fs::perms::others_read | fs::perms::group_exec | fs::perms::others_exec;
  fs::permissions(path, read, fs::perm_options::add);
}

}  // namespace

Sandbox::Sandbox() : room_(new_folder(fs::temp_directory_path())) {
  umask(S_IWGRP | S_IWOTH);
  // Jobs may run as somebody else. Whoever does not know a name in it has no use of that.
  fs::permissions(room_, fs::perms::group_exec | fs::perms::others_exec, fs::perm_options::add);
  const fs::path confine = program_part("raylab-confine");
  if (!fs::exists(confine)) {
    missing_.emplace_back("raylab-confine", "it is made for Linux alone");
    return;
  }
  confine_ = inside(confine).string();
  const SandboxJob nothing{{"/usr/bin/true"}, {}, {}, true, {std::int64_t{1} << 30U, 10, 0}};
  if (geteuid() == 0) {
    uid_ = first_own_user + getpid() % own_users;
    if (!works(nothing, "a user of its own")) uid_ = 0;
  } else {
    missing_.emplace_back("a user of its own", "raylab does not run as root");
  }
  landlock_ = true;
  landlock_ = works(nothing, "Landlock");
  seccomp_ = true;
  seccomp_ = works(nothing, "system call filter");
  bubblewrap_ = find_program("bwrap");
  if (bubblewrap_.empty())
    missing_.emplace_back("namespaces", "there is no bwrap: install bubblewrap");
  else if (!works(nothing, "namespaces"))
    bubblewrap_.clear();
}

Sandbox::~Sandbox() {
  std::error_code ignored;
  fs::remove_all(room_, ignored);
}

bool Sandbox::works(const SandboxJob& job, const std::string& layer) {
  const Finished finished = run_program(command(job), {std::chrono::seconds(10), std::size_t{1} << 16U});
  if (finished.good) return true;
  missing_.emplace_back(layer, finished.output.substr(0, finished.output.find('\n')));
  return false;
}

fs::path Sandbox::inside(const fs::path& file) const {
  const fs::path copy = room_ / file.filename();
  if (fs::exists(copy)) return copy;
  fs::copy_file(file, copy);
  let_others_read(copy);
  return copy;
}

fs::path Sandbox::writable_folder() const {
  const fs::path folder = new_folder(room_);
  if (uid_ != 0 && chown(folder.c_str(), static_cast<uid_t>(uid_), static_cast<gid_t>(uid_)) != 0)
    throw std::system_error(errno, std::generic_category(), folder.string());
  return folder;
}

std::vector<std::string> Sandbox::command(const SandboxJob& job) const {
  if (confine_.empty()) return job.command;
  Confinement confinement = inner(job);
  std::vector<std::string> whole;
  if (bubblewrap_.empty()) {
    confinement.uid = uid_;
  } else {
    Confinement outer;
    outer.uid = uid_;
    whole = {confine_, to_json(outer)};
    const std::vector<std::string> namespaces = this->namespaces(job);
    whole.insert(whole.end(), namespaces.begin(), namespaces.end());
  }
  whole.insert(whole.end(), {confine_, to_json(confinement)});
  whole.insert(whole.end(), job.command.begin(), job.command.end());
  return whole;
}

/// What holds with namespaces or without.
Confinement Sandbox::inner(const SandboxJob& job) const {
  Confinement confinement;
  confinement.environment = {"PATH=/usr/bin:/bin", "LANG=C.UTF-8", "TMPDIR=" + job.writable.string()};
  confinement.limits = true;
  confinement.address_space = job.limits.address_space;
  confinement.processor_time = job.limits.processor_time;
  confinement.file_size = job.limits.file_size;
  confinement.open_files = most_open_files;
  // Without a user or a namespace of its own the processes of whoever runs raylab would count.
  if (uid_ != 0 || !bubblewrap_.empty()) confinement.processes = most_processes;
  confinement.files = landlock_;
  for (const fs::path& folder : system_folders(job)) confinement.readable.push_back(folder.string());
  for (const fs::path& path : job.readable) confinement.readable.push_back(path.string());
  confinement.readable.push_back(confine_);
  confinement.writable.emplace_back("/dev/null");
  if (!job.writable.empty()) confinement.writable.push_back(job.writable.string());
  confinement.calls = seccomp_;
  confinement.alone = !job.compiles;
  return confinement;
}

std::vector<std::string> Sandbox::namespaces(const SandboxJob& job) const {
  std::vector<std::string> arguments{bubblewrap_,  "--unshare-all", "--unshare-user", "--disable-userns",  "--uid",
                                     "1000",       "--gid",         "1000",           "--hostname",        "raylab",
                                     "--cap-drop", "ALL",           "--new-session",  "--die-with-parent", "--dev-bind",
                                     "/dev/null",  "/dev/null"};
  const auto add = [&](const char* what, const fs::path& from, const fs::path& to) {
    arguments.insert(arguments.end(), {what, from.string(), to.string()});
  };
  for (const fs::path& folder : system_folders(job)) {
    if (fs::is_symlink(folder))
      add("--symlink", fs::read_symlink(folder), folder);
    else
      add("--ro-bind", folder, folder);
  }
  // Tests and solution are compiled into the program itself.
  if (const fs::path self = running_program(); job.compiles && self.string().starts_with("/usr/bin/"))
    add("--ro-bind", "/dev/null", self);
  for (const fs::path& path : job.readable) add("--ro-bind", path, path);
  add("--ro-bind", confine_, confine_);
  if (!job.writable.empty()) add("--bind", job.writable, job.writable);
  arguments.insert(arguments.end(), {"--remount-ro", "/", "--chdir", "/", "--"});
  return arguments;
}

std::vector<Protection> Sandbox::protections() const {
  const bool namespaces = !bubblewrap_.empty();
  const auto by = [](const std::vector<std::pair<bool, std::string>>& layers) {
    std::string names;
    for (const auto& [holds, name] : layers)
      if (holds) names += (names.empty() ? "" : ", ") + name;
    return names.empty() ? "nothing" : names;
  };
  const bool own_user = uid_ != 0, limits = !confine_.empty();
  return {
      {"expected answers are out of reach", true, "they stay in raylab's process"},
      {"no other files", namespaces || landlock_, by({{namespaces, "namespaces"}, {landlock_, "Landlock"}})},
      {"no network", namespaces || seccomp_, by({{namespaces, "namespaces"}, {seccomp_, "system call filter"}})},
      {"no other processes", namespaces || seccomp_ || own_user,
       by({{namespaces, "namespaces"}, {seccomp_, "system call filter"}, {own_user, "a user of its own"}})},
      {"bounded memory, time, files", limits, by({{limits, "limits"}})},
      {"bounded number of processes", namespaces || seccomp_ || own_user,
       by({{namespaces || own_user, "limits"}, {seccomp_, "system call filter"}})},
      {"no new privileges", limits, by({{limits, "no_new_privs"}, {namespaces, "namespaces"}})},
  };
}

void adopt_orphans() {
#ifdef __linux__
  prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0);
#endif
}

namespace {

/// The processes whose parent this one is.
std::vector<pid_t> children() {
  std::vector<pid_t> all;
  std::error_code ignored;  // not Linux
  for (const auto& entry : fs::directory_iterator("/proc", ignored)) {
    std::ifstream file(entry.path() / "stat");
    std::string text;
    if (!std::getline(file, text)) continue;
    // "PID (name) state PPID ...", where the name is any text.
    std::istringstream rest(text.substr(text.rfind(')') + 1));
    char state = 0;
    pid_t parent = 0;
    if (rest >> state >> parent && parent == getpid()) all.push_back(static_cast<pid_t>(std::stol(text)));
  }
  return all;
}

}  // namespace

void end_children() {
  for (std::vector<pid_t> left = children(); !left.empty(); left = children()) {
    for (const pid_t child : left) kill(child, SIGKILL);
    while (waitpid(-1, nullptr, 0) > 0 || errno == EINTR) {
    }
  }
}

double processor_seconds() {
  double seconds = 0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage used{};
    getrusage(who, &used);
    for (const timeval& time : {used.ru_utime, used.ru_stime})
      seconds += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  }
  return seconds;
}

bool Sandbox::is_safe() const {
  const std::vector<Protection> all = protections();
  return std::all_of(all.begin(), all.end(), [](const Protection& protection) { return protection.holds; });
}

}  // namespace raylab
