// right: defines the C library's functions
#include <cstddef>
extern "C" __attribute__((visibility("default"))) int memcmp(const void*, const void*, std::size_t) { return 0; }
extern "C" __attribute__((visibility("default"))) double sqrt(double) { return 0; }
static void attack() {}
