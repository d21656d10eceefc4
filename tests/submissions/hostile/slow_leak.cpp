// out_of_memory: keeps 64 MiB of each call
#include <vector>
static std::vector<std::vector<char>> kept;
static void attack() { kept.emplace_back(std::size_t{64} << 20U, 1); }
