// Comparing an image with a reference: the policy of docs/tolerance.md, what differences look like, and the pictures of it.

#include "core/image/diff.hpp"

#include "core/image/diff_patterns.hpp"
#include "core/image/diff_pictures.hpp"
#include "core/image/image_file.hpp"
#include "core/image/reference_file.hpp"
#include "core/report/diff_report.hpp"
#include "tests/sample_reference.hpp"
#include "tests/support.hpp"
#include "tests/temporary_folder.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <vector>

using namespace raylab;
using namespace raylab::test;

namespace {

Comparison compared(const Image& image, const Reference& reference) {
  return compare(image, NumberFormat::float64, reference);
}

std::vector<std::string> kinds(const Image& image, const Reference& reference) {
  std::vector<std::string> kinds;
  for (const Finding& finding : find_patterns(image, reference, compared(image, reference))) kinds.push_back(finding.kind);
  return kinds;
}

template <class Source>
Image mapped(const Image& image, Source source) {
  Image result(image.width, image.height);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) result.at(x, y) = source(x, y);
  return result;
}

using Kinds = std::vector<std::string>;

}  // namespace

TEST_CASE("diff: an image is the same as itself", "[diff]") {
  const Reference reference = reference_of(smooth_picture());
  const Comparison c = compared(reference.value, reference);
  CHECK(c.same);
  CHECK(c.score == 0);
  CHECK(c.outside == 0);
  CHECK(c.max_error == 0);
  CHECK(c.psnr == infinity);
  CHECK(find_patterns(reference.value, reference, c).empty());
}

TEST_CASE("diff: nothing that is not a number passes", "[diff]") {
  const Reference reference = reference_of(smooth_picture());
  for (const double bad : {std::nan(""), infinity, -infinity}) {
    Image one = reference.value;
    one.at(5, 5).g = bad;
    const Comparison c = compared(one, reference);
    CHECK_FALSE(c.same);
    CHECK(c.non_finite == 1);
    CHECK(c.score == infinity);
    CHECK(c.verdict[5 * width + 5] == PixelVerdict::outside);
    CHECK(std::isfinite(c.rmse));
    CHECK_FALSE(compared(Image(width, height, Color(bad)), reference).same);
  }
}

TEST_CASE("diff: a decision excuses a color, but not what is not a number", "[diff]") {
  Reference reference = reference_of(smooth_picture());
  std::fill(reference.margin.begin(), reference.margin.end(), calibrated.near_margin);
  const Comparison moved = compared(with_moved(reference.value, 300, 0.3), reference);
  CHECK(moved.same);
  CHECK(moved.at_decision == 300);
  CHECK(moved.share_at_decisions == within(1e-12, 1.0));
  Image bad = reference.value;
  bad.at(0, 0).r = std::nan("");
  CHECK_FALSE(compared(bad, reference).same);
}

TEST_CASE("diff: the tolerance grows with the pixel's sensitivity", "[diff]") {
  Reference reference = reference_of(smooth_picture());
  const double sensitivity = 1e-12;
  const double tau = calibrated.floor + calibrated.gain * sensitivity;
  const Image near = with_moved(reference.value, 100, 0.99 * tau);
  CHECK_FALSE(compared(near, reference).same);
  std::fill(reference.sensitivity.begin(), reference.sensitivity.end(), sensitivity);
  CHECK(compared(near, reference).same);
  CHECK_FALSE(compared(with_moved(reference.value, 100, 1.01 * tau), reference).same);
}

TEST_CASE("diff: the tolerance is half a step of either number format wider", "[diff]") {
  Reference reference = reference_of(smooth_picture());
  const Image moved = with_moved(reference.value, 100, 0.49 / 255);
  CHECK_FALSE(compare(moved, NumberFormat::float32, reference).same);
  CHECK(compare(moved, NumberFormat::uint8, reference).same);
  CHECK_FALSE(compare(with_moved(reference.value, 100, 0.52 / 255), NumberFormat::uint8, reference).same);
  reference.format = NumberFormat::uint8;
  CHECK(compare(moved, NumberFormat::float32, reference).same);
}

