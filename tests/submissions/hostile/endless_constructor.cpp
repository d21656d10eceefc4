// all too_slow: never lets its library be loaded
static const struct Forever {
  Forever() {
    for (volatile int k = 0;; k = k + 1) {
    }
  }
} forever;
static void attack() {}
