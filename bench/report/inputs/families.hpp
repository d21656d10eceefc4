#pragma once

#include "bench/report/inputs/random.hpp"
#include "bench/report/task_inputs.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace raylab::bench {

/// Adds families to tasks.
class Families {
 public:
  explicit Families(std::size_t count) : count_(count) {}

  template <class Function, class Make>
  void ordinary(std::vector<Family<Function>>& task, std::string text, Make make) const {
    task.push_back({"ordinary", false, std::move(text), inputs<Function>(count_, make)});
  }
  template <class Function, class Make>
  void hard(std::vector<Family<Function>>& task, std::string name, std::string text, Make make) const {
    task.push_back({std::move(name), true, std::move(text), inputs<Function>(count_, make)});
  }
  /// Each input is a list of hundreds.
  template <class Function, class Make>
  void long_lists(std::vector<Family<Function>>& task, std::string name, std::string text, Make make) const {
    task.push_back({std::move(name), true, std::move(text), inputs<Function>(std::max<std::size_t>(8, count_ / 16), make)});
  }

 private:
  template <class Function, class Make>
  static std::vector<Arguments<Function>> inputs(std::size_t count, Make make) {
    Random random;
    std::vector<Arguments<Function>> all;
    for (std::size_t k = 0; k < count; ++k) all.push_back(make(random));
    return all;
  }

  std::size_t count_;
};

/// `length` values that `make` gives.
template <class Make>
auto list_of(std::size_t length, Make make) {
  std::vector<decltype(make())> list;
  for (std::size_t k = 0; k < length; ++k) list.push_back(make());
  return list;
}

/// The families of stages 1 and 2, of 3 and 4, and of 5 to 7.
void add_rays_and_shapes(TaskFamilies& to, const Families& add);
void add_light(TaskFamilies& to, const Families& add);
void add_bounces_and_samples(TaskFamilies& to, const Families& add);

}  // namespace raylab::bench
