// crashed: writes where nothing is
static void attack() {
  int* volatile nowhere = nullptr;
  *nowhere = 1;
}
