// Becomes another program with less than it has: raylab-confine CONFINEMENT PROGRAM [ARGUMENT]...
// CONFINEMENT is a raylab::Confinement as JSON. The program gets descriptors 0 to 3 and no others. Exit code 125, and a line
// on standard error, if something cannot be taken away: the program does not start then.

#include "core/calls/plain_json.hpp"
#include "core/submission/confinement.hpp"

#include <fcntl.h>
#include <grp.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <linux/sockios.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>
#ifdef RAYLAB_WITH_SECCOMP
#include <seccomp.h>
#endif

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace raylab;

namespace {

constexpr int first_other_descriptor = 4;  // after the standard streams and the line to raylab
constexpr int exit_code = 125;

void require(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error(what + ": " + std::strerror(errno));
}

void close_other_descriptors() {
  require(syscall(SYS_close_range, first_other_descriptor, ~0U, 0U) == 0, "descriptors cannot be closed");
}

/// For good: the saved ids change too.
void become(int id) {
  if (id == 0) return;
  const auto user = static_cast<uid_t>(id);
  const auto group = static_cast<gid_t>(id);
  require(setgroups(0, nullptr) == 0 && setresgid(group, group, group) == 0 && setresuid(user, user, user) == 0,
          "it cannot become user " + std::to_string(id));
}

void set_limits(const Confinement& wanted) {
  const auto set = [](auto resource, std::int64_t most) {
    const auto value = static_cast<rlim_t>(most);
    const rlimit limit{value, value};
    require(setrlimit(resource, &limit) == 0, "a limit cannot be set");
  };
  set(RLIMIT_CORE, 0);
  set(RLIMIT_AS, wanted.address_space);
  set(RLIMIT_CPU, wanted.processor_time);
  if (wanted.processes > 0) set(RLIMIT_NPROC, wanted.processes);
  set(RLIMIT_FSIZE, wanted.file_size);
  set(RLIMIT_NOFILE, wanted.open_files);
}

// ---- Landlock: the kernel's, without a wrapper in the C library -----------------------------------------------------

constexpr std::uint64_t read_rights =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t truncate_right = std::uint64_t{1} << 14U;  // LANDLOCK_ACCESS_FS_TRUNCATE, which old headers lack
constexpr std::uint64_t file_rights =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_WRITE_FILE | truncate_right;
constexpr std::uint64_t first_rights = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1U) - 1U;

/// Those that this kernel knows, of all that change files.
std::uint64_t known_rights() {
  constexpr long first_with_truncate = 3;
  const long version = syscall(SYS_landlock_create_ruleset, nullptr, 0U, LANDLOCK_CREATE_RULESET_VERSION);
  return version >= first_with_truncate ? first_rights | truncate_right : first_rights;
}

void allow(int rules, const std::string& path, std::uint64_t rights) {
  const int place = open(path.c_str(), O_PATH | O_CLOEXEC);
  require(place >= 0, path + " cannot be opened");
  struct stat about {};
  require(fstat(place, &about) == 0, path + " cannot be asked about");
  landlock_path_beneath_attr rule{};
  rule.allowed_access = S_ISDIR(about.st_mode) ? rights : rights & file_rights;
  rule.parent_fd = place;
  require(syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &rule, 0U) == 0, path + " cannot be allowed");
  close(place);
}

void hide_files(const Confinement& wanted) {
  const std::uint64_t all_rights = known_rights();
  landlock_ruleset_attr attributes{};
  attributes.handled_access_fs = all_rights;
  const auto rules = static_cast<int>(syscall(SYS_landlock_create_ruleset, &attributes, sizeof attributes, 0U));
  require(rules >= 0, "this kernel has no Landlock");
  for (const std::string& path : wanted.readable) allow(rules, path, read_rights);
  for (const std::string& path : wanted.writable) allow(rules, path, all_rights);
  require(syscall(SYS_landlock_restrict_self, rules, 0U) == 0, "Landlock does not start");
  close(rules);
}

// ---- seccomp --------------------------------------------------------------------------------------------------------

#ifdef RAYLAB_WITH_SECCOMP
/// What no task and no compiler needs.
const std::vector<const char*> forbidden_calls{"socket",
                                               "socketpair",
                                               "connect",
                                               "bind",
                                               "listen",
                                               "accept",
                                               "accept4",
                                               "ptrace",
                                               "process_vm_readv",
                                               "process_vm_writev",
                                               "process_madvise",
                                               "pidfd_open",
                                               "pidfd_getfd",
                                               "pidfd_send_signal",
                                               "kcmp",
                                               "unshare",
                                               "setns",
                                               "mount",
                                               "umount2",
                                               "pivot_root",
                                               "chroot",
                                               "move_mount",
                                               "open_tree",
                                               "fsopen",
                                               "fsconfig",
                                               "fsmount",
                                               "fspick",
                                               "mount_setattr",
                                               "shmget",
                                               "shmat",
                                               "shmctl",
                                               "msgget",
                                               "msgsnd",
                                               "msgrcv",
                                               "msgctl",
                                               "semget",
                                               "semop",
                                               "semctl",
                                               "mq_open",
                                               "mq_unlink",
                                               "add_key",
                                               "request_key",
                                               "keyctl",
                                               "bpf",
                                               "perf_event_open",
                                               "userfaultfd",
                                               "io_uring_setup",
                                               "io_uring_enter",
                                               "io_uring_register",
                                               "personality",
                                               "syslog",
                                               "inotify_init",
                                               "inotify_init1",
                                               "fanotify_init",
                                               "name_to_handle_at",
                                               "open_by_handle_at",
                                               "init_module",
                                               "finit_module",
                                               "delete_module",
                                               "kexec_load",
                                               "reboot",
                                               "swapon",
                                               "swapoff",
                                               "acct",
                                               "quotactl",
                                               "setrlimit",
                                               "sched_setaffinity",
                                               "setpriority",
                                               "ioprio_set",
                                               "sched_setscheduler",
                                               "sched_setparam",
                                               "sched_setattr",
                                               "migrate_pages",
                                               "move_pages",
                                               "process_mrelease"};

