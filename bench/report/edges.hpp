#pragma once

#include "bench/report/unit.hpp"

#include <vector>

namespace raylab::bench {

/// The work on the section "edges" of the report: how far a pixel on a straight edge is from the part of it that is covered,
/// for each pattern of samples and each angle of the edge.
///
/// The edge is the horizon of an infinite plane, at stage 2: in a picture it is a straight line, of which the camera's tilt
/// and roll say exactly where it runs. So the covered part is known, and what is measured is what the renderer draws.
std::vector<Unit> edge_units(const Plan& plan);

/// That section, or null if it has not been measured.
Json edge_report(const Results& results);

}  // namespace raylab::bench
