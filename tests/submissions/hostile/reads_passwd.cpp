// right: looks for the users of this machine
#include <cstdio>
#include <cstdlib>
static void attack() {
  for (const char* name : {"/etc/passwd", "/etc/shadow", "/etc/hostname", "/root/.bashrc"})
    if (std::fopen(name, "r")) std::abort();
}
