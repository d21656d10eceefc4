#pragma once

#include "core/results/results.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace raylab::test {

/// What no report may act on or repeat raw: colors, ends of CDATA and of scripts, a formula, a workflow command, Markdown, a
/// mention, a mark that reverses text, bytes that are no UTF-8.
inline constexpr std::string_view hostile =
    "=HYPERLINK(\"http://evil.example\")\x1b[31m ]]> </script><script>document.title='ran'</script><img src=x "
    "onerror=alert(1)>"
    "\r\n::error::owned\n\n# heading @everyone `code` | **bold** <!-- \xe2\x80\xae reversed, \xff\xfe &amp; 100%";

/// Stands in every text of the sample that a student must not see.
inline constexpr std::string_view secret = "COURSE-SECRET";

/// A class of six: all right, some mistakes, code that breaks in each way, hostile text in every field, raylab's own
/// failures, and nothing written. Three stages, 4 to 6; the last is a bonus.
ClassResults sample_class();

/// The sample's submissions by their places in it.
enum Sample : std::size_t { all_right, mistakes, breaks, hostile_text, raylab_failed, nothing_written };

std::vector<RosterEntry> sample_roster();

/// Processor seconds, by id.
std::vector<std::pair<std::string, double>> sample_seconds();

}  // namespace raylab::test
