#pragma once

#include "bench/report/unit.hpp"

namespace raylab::bench {

/// What a run's figures hang on: version, commit, compiler, build type and flags, processor, cores, memory, system and
/// instruction sets. What the system does not tell is null.
Json describe_machine();

}  // namespace raylab::bench
