#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace raylab {

/// A place in a text file, counted from 1; columns count characters, not bytes. 0 for "the file as a whole".
struct Place {
  int line = 0;
  int column = 0;
};

/// One thing that is wrong, or surprising, in a scene file or in a table beside it.
struct Diagnostic {
  enum class Severity { error, warning };
  Severity severity = Severity::error;
  std::string file;
  int line = 0;  ///< 0 where the file as a whole is meant: it cannot be read, say
  int column = 0;
  std::string key;   ///< "sphere[0].radius"; empty where no key is meant
  std::string text;  ///< what is wanted, and what was found
};

/// "scene.toml:14:10: sphere[0].radius: must be greater than 0, got -1"; a warning has "warning: " before its key.
std::string to_string(const Diagnostic& diagnostic);

/// Gathers what is found in one file.
class Report {
 public:
  explicit Report(std::string file) : file_(std::move(file)) {}

  void error(Place place, std::string key, std::string text);
  void warning(Place place, std::string key, std::string text);
  const std::string& file() const { return file_; }

  bool has_error() const;

  /// All of it, in the order of the file.
  std::vector<Diagnostic> sorted() const;

 private:
  std::string file_;
  std::vector<Diagnostic> diagnostics_;
};

/// `text` fit for one line of a terminal: control characters, and bytes that are not UTF-8, as in \x1b.
std::string printable(std::string_view text);

/// The same, cut where it is very long.
std::string shortened(std::string_view text);

/// The same between single quotes.
std::string quoted(std::string_view text);

/// The shortest decimal that reads back as `number`.
std::string to_text(double number);

}  // namespace raylab
