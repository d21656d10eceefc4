// right: looks for anything that is no system library
#include <dirent.h>
#include <cstdlib>
#include <cstring>
static void attack() {
  for (const char* name :
       {"/home", "/root", "/work", "/etc", "/var", "/opt", "/srv", "/usr/share", "/usr/bin", "/usr/include"}) {
    DIR* const folder = opendir(name);
    if (!folder) continue;
    while (const dirent* entry = readdir(folder))
      if (std::strcmp(entry->d_name, ".") != 0 && std::strcmp(entry->d_name, "..") != 0) std::abort();
    closedir(folder);
  }
}
