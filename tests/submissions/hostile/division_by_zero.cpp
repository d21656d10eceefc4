// crashed: divides a whole number by zero
static void attack() {
  volatile int zero = 0;
  volatile int result = 1 / zero;
  (void)result;
}
