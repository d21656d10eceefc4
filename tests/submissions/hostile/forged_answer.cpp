// refused: answers before it has computed anything
#include <unistd.h>
static void attack() { (void)!write(3, "answer [0,1,0]\n", 15); }
