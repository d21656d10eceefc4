#pragma once

#include <nlohmann/json.hpp>

#include <atomic>
#include <functional>
#include <map>
#include <string>

namespace raylab::bench {

using Json = nlohmann::ordered_json;

/// How thorough a run is to be.
struct Plan {
  bool quick = false;    ///< less of everything: under a minute in place of a quarter of an hour
  unsigned threads = 1;  ///< for what is not timed: the oracle, converged images
};

/// A piece of the work of a few seconds, done as a whole or not at all. An interrupted run keeps the pieces that are done.
struct Unit {
  std::string name;    ///< "kernels/2.2", "images/scene3/round 2": of this piece alone
  double seconds = 1;  ///< about how long it takes, for the progress bar
  std::function<Json(const std::atomic<bool>& cancel)> measure;  ///< throws Cancelled soon after `cancel` is set
};

/// What the units have measured, by their names.
using Results = std::map<std::string, Json>;

}  // namespace raylab::bench
