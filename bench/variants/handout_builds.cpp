#include "bench/variants/handout_renderer.hpp"

namespace raylab::bench {

using MakeHandout = std::unique_ptr<Engine>(const Scene&, const Settings&, const Variant&);
MakeHandout make_handout_renderer_o2, make_handout_renderer_fast_math;
#ifdef RAYLAB_VARIANT_WITH_FMA
MakeHandout make_handout_renderer_fma;
#endif

std::vector<HandoutBuild> handout_builds() {
  std::vector<HandoutBuild> builds{{"o2", make_handout_renderer_o2}, {"fast_math", make_handout_renderer_fast_math}};
#ifdef RAYLAB_VARIANT_WITH_FMA
  // Asked here, in code that every processor can run.
  if (__builtin_cpu_supports("fma")) builds.push_back({"fma", make_handout_renderer_fma});
#endif
  return builds;
}

}  // namespace raylab::bench
