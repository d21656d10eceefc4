#include "core/explain/explain_image.hpp"

#include "core/explain/difference_json.hpp"
#include "core/explain/explanation.hpp"
#include "core/render/render.hpp"
#include "core/render/stages_engine.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace raylab {
namespace {

constexpr double noticeable = 1. / 255;

/// How far two colors are apart; what is no number is as far as can be.
double apart(const Color& a, const Color& b) {
  const Color d = a - b;
  const double most = std::max({std::abs(d.r), std::abs(d.g), std::abs(d.b)});
  return std::isfinite(d.r + d.g + d.b) ? most : 1;
}

/// The pixels to ask about: those that differ noticeably or, if none does, at all. Where there is no other image: any.
std::vector<std::size_t> chosen_pixels(const std::vector<double>& differences, bool compared, std::size_t most) {
  std::vector<std::size_t> pixels;
  if (!compared) {
    constexpr double golden = 0.6180339887498949;  // its multiples spread evenly, over rows and columns alike
    for (std::size_t k = 0; k < most; ++k) {
      const double part = static_cast<double>(k) * golden;
      pixels.push_back(static_cast<std::size_t>((part - std::floor(part)) * static_cast<double>(differences.size())));
    }
    return pixels;
  }
  const bool any = std::any_of(differences.begin(), differences.end(), [](double d) { return d > noticeable; });
  for (std::size_t k = 0; k < differences.size(); ++k)
    if (differences[k] > (any ? noticeable : 0)) pixels.push_back(k);
  std::stable_sort(pixels.begin(), pixels.end(),
                   [&](std::size_t a, std::size_t b) { return differences[a] > differences[b]; });
  if (pixels.size() <= most) return pixels;
  // Half of them the worst, half spread over the others, so that a small difference of its own kind is seen too.
  std::vector<std::size_t> some(pixels.begin(), pixels.begin() + static_cast<std::ptrdiff_t>(most / 2));
  const std::size_t rest = pixels.size() - some.size(), wanted = most - some.size();
  for (std::size_t k = 0; k < wanted; ++k) some.push_back(pixels[most / 2 + k * rest / wanted]);
  return some;
}

}  // namespace

ImageDifferences find_differences(const Scene& scene, const Settings& settings, const StageTable& table, const Engine& other,
                                  const AskTask& ask, unsigned threads, std::size_t most) {
  ImageDifferences found;
  const Image right = render_image(*make_stages(scene, settings, table), settings.size, threads);
  found.pixels = right.pixels.size();
  std::vector<double> differences(found.pixels, 0);
  try {
    const Image image = render_image(other, settings.size, threads);
    for (std::size_t k = 0; k < found.pixels; ++k) differences[k] = apart(right.pixels[k], image.pixels[k]);
  } catch (const std::runtime_error& error) {
    found.error = error.what();
  }
  found.differing = static_cast<std::size_t>(
      std::count_if(differences.begin(), differences.end(), [](double d) { return d > noticeable; }));

  std::map<std::string_view, DifferenceGroup> groups;
  for (const std::size_t k : chosen_pixels(differences, found.error.empty(), most)) {
    const int column = static_cast<int>(k % static_cast<std::size_t>(settings.size.width));
    const int row = static_cast<int>(k / static_cast<std::size_t>(settings.size.width));
    ++found.asked;
    const auto difference = first_difference(record_pixel(scene, settings, table, column, row), ask);
    if (!difference) {
      ++found.alike;
      continue;
    }
    DifferenceGroup& group = groups[difference->call.task->label];
    if (group.pixels.empty()) group.difference = *difference;
    group.pixels.push_back(std::to_string(column) + "," + std::to_string(row));
  }
  for (auto& [label, group] : groups) found.groups.push_back(std::move(group));
  std::stable_sort(found.groups.begin(), found.groups.end(),
                   [](const auto& a, const auto& b) { return a.pixels.size() > b.pixels.size(); });
  return found;
}

std::string differences_text(const std::string& scene, const Settings& settings, const ImageDifferences& found,
                             const std::string& with) {
  std::ostringstream out;
  const std::string size = std::to_string(settings.size.width) + "x" + std::to_string(settings.size.height);
  out << scene << " up to " << stage_title(settings.stage) << ", " << size << ", " << with << ":\n";
  if (!found.error.empty())
    out << "there is no image: " << found.error << '\n';
  else if (found.asked == 0)
    return out.str() + "all pixels are as the solution has them, to the last bit\n";
  else if (found.differing == 0)
    out << "all pixels are as the solution has them, to a step of 255\n";
  else
    out << found.differing << " of " << found.pixels << " pixels differ from the solution's by more than a step of 255\n";
  out << "asked about " << found.asked << " of them";
  if (found.alike > 0) out << "; in " << found.alike << " every call is answered as the solution does, but for rounding";
  out << '\n';
  for (const DifferenceGroup& group : found.groups) {
    const std::size_t count = group.pixels.size();
    out << '\n'
        << count << (count == 1 ? " pixel where" : " pixels where")
        << " this call is the first to be answered differently, at " << group.pixels.front() << " for example:\n\n"
        << difference_text(group.difference, with) << "  pixel     raylab explain " << scene << " --stage " << settings.stage
        << " --size " << size << " --pixel " << group.pixels.front() << ' ' << with << '\n';
  }
  return out.str();
}

std::string differences_json(const ImageDifferences& found) {
  nlohmann::ordered_json json{
      {"pixels", found.pixels}, {"differing", found.differing}, {"asked", found.asked}, {"alike", found.alike}};
  if (!found.error.empty()) json["error"] = found.error;
  json["groups"] = nlohmann::ordered_json::array();
  for (const DifferenceGroup& group : found.groups)
    json["groups"].push_back({{"first_difference", difference_json(group.difference)}, {"pixels", group.pixels}});
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace raylab
