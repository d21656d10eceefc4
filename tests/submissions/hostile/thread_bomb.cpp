// crashed: starts threads without end
#include <unistd.h>
#include <thread>
static void attack() {
  for (;;) std::thread([] { sleep(1000); }).detach();
}