TEST_CASE("diff: all between the least and the greatest value is right", "[diff]") {
  Reference reference = reference_of(smooth_picture());
  for (Color& c : reference.least.pixels) c -= Color(0.1);
  for (Color& c : reference.greatest.pixels) c += Color(0.05);
  CHECK(compared(with_moved(reference.value, 300, -0.1), reference).same);
  CHECK(compared(with_moved(reference.value, 300, 0.05), reference).same);
  CHECK_FALSE(compared(with_moved(reference.value, 300, -0.101), reference).same);
  CHECK_FALSE(compared(with_moved(reference.value, 300, 0.051), reference).same);
}

TEST_CASE("diff: so many isolated pixels may be outside, and no more", "[diff]") {
  const Reference reference = reference_of(smooth_picture());
  const Comparison limit = compared(with_moved(reference.value, 19, 0.5), reference);
  CHECK(limit.same);
  CHECK(limit.outside == 19);
  CHECK(limit.allowed == 19);
  CHECK(limit.densest == 1);
  CHECK(limit.score == 1);
  CHECK_FALSE(compared(with_moved(reference.value, 20, 0.5), reference).same);
}

TEST_CASE("diff: so many pixels outside may lie close together, and no more", "[diff]") {
  const Reference reference = reference_of(smooth_picture());
  Image image = reference.value;
  const auto most = static_cast<int>(calibrated.densest);
  for (int k = 0; k < most; ++k) image.at(155 + k % 5, 115 + k / 5) += Color(0.2);  // in the last corner
  const Comparison limit = compared(image, reference);
  CHECK(limit.densest == calibrated.densest);
  CHECK(limit.same);
  image.at(159, 119) += Color(0.2);
  CHECK(compared(image, reference).densest == calibrated.densest + 1);
  CHECK_FALSE(compared(image, reference).same);
}

TEST_CASE("diff: in a tiny image no pixel may be outside", "[diff]") {
  const Reference reference = reference_of(Image(1, 1, Color(0.5)));
  CHECK(compared(reference.value, reference).same);
  CHECK_FALSE(compared(Image(1, 1, Color(0.6)), reference).same);
}

TEST_CASE("diff: with either way to clamp, the better counts, for the whole image", "[diff]") {
  Reference reference = reference_of(smooth_picture());
  const Image brighter = with_moved(reference.value, 200, 0.25);
  CHECK_FALSE(compared(brighter, reference).same);
  reference.each = PixelRanges{brighter, brighter, brighter};
  CHECK(compared(brighter, reference).same);
  CHECK(compared(brighter, reference).clamped_each);
  CHECK_FALSE(compared(reference.value, reference).clamped_each);
  CHECK_FALSE(compared(with_moved(reference.value, 100, 0.25), reference).same);  // half of each
}

TEST_CASE("diff: the errors are those of the definitions", "[diff]") {
  const Reference reference = reference_of(Image(10, 10, Color(0.5)));
  Image image = reference.value;
  image.at(3, 4) = Color(0.6, 0.5, 0.3);
  const Comparison c = compared(image, reference);
  CHECK(c.max_error == within(1e-15, 0.2));
  CHECK(c.mean_error == within(1e-15, 0.3 / 300));
  CHECK(c.rmse == within(1e-15, std::sqrt(0.05 / 300)));
  CHECK(c.psnr == within(1e-12, -10 * std::log10(0.05 / 300)));
}

