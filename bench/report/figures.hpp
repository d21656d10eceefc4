#pragma once

#include "bench/report/unit.hpp"

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace raylab::bench {

/// One figure of a report, and where it stands.
struct Figure {
  std::string section;  ///< "images", "kernels", "growth", "edges"
  std::string
      subject;  ///< what was measured on: "scene3", "2.2 sphere_hit, far tiny spheres", "spheres = 1000", "45 degrees"
  std::string variant;  ///< what was measured: "avx512 fast f32 none"
  std::string what;     ///< "speed", "arithmetic rmse", "ulps max"
  std::string unit;     ///< "Mpixel/s", "ns", "s", "bytes", "ulp", "", ...
  double value = 0;
  /// Of a time, the quartiles: it drifts, as memory does. Nothing of a figure that is the same in each run.
  std::optional<double> low = {}, high = {};
  bool noisy = false;
  bool more_is_better = false;
};

/// All figures of a report, in its order.
std::vector<Figure> figures_of(const Json& report);

/// Writes them as CSV, RFC 4180, with a line of names.
void write_csv(std::ostream& out, const std::vector<Figure>& figures);

}  // namespace raylab::bench
