// all does_not_compile: makes a library of gigabytes
volatile char full[3000000000] = {1};
static void attack() { full[1] = 2; }
