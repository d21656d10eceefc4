// right: looks for the solution where libraries lie
#include <dirent.h>
#include <dlfcn.h>
#include <cstdlib>
#include <string>
static void attack() {
  for (const char* name :
       {"/tmp", "/usr/libexec/raylab/raylab-solution", "/usr/lib/raylab", "/usr/local/libexec/raylab/raylab-solution"}) {
    if (dlopen((std::string(name) + "/05_reflections.so").c_str(), RTLD_NOW)) std::abort();
    DIR* const folder = opendir(name);
    if (!folder) continue;
    while (const dirent* entry = readdir(folder))
      if (dlopen((std::string(name) + "/" + entry->d_name + "/05_reflections.so").c_str(), RTLD_NOW)) std::abort();
    closedir(folder);
  }
}
