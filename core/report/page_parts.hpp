#pragma once

#include <nlohmann/json.hpp>

#include <array>
#include <string>
#include <string_view>

namespace raylab {

/// Any text as text of an HTML element.
std::string html_escaped(std::string_view text);

/// JSON for a <script> element, which `</script>` would end and `<!--` would change: no `<` stays as it is. Bytes that are
/// not UTF-8 become replacement characters.
std::string script_json(const nlohmann::ordered_json& json);

/// What stands before the mark and what stands after it. Throws std::logic_error if the text of the page lacks it.
std::array<std::string_view, 2> split(std::string_view text, std::string_view mark);

}  // namespace raylab
