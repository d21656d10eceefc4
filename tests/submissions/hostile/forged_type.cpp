// refused: answers with something else than a vector
#include <unistd.h>
static void attack() { (void)!write(3, "answer {\"t\":1}\n", 15); }
