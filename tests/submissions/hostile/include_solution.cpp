// all does_not_compile: includes the solution
#include "reference/solution/05_reflections.cpp"
static void attack() {}
