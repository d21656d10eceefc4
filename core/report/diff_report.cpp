#include "core/report/diff_report.hpp"

#include "core/report/comparison_json.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace raylab {
namespace {

template <class... Values>
std::string format(const char* pattern, Values... values) {
  std::array<char, 512> text{};
  std::snprintf(text.data(), text.size(), pattern, values...);
  return text.data();
}

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string decibels(double psnr) { return std::isfinite(psnr) ? format("%.1f dB", psnr) : "infinite"; }

std::string outside_line(const Comparison& c) {
  return "  " + counted(c.outside, "pixel") + " of " + std::to_string(c.verdict.size()) + " outside their range, " +
         std::to_string(c.allowed) + " may be; " + std::to_string(c.densest) + " in the densest 5 x 5, " +
         std::to_string(c.densest_allowed) + " may be\n";
}

std::string error_lines(const Comparison& c) {
  std::string text = format("  error: max %.3g, mean %.3g, RMSE %.3g, PSNR %s", c.max_error, c.mean_error, c.rmse,
                            decibels(c.psnr).c_str());
  if (c.rmse > 0 && c.knows_decisions)
    text += format("; %.0f %% of the squared error at decisions, %.0f %% in smooth regions", 100 * c.share_at_decisions,
                   100 * (1 - c.share_at_decisions));
  return text + "\n";
}

std::string color(const Color& c) { return format("%9.6f %9.6f %9.6f", c.r, c.g, c.b); }

std::string worst_lines(const Comparison& c) {
  if (c.worst.empty()) return "";
  std::string text = "  the worst (column, row from the top left; the image's red, green, blue; what they may be):\n";
  for (const OutsidePixel& pixel : c.worst) {
    text += format("    %5d %5d  ", pixel.column, pixel.row) + color(pixel.image) + "   " + color(pixel.least);
    if (pixel.least != pixel.greatest) text += " .. " + color(pixel.greatest);
    text += "\n";
  }
  return text;
}

}  // namespace

std::string diff_text(const DiffTitle& title, const Comparison& c) {
  std::string text = std::string(c.same ? "same" : "differs") + ": " + title.image + " and " + title.reference + "\n";
  text += outside_line(c);
  if (c.non_finite > 0) text += "  " + counted(c.non_finite, "pixel") + " with components that are no finite numbers\n";
  if (c.at_decision > 0)
    text += "  " + counted(c.at_decision, "pixel") +
            " more differ where rounding decides (hit or miss, lit or not): not counted\n";
  if (c.clamped_each) text += "  compared with each dot product clamped by itself, an accepted variant that fits better\n";
  text += error_lines(c);
  for (const Finding& finding : c.findings) text += "  " + finding.text + "\n";
  return text + worst_lines(c);
}

std::string diff_json(const DiffTitle& title, const Comparison& c) {
  nlohmann::ordered_json json = {{"image", title.image}, {"reference", title.reference}};
  json.update(comparison_json(c));
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace raylab
