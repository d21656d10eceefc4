#include "core/results/results.hpp"

#include "core/calls/plain_json.hpp"

#include <algorithm>

namespace raylab {

std::string in_words(Verdict verdict) {
  std::string words;
  for_each_name(Verdict{}, [&](const char* name, Verdict named) {
    if (named == verdict) words = name;
  });
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

std::string results_json(const ClassResults& results) { return to_json(results) + '\n'; }

ClassResults parse_results(std::string_view json) { return from_json<ClassResults>(json); }

}  // namespace raylab
