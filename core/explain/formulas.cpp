#include "core/explain/formulas.hpp"

#include <map>

namespace raylab {

Formula formula_of(std::string_view task_label) {
  static const std::map<std::string_view, Formula> all{
      {"1.1",
       {"d = f + s ((x - 1/2 + dx) r + (y - 1/2 + dy) u), made unit; s = 2 tan(theta) / max(width, height)", "section 2"}},
      {"2.1", {"t = (q - o).n / d.n, if d.n is not 0 and t >= 0", "section 3.1, equation 1"}},
      {"2.2", {"|o + t d - c|^2 = R^2: the least root t >= 0", "section 3.2, equation 2"}},
      {"2.3", {"n = (p - c) / |p - c|", "section 3.2"}},
      {"2.4", {"the candidate of least t; of equal ones the first", "section 3.3"}},
      {"3.1", {"k_s = tanh(alpha / 400)", "section 4.1"}},
      {"3.2", {"(l.n + k_s max(0, h.n)^alpha) I C, black unless l.n > 0; h = unit(l + v)", "section 4, equation 3"}},
      {"3.3", {"task 3.2 with intensity I / (1 + r)^2, where r = |light - p|", "sections 1 and 4.1"}},
      {"3.4", {"task 3.2 with l = -unit(direction) and all of I", "sections 1 and 4"}},
      {"3.5", {"I C", "sections 1 and 4.1"}},
      {"3.6", {"the sum of all parts, not clamped", "section 4.1"}},
      {"4.1", {"blocked if something opaque is at t < distance", "section 4.2"}},
      {"5.1", {"r = d - 2 (d.n) n", "section 5, equation 4"}},
      {"5.2", {"from the hit's point, along the reflected direction, leaving what the hit leaves; weight k_s", "section 5"}},
      {"5.3", {"bounce <= max_bounces, and weight not 0", "section 5"}},
      {"6.1", {"sin(theta_1) = n sin(theta_2), at both surfaces of the sphere", "section 6.1, equation 5"}},
      {"6.2", {"R = R0 + (1 - R0) (1 - cos theta)^5, R0 = ((n - 1) / (n + 1))^2", "section 6.2, equation 6"}},
      {"6.3", {"weight R for the reflected ray, 1 - R for the refracted one", "sections 6.1 and 6.2, equation 7"}},
      {"7.1", {"the four places of the rotated grid", "section 2.1, figure 4"}},
      {"7.2", {"the mean of the samples, then clamped to 0..1", "sections 2.1 and 8"}},
  };
  const auto found = all.find(task_label);
  return found == all.end() ? Formula{} : found->second;
}

}  // namespace raylab
