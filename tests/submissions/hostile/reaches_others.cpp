// right: would signal and limit other processes, and change files, by calls that few know
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <cerrno>
#include <csignal>
#include <cstdlib>
static void attack() {
  siginfo_t info{};
  info.si_code = SI_QUEUE;
  rlimit limit{};
  if (syscall(SYS_rt_sigqueueinfo, getppid(), 0, &info) == 0) std::abort();
  if (syscall(SYS_prlimit64, getppid(), RLIMIT_CPU, nullptr, &limit) == 0) std::abort();
  for (const long command : {long{F_SETOWN}, F_SETOWN | (1L << 32U)})  // the kernel looks at half of it
    if (syscall(SYS_fcntl, 3, command, getppid()) == 0) std::abort();
  if (truncate("/nowhere", 0) == 0 || errno != EPERM) std::abort();
  if (chmod("/nowhere", 0777) == 0 || errno != EPERM) std::abort();
}
