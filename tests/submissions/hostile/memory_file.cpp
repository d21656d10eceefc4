// right: would keep memory where no limit counts it
#include <sys/ipc.h>
#include <sys/shm.h>
#include <cstdlib>
static void attack() {
  if (shmget(IPC_PRIVATE, 1 << 20, IPC_CREAT | 0600) >= 0) std::abort();
}
