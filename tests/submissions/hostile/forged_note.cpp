// all refused: says that it is loaded before it is, and then that a task stands in, in no JSON
#include <unistd.h>
static const auto said = write(3, "0 ready {}\n1 stands-in nonsense\n", 32);
static void attack() {}
