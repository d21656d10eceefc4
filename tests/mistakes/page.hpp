#pragma once

// The text of docs/mistakes.md.
#include "tests/mistakes/evidence.hpp"
#include "tests/runner.hpp"

#include <map>
#include <span>
#include <string>

namespace raylab::test {

/// A mistake, what its own task's tests say of it, and the image that shows it.
struct FoundMistake {
  Mistake mistake;
  Totals tests;
  Evidence image;
};

/// The whole page.
std::string mistakes_page(std::span<const FoundMistake> found);

/// "5.3 one bounce too many": its name among all mistakes.
std::string full_name(const Mistake& mistake);

/// The scenes that a page names, by the mistakes' full names.
std::map<std::string, std::string> scenes_in(const std::string& page);

/// The page but for the scores, which another processor may round in another way.
std::string without_scores(const std::string& page);

}  // namespace raylab::test
