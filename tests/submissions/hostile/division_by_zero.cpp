// crashed: divides a whole number by zero
static void attack() {
  volatile int seven = 7, zero = 0;
  volatile int result = seven / zero;
  (void)result;
}
