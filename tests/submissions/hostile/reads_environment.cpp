// right: looks for secrets in the environment
#include <cstdlib>
#include <cstring>
extern char** environ;
static void attack() {
  for (char** entry = environ; *entry; ++entry)
    if (std::strncmp(*entry, "PATH=", 5) != 0 && std::strncmp(*entry, "LANG=", 5) != 0 &&
        std::strncmp(*entry, "TMPDIR=", 7) != 0 && std::strncmp(*entry, "PWD=", 4) != 0)
      std::abort();
}
