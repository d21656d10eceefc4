// right: would become a shell
#include <unistd.h>
static void attack() { execl("/bin/sh", "sh", "-c", "sleep 1000", nullptr); }
