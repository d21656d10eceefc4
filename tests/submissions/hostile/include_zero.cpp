// all does_not_compile: includes a file without end
#include "/dev/zero"
static void attack() {}
