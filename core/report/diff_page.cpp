#include "core/report/diff_page.hpp"

#include "core/image/base64.hpp"
#include "core/image/diff_pictures.hpp"
#include "core/image/image_file.hpp"
#include "core/report/comparison_json.hpp"
#include "core/report/diff_page_html.hpp"
#include "core/report/page_base_css.hpp"
#include "core/report/page_parts.hpp"
#include "core/report/page_tools_js.hpp"
#include "core/report/page_views_css.hpp"
#include "core/report/page_views_js.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace raylab {
namespace {

using Json = nlohmann::ordered_json;

/// Writes bytes as lines of base64, each of which can be decoded alone.
class Base64Lines {
 public:
  explicit Base64Lines(std::ostream& out) : out_(out) { bytes_.reserve(line_bytes); }

  void byte(unsigned value) {
    bytes_.push_back(static_cast<char>(value & 0xff));
    if (bytes_.size() == line_bytes) end_line();
  }

  /// Four bytes, the lowest first.
  void word(std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) byte(value >> shift);
  }

  void number(double value) { word(std::bit_cast<std::uint32_t>(static_cast<float>(value))); }

  void color(const Color& c) {
    number(c.r);
    number(c.g);
    number(c.b);
  }

  void end_line() {
    out_ << base64(bytes_) << '\n';
    bytes_.clear();
  }

 private:
  static constexpr std::size_t line_bytes = 3 * 16384;

  std::ostream& out_;
  std::string bytes_;
};

/// A color as it is shown, in three bytes.
Json json_bytes(const Color& c) { return Json::array({quantise(c.r), quantise(c.g), quantise(c.b)}); }

Json json_of(const std::vector<Color>& color_map) {
  Json colors = Json::array();
  for (const Color& c : color_map) colors.push_back(json_bytes(c));
  return colors;
}

Json json_of(const DiffPage& page) {
  const Reference& reference = page.reference;
  return {{"title", page.title},
          {"imageName", page.image_name},
          {"referenceName", page.reference_name},
          {"width", page.image.width},
          {"height", page.image.height},
          {"scene", reference.scene},
          {"stage", reference.stage},
          {"planes", reference.planes},
          {"spheres", reference.spheres},
          {"hasWord", reference.has_word()},
          {"colorMap", json_of(page.color_map)},
          {"nonFiniteColor", json_bytes(non_finite_color)},
          {"comparison", comparison_json(page.comparison)}};
}

/// A <script> element that is no script but holds data; `write` writes it.
template <class Write>
void write_block(std::ostream& out, std::string_view id, Write write) {
  out << "<script type=\"text/plain\" id=\"" << id << "\">\n";
  Base64Lines lines(out);
  write(lines);
  lines.end_line();
  out << "</script>\n";
}

void write_image_block(std::ostream& out, std::string_view id, const Image& image) {
  write_block(out, id, [&](Base64Lines& lines) {
    for (const Color& c : image.pixels) lines.color(c);
  });
}

void write_numbers_block(std::ostream& out, std::string_view id, const std::vector<double>& numbers) {
  write_block(out, id, [&](Base64Lines& lines) {
    for (const double number : numbers) lines.number(number);
  });
}

/// Only the pixels whose range is more than the reference's value, which are few: a pixel's index, least and greatest.
void write_ranges_block(std::ostream& out, const Reference& reference) {
  write_block(out, "ranges-data", [&](Base64Lines& lines) {
    for (std::size_t k = 0; k < reference.value.pixels.size(); ++k) {
      const Color &least = reference.least.pixels[k], &greatest = reference.greatest.pixels[k];
      if (least == reference.value.pixels[k] && greatest == reference.value.pixels[k]) continue;
      lines.word(static_cast<std::uint32_t>(k));
      lines.color(least);
      lines.color(greatest);
    }
  });
}

void write_data(std::ostream& out, const DiffPage& page) {
  out << "<script type=\"application/json\" id=\"report\">" << script_json(json_of(page)) << "</script>\n";
  write_image_block(out, "image-data", page.image);
  write_image_block(out, "reference-data", page.reference.value);
  write_ranges_block(out, page.reference);
  write_numbers_block(out, "error-data", page.comparison.error);
  write_block(out, "verdict-data", [&](Base64Lines& lines) {
    for (const PixelVerdict verdict : page.comparison.verdict) lines.byte(static_cast<unsigned>(verdict));
  });
  if (!page.reference.has_word()) return;
  write_numbers_block(out, "margin-data", page.reference.margin);
  write_numbers_block(out, "sensitivity-data", page.reference.sensitivity);
  write_block(out, "object-data", [&](Base64Lines& lines) {
    for (const GeometryId object : page.reference.object) lines.word(static_cast<std::uint32_t>(object));
  });
}

}  // namespace

void write_diff_page(std::ostream& out, const DiffPage& page) {
  if (page.image.pixels.size() > largest_page)
    throw std::runtime_error("a page holds images of up to " + std::to_string(largest_page) + " pixels, this one has " +
                             std::to_string(page.image.pixels.size()));
  const auto [start, after_title] = split(diff_page_html, "{{title}}");
  const auto [head, after_style] = split(after_title, "{{style}}");
  const auto [markup, after_data] = split(after_style, "{{data}}");
  const auto [module, script] = split(after_data, "{{script}}");
  out << start << html_escaped(page.title) << head << page_base_css << page_views_css << markup;
  write_data(out, page);
  out << module << page_tools_js << page_views_js << script;
}

}  // namespace raylab