TEST_CASE("diff: the worst ten come first the worst", "[diff]") {
  const Reference reference = reference_of(smooth_picture());
  Image image = reference.value;
  for (int k = 0; k < 30; ++k) image.at(5 * k, 50) += Color(0, 0.01 * (k % 15), 0);
  const Comparison c = compared(image, reference);
  REQUIRE(c.worst.size() == 10);
  CHECK(c.worst[0].column == 70);
  CHECK(c.worst[0].row == 50);
  CHECK(c.worst[0].distance == within(1e-5, 0.14));
  for (std::size_t k = 1; k < 10; ++k) CHECK(c.worst[k].distance <= c.worst[k - 1].distance);
}

TEST_CASE("diff: a mirrored picture is recognised", "[diff]") {
  const Reference reference = reference_of(smooth_picture());
  const Image& value = reference.value;
  CHECK(kinds(mapped(value, [&](int x, int y) { return value.at(width - 1 - x, y); }), reference).at(0) == "mirrored");
  CHECK(kinds(mapped(value, [&](int x, int y) { return value.at(x, height - 1 - y); }), reference).at(0) == "mirrored");
  CHECK(kinds(mapped(value, [&](int x, int y) { return value.at(width - 1 - x, height - 1 - y); }), reference).at(0) ==
        "mirrored");
  const Reference square = reference_of(smooth_picture(80, 80));
  CHECK(kinds(mapped(square.value, [&](int x, int y) { return square.value.at(y, x); }), square).at(0) == "mirrored");
}

TEST_CASE("diff: a shifted picture is recognised, and by how much", "[diff]") {
  const Reference reference = reference_of(smooth_picture());
  const auto text = [&](int dx, int dy) {
    const Image shifted = mapped(reference.value, [&](int x, int y) {
      return reference.value.at(std::clamp(x - dx, 0, width - 1), std::clamp(y - dy, 0, height - 1));
    });
    return find_patterns(shifted, reference, compared(shifted, reference)).at(0).text;
  };
  CHECK(text(1, 0) == "The image is the reference shifted by one pixel to the right.");
  CHECK(text(-1, 1) == "The image is the reference shifted by one pixel to the left and by one pixel down.");
  const Image half = mapped(reference.value, [&](int x, int y) {
    return (reference.value.at(x, y) + reference.value.at(x, std::min(y + 1, height - 1))) / 2.0;
  });
  CHECK(find_patterns(half, reference, compared(half, reference)).at(0).text ==
        "The image is the reference shifted by half a pixel up.");
}

TEST_CASE("diff: a brighter picture is recognised, and how much brighter", "[diff]") {
  const Reference reference = reference_of(smooth_picture());
  const Image brighter =
      mapped(reference.value, [&](int x, int y) { return glm::min(1.5 * reference.value.at(x, y), Color(1)); });
  const std::vector<Finding> findings = find_patterns(brighter, reference, compared(brighter, reference));
  REQUIRE(!findings.empty());
  CHECK(findings[0].text == "The image is the reference made brighter: times 1.5.");
  const Image darker = mapped(reference.value, [&](int x, int y) { return 0.25 * reference.value.at(x, y); });
  CHECK(find_patterns(darker, reference, compared(darker, reference)).at(0).text ==
        "The image is the reference made darker: times 0.25.");
}

TEST_CASE("diff: where the difference lies: everywhere, on one object, at edges", "[diff]") {
  const Reference reference = with_objects();
  Image noise = reference.value;
  Random random(1);
  for (Color& c : noise.pixels) c += Color(random.between(-0.1, 0.1), 0.01, 0);
  CHECK(kinds(noise, reference) == Kinds{"everywhere"});

  Image object = reference.value;
  for (std::size_t k = 0; k < object.pixels.size(); ++k)
    if (reference.object[k] == 2) object.pixels[k] += Color(random.between(-0.1, 0.1), 0.02, 0);
  CHECK(kinds(object, reference) == Kinds{"one-object"});
  CHECK_THAT(find_patterns(object, reference, compared(object, reference))[0].text, ContainsSubstring("sphere[1]"));

  Image edges = reference.value;
  for (int y = 1; y < height - 1; ++y)
    for (int x = 1; x < width - 1; ++x) {
      const auto here = static_cast<std::size_t>(y * width + x);
      if (reference.object[here] != reference.object[here + 1]) edges.at(x, y) += Color(0.3);
    }
  CHECK(kinds(edges, reference) == Kinds{"edges"});

  Reference unknown = reference;
  unknown.stage = 0;  // a plain image says nothing about objects
  CHECK(kinds(object, unknown).empty());
}