/// What only somebody does who wants to be more than one process, or to outlive this one. (To become another program stays
/// allowed, as it must until this one has become the worker: that one is as confined.)
const std::vector<const char*> forbidden_alone{"fork", "vfork", "setsid", "setpgid", "tkill"};

/// What changes files that it need not open, which Landlock cannot forbid. (A linker does some of it to its own.)
const std::vector<const char*> forbidden_changes{
    "truncate",  "chmod",     "fchmodat", "fchmodat2", "chown",       "lchown",       "fchownat", "utime", "utimes",
    "futimesat", "utimensat", "setxattr", "lsetxattr", "removexattr", "lremovexattr", "link",     "linkat"};

class Filter {
 public:
  Filter() : context_(seccomp_init(SCMP_ACT_ALLOW)) {
    if (!context_) throw std::runtime_error("no system call filter can be made");
  }
  ~Filter() { seccomp_release(context_); }
  Filter(const Filter&) = delete;
  Filter& operator=(const Filter&) = delete;

  /// The call fails with this error, if its arguments are like that. A call that this machine does not have is none.
  void forbid(const char* name, const std::vector<scmp_arg_cmp>& arguments = {}, int error = EPERM) {
    const int number = seccomp_syscall_resolve_name(name);
    if (number == __NR_SCMP_ERROR) return;
    errno = -seccomp_rule_add_array(context_, SCMP_ACT_ERRNO(static_cast<std::uint32_t>(error)), number,
                                    static_cast<unsigned>(arguments.size()), arguments.data());
    require(errno == 0, std::string("the system call ") + name + " cannot be forbidden");
  }

  void start() {
    errno = -seccomp_load(context_);
    require(errno == 0, "this kernel has no system call filters");
  }

 private:
  scmp_filter_ctx context_;
};

void forbid_calls(const Confinement& wanted) {
  Filter filter;
  for (const char* const name : forbidden_calls) filter.forbid(name);
  filter.forbid("prlimit64", {{0, SCMP_CMP_NE, 0, 0}});
  if (wanted.alone) {
    const auto own = static_cast<scmp_datum_t>(getpid());
    for (const char* const name : forbidden_alone) filter.forbid(name);
    // Threads too: no task needs one, and sixty that spin would slow all other submissions.
    for (const char* const name : {"clone", "clone3"}) filter.forbid(name, {}, EAGAIN);
    for (const char* const name : {"kill", "tgkill", "rt_sigqueueinfo", "rt_tgsigqueueinfo"})
      filter.forbid(name, {{0, SCMP_CMP_NE, own, 0}});
    for (const char* const name : forbidden_changes) filter.forbid(name);
    // Who is signaled when a descriptor becomes ready. The kernel looks at half of the argument, and so does this.
    constexpr scmp_datum_t half = 0xffffffff;
    for (const int command : {F_SETOWN, F_SETOWN_EX, F_SETSIG})
      filter.forbid("fcntl", {{1, SCMP_CMP_MASKED_EQ, half, static_cast<scmp_datum_t>(command)}});
    for (const int command : {FIOSETOWN, SIOCSPGRP})
      filter.forbid("ioctl", {{1, SCMP_CMP_MASKED_EQ, half, static_cast<scmp_datum_t>(command)}});
  }
  filter.start();
}
#else
void forbid_calls(const Confinement&) { throw std::runtime_error("raylab was built without libseccomp"); }
#endif

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> all;
  for (std::string& text : texts) all.push_back(text.data());
  all.push_back(nullptr);
  return all;
}

/// In an order in which each step still may do what it needs.
void confine(const Confinement& wanted) {
  close_other_descriptors();
  become(wanted.uid);
  require(prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0, "new privileges cannot be refused");
  require(prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0) == 0, "it cannot be bound to its parent");
  if (wanted.files) hide_files(wanted);
  if (wanted.limits) set_limits(wanted);
  if (wanted.calls) forbid_calls(wanted);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc < 3) throw std::invalid_argument("usage: raylab-confine CONFINEMENT PROGRAM [ARGUMENT]...");
    auto wanted = from_json<Confinement>(argv[1]);
    confine(wanted);
    execve(argv[2], argv + 2, pointers(wanted.environment).data());
    require(false, std::string(argv[2]) + " cannot be started");
  } catch (const std::exception& error) {
    std::cerr << "raylab-confine: " << error.what() << '\n';
  }
  return exit_code;
}
