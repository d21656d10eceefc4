#include "bench/report/task_inputs.hpp"

#include "bench/report/inputs/families.hpp"

namespace raylab::bench {

TaskFamilies task_families(std::size_t count) {
  const Families add(count);
  TaskFamilies all;
  add_rays_and_shapes(all, add);
  add_light(all, add);
  add_bounces_and_samples(all, add);
  return all;
}

}  // namespace raylab::bench