TEST_CASE("diff: a transfer curve is recognised, put on or taken off", "[diff]") {
  const Reference reference = reference_of(smooth_picture());
  const auto curved = [&](double power) {
    return mapped(reference.value, [&](int x, int y) {
      const Color& c = reference.value.at(x, y);
      return Color(std::pow(c.r, power), std::pow(c.g, power), std::pow(c.b, power));
    });
  };
  CHECK(kinds(curved(1 / 2.2), reference).at(0) == "transfer-curve");
  CHECK(kinds(curved(2.2), reference).at(0) == "transfer-curve");
}

TEST_CASE("diff: thin, flat and empty differences are not called shifted, mirrored or brighter", "[diff]") {
  const Reference one = reference_of(Image(1, 1, Color(0.2, 0.3, 0.9)));
  CHECK(kinds(Image(1, 1, Color(0.9, 0.1, 0.2)), one) == Kinds{"everywhere"});
  const Reference row = reference_of(smooth_picture(160, 1));
  Image darker = row.value;
  for (Color& c : darker.pixels) c -= Color(0.1, 0.15, 0.05);
  CHECK(kinds(darker, row) == Kinds{"everywhere"});

  const Reference flat = reference_of(Image(width, height, Color(0.5)));
  Image without_last_column = flat.value;
  for (int y = 0; y < height; ++y) without_last_column.at(width - 1, y) = Color(0);
  CHECK(kinds(without_last_column, flat).empty());
  Image one_bad = flat.value;
  one_bad.at(3, 3).r = std::nan("");
  CHECK(kinds(one_bad, flat).empty());

  Reference white = reference_of(Image(width, height, Color(1)));
  white.value.at(0, 0) = white.least.at(0, 0) = white.greatest.at(0, 0) = Color(0.5);
  Image black(width, height, Color(0));
  black.at(0, 0) = Color(0.25);
  CHECK(kinds(black, white) == Kinds{"everywhere"});
}

TEST_CASE("diff: an image that came through 8 bits is judged by its steps", "[diff]") {
  const Reference reference = reference_of(smooth_picture());
  const Image levels = mapped(reference.value, [&](int x, int y) {
    const Color& c = reference.value.at(x, y);
    return Color(quantise(c.r), quantise(c.g), quantise(c.b)) / 255.0;
  });
  CHECK(compare(levels, NumberFormat::float32, reference).same);
  CHECK(compare(levels, NumberFormat::uint16, reference).same);
  CHECK_FALSE(compare(with_moved(levels, 100, 0.3 / 255), NumberFormat::float32, reference).same);
}

TEST_CASE("diff: the other way to clamp is taken only where it fits better", "[diff]") {
  Reference reference = reference_of(smooth_picture());
  reference.each = PixelRanges{with_moved(reference.value, 200, 0.002), with_moved(reference.value, 200, 0.002),
                               with_moved(reference.value, 200, 0.002)};
  const Comparison c = compare(with_moved(reference.value, 150, 0.0015), NumberFormat::uint8, reference);
  CHECK(c.same);
  CHECK_FALSE(c.clamped_each);
}

TEST_CASE("diff: sensitivity does not hide a decision", "[diff]") {
  Reference reference = reference_of(smooth_picture());
  std::fill(reference.margin.begin(), reference.margin.end(), 1e-17);
  std::fill(reference.sensitivity.begin(), reference.sensitivity.end(), 0.5);
  const Comparison c = compared(with_moved(reference.value, 200, 0.4), reference);
  CHECK(c.at_decision == 200);
}

