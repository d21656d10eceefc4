// too_slow: never comes back, and will not be told to
#include <csignal>
static void attack() {
  for (int signal = 1; signal < 32; ++signal) std::signal(signal, SIG_IGN);
  sigset_t all;
  sigfillset(&all);
  sigprocmask(SIG_BLOCK, &all, nullptr);
  for (volatile int k = 0;; k = k + 1) {
  }
}
