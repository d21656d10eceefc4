#pragma once

#include "bench/report/unit.hpp"

#include <iosfwd>

namespace raylab::bench {

/// Writes an HTML page that shows a report, docs/bench.md has its format: one file that needs no other, nor a network.
/// Whatever the report lacks, the page calls not measured.
void write_page(std::ostream& out, const Json& report);

}  // namespace raylab::bench
