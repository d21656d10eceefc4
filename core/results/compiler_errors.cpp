#include "core/results/compiler_errors.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

namespace raylab {
namespace {

/// Takes ":NUMBER" off the end of `text`.
std::optional<int> take_number(std::string_view& text) {
  const std::size_t colon = text.rfind(':');
  if (colon == text.npos) return {};
  int number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + colon + 1, end, number);
  if (error != std::errc() || stop != end || number < 1) return {};
  text = text.substr(0, colon);
  return number;
}

bool is_path_to(std::string_view path, std::string_view file) {
  return path == file || (path.ends_with(file) && path[path.size() - file.size() - 1] == '/');
}

std::optional<CompilerError> error_in(std::string_view line, std::string_view file) {
  for (const std::string_view mark : {": error: ", ": fatal error: "}) {
    const std::size_t at = line.find(mark);
    if (at == line.npos) continue;
    std::string_view place = line.substr(0, at);
    const std::optional<int> column = take_number(place), row = take_number(place);
    if (column && row && is_path_to(place, file))
      return CompilerError{*row, *column, std::string(line.substr(at + mark.size()))};
  }
  return {};
}

}  // namespace

std::vector<CompilerError> compiler_errors(std::string_view messages, std::string_view file) {
  std::vector<CompilerError> errors;
  while (!file.empty() && !messages.empty()) {
    const std::size_t end = std::min(messages.find('\n'), messages.size());
    if (auto error = error_in(messages.substr(0, end), file)) errors.push_back(std::move(*error));
    messages.remove_prefix(std::min(end + 1, messages.size()));
  }
  return errors;
}

}  // namespace raylab
