// crashed: calls itself without end
static int deeper(volatile int* at) {
  volatile int here[1000] = {*at};
  return deeper(here) + here[1];
}
static void attack() {
  volatile int start = 0;
  deeper(&start);
}
