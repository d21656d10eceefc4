#pragma once

#include "bench/report/unit.hpp"

namespace raylab::bench {

/// Which way to render to pick for which need, computed from the section "images" of the report: [{"need", "bound", "pick",
/// "sentence", "hard_sentence"}]. A pick is the fastest variant, at one sample a pixel, that keeps the bound on every scene
/// measured but the hard ones, or on these if there are no others; the hard sentence says on which of the hard ones it does
/// too. `pick` is null where none does.
Json choices_from(const Json& images);

}  // namespace raylab::bench
