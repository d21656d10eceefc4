// all does_not_compile: includes what waits for somebody to type
#include "/dev/stdin"
static void attack() {}
