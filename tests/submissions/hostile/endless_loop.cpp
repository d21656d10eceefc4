// too_slow: never comes back
static void attack() {
  for (volatile int k = 0;; k = k + 1) {
  }
}
