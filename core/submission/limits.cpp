#include "core/submission/limits.hpp"

#include <dlfcn.h>
#include <sys/resource.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <csignal>

namespace raylab {

namespace {

/// Is its library loaded, with this program or before it?
bool under_address_sanitizer() { return dlsym(RTLD_DEFAULT, "__asan_init") != nullptr; }

}  // namespace

void limit_this_process() {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  if (!under_address_sanitizer()) {
    constexpr rlim_t most = rlim_t{4} << 30U;
    const rlimit memory{most, most};
    setrlimit(RLIMIT_AS, &memory);
  }
  const rlimit no_dumps{0, 0};
  setrlimit(RLIMIT_CORE, &no_dumps);
}

}  // namespace raylab
