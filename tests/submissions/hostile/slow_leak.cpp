// out_of_memory: keeps 64 MiB of each call
#include <memory>
#include <vector>
static std::vector<std::unique_ptr<char[]>> kept;
// Not written to: touching 4 GiB can take longer than all calls together may.
static void attack() { kept.push_back(std::make_unique_for_overwrite<char[]>(std::size_t{64} << 20U)); }
