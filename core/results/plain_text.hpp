#pragma once

#include "core/calls/plain_json.hpp"

#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace raylab {

/// Any bytes as text that every report may hold, and that looks like what it is: UTF-8, with line breaks and tabs. Other
/// control characters, bytes that are no UTF-8 and characters that reorder the text around them or end a line unseen are
/// written as in \x1b and \u202e. The end of a line is \n, whatever it was.
std::string plain_text(std::string_view text);

/// The same on one line: line breaks and tabs are written as \x0a and \x09.
std::string plain_line(std::string_view text);

/// Plain data whose every text is plain_text().
template <class T>
T with_plain_text(T value);

// ---- How -----------------------------------------------------------------------------------------------------------

template <class T>
struct PlainText {
  static void apply(T&) {}
};
template <>
struct PlainText<std::string> {
  static void apply(std::string& text) { text = plain_text(text); }
};
template <class T>
struct PlainText<std::vector<T>> {
  static void apply(std::vector<T>& list) {
    for (T& element : list) PlainText<T>::apply(element);
  }
};
template <HasFields T>
struct PlainText<T> {
  static void apply(T& object) {
    for_each_field(object, []<class Part>(const Field&, Part& part) { PlainText<Part>::apply(part); });
  }
};

template <class T>
T with_plain_text(T value) {
  PlainText<T>::apply(value);
  return value;
}

}  // namespace raylab