TEST_CASE("diff: an image with no number in it has no errors to tell", "[diff]") {
  const Reference reference = reference_of(smooth_picture());
  const Comparison c = compared(Image(width, height, Color(std::nan(""))), reference);
  CHECK(std::isnan(c.max_error));
  CHECK(std::isnan(c.rmse));
  CHECK(nlohmann::json::parse(diff_json({"a", "b"}, c))["rmse"] == "NaN");
}

TEST_CASE("diff: some wrong pixels here and there have no pattern", "[diff]") {
  const Reference reference = with_objects();
  CHECK(kinds(with_moved(reference.value, 200, 0.4), reference).empty());
}

TEST_CASE("diff: objects have the names that messages about the scene file use", "[diff]") {
  const Reference reference = with_objects();
  CHECK(object_name(reference, no_geometry) == "background");
  CHECK(object_name(reference, 0) == "plane[0]");
  CHECK(object_name(reference, 2) == "sphere[1]");
  CHECK(object_name(reference, 3) == "cloud sphere 0");
}

TEST_CASE("diff: the heat map is logarithmic, and shows what is not a number in a color of its own", "[diff]") {
  CHECK(heat_level(0) == 0);
  CHECK(heat_level(1e-5) == 0);
  CHECK(heat_level(0.01) == within(1e-12, 0.5));
  CHECK(heat_level(1) == 1);
  const std::vector<Color> colors = heat_colors();
  REQUIRE(colors.size() == 256);
  const auto lightness = [](const Color& c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; };
  for (std::size_t k = 1; k < colors.size(); ++k) CHECK(lightness(colors[k]) > lightness(colors[k - 1]) - 1e-3);
  CHECK(lightness(colors.back()) - lightness(colors.front()) > 0.8);
  for (const Color& c : colors) CHECK(glm::distance(c, non_finite_color) > 0.3);

  Reference reference = reference_of(Image(3, 1, Color(0.5)));
  Image image = reference.value;
  image.at(1, 0).r += 0.01;
  image.at(2, 0).r = std::nan("");
  const Image map = heat_map(compared(image, reference));
  CHECK(map.at(0, 0) == colors.front());
  CHECK((map.at(1, 0) == colors[127] || map.at(1, 0) == colors[128]));
  CHECK(map.at(2, 0) == non_finite_color);
}

TEST_CASE("diff: side by side, small images are enlarged", "[diff]") {
  const Reference reference = reference_of(smooth_picture());
  const Image page = side_by_side(reference.value, reference, compared(reference.value, reference));
  CHECK(page.width > 3 * 320);
  CHECK(page.height > 240);
  const Reference wide = reference_of(Image(700, 2, Color(0.5)));
  CHECK(side_by_side(wide.value, wide, compared(wide.value, wide)).width > 2100);
}

TEST_CASE("diff: text and JSON say the same", "[diff]") {
  const Reference reference = with_objects();
  Comparison c = compared(with_moved(reference.value, 25, 0.5), reference);
  c.findings = {{"edges", "A sentence."}};
  const std::string text = diff_text({"mine.png", "scene3 at stage 5"}, c);
  CHECK_THAT(text, ContainsSubstring("differs: mine.png and scene3 at stage 5"));
  CHECK_THAT(text, ContainsSubstring("25 pixels of 19200 outside their range, 19 may be"));
  CHECK_THAT(text, ContainsSubstring("A sentence."));
  const auto json = nlohmann::json::parse(diff_json({"mi\xffne.png", "r"}, c));
  CHECK(json["verdict"] == "differs");
  CHECK(json["outside"] == 25);
  CHECK(json["worst"].size() == 10);
  CHECK(json["findings"][0]["kind"] == "edges");
  const auto same = nlohmann::json::parse(diff_json({"a", "b"}, compared(reference.value, reference)));
  CHECK(same["verdict"] == "same");
  CHECK(same["psnr"] == "Infinity");
}
