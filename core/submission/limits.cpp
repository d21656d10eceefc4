#include "core/submission/limits.hpp"

#include <sys/resource.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <csignal>
#include <cstdlib>

namespace raylab {

void limit_this_process() {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  if (!std::getenv("ASAN_OPTIONS")) {
    constexpr rlim_t most = rlim_t{4} << 30U;
    const rlimit memory{most, most};
    setrlimit(RLIMIT_AS, &memory);
  }
#endif
  const rlimit no_dumps{0, 0};
  setrlimit(RLIMIT_CORE, &no_dumps);
}

}  // namespace raylab
