#pragma once

#include "core/scene/diagnostic.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace raylab {

/// Why a text should not be given to the TOML parser, and where.
struct TextFlaw {
  Place place;
  std::string text;
};

/// Looks for what toml++ 3.3 does not survive or reports badly: text that is not UTF-8; letters beyond ASCII where its own
/// tables of characters have holes, which is everywhere but in comments and well-formed strings; keys of so many parts
/// (a.a.a.a. ...) that the depth of their tables would exhaust the stack. None of it is in a good scene.
std::optional<TextFlaw> find_flaw(std::string_view text);

}  // namespace raylab
