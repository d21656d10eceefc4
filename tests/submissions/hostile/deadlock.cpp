// too_slow: waits for itself
#include <mutex>
static void attack() {
  static std::mutex mutex;
  mutex.lock();
  mutex.lock();
}
