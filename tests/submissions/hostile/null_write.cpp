// crashed: writes where nothing is
static void attack() {
  volatile int* volatile nowhere = nullptr;
  *nowhere = 1;
}
