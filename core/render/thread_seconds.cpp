#include "core/render/thread_seconds.hpp"

#include <chrono>
#include <ctime>

namespace raylab {

double thread_seconds() {
#ifdef CLOCK_THREAD_CPUTIME_ID
  if (timespec now; clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) == 0)
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
#endif
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace raylab
