// right: looks at other processes
#include <cstdio>
#include <cstdlib>
static void attack() {
  for (const char* name : {"/proc/self/environ", "/proc/1/cmdline", "/proc/self/maps", "/proc/meminfo", "/proc/self/mem"})
    if (std::fopen(name, "r")) std::abort();
}
