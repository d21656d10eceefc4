// right: writes files wherever it may
#include <cstdio>
#include <cstdlib>
#include <string>
static void attack() {
  for (const char* folder : {"/tmp/", "/var/tmp/", "/dev/shm/", "/", "", "/home/", "/run/"}) {
    const std::string name = std::string(folder) + "raylab-hostile-file";
    if (std::FILE* file = std::fopen(name.c_str(), "w")) {
      const std::string block(1 << 20, 'x');
      for (int k = 0; k < 1000; ++k) std::fwrite(block.data(), 1, block.size(), file);
      std::fclose(file);
      std::abort();
    }
  }
}
