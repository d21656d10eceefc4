#include "core/image/reference_file.hpp"

#include "core/image/image_file.hpp"
#include "core/image/open_image.hpp"
#include "core/image/partial_file.hpp"
#include "core/scene/scene.hpp"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace raylab {
namespace {

namespace fs = std::filesystem;

constexpr double most_objects = 1 << 24;  // floats count that far

// The channels.

const std::vector<std::string> plain_channels = {"R",       "G",       "B",       "below.R", "below.G",
                                                 "below.B", "above.R", "above.G", "above.B"};
const std::vector<std::string> word_channels = {"margin", "sensitivity", "object"};

std::vector<std::string> each_channels() {
  std::vector<std::string> names;
  for (const std::string& name : plain_channels) names.push_back("each." + name);
  return names;
}

template <class T>
void append(std::vector<T>& list, const std::vector<T>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

void append(std::vector<float>& values, const Color& color) {
  for (int channel = 0; channel < 3; ++channel) values.push_back(static_cast<float>(color[channel]));
}

enum class Towards { zero, infinity };

/// Rounded to so many binary digits: few are enough for what is a bound, and compress well.
float rounded_to(int digits, double value, Towards side) {
  if (!(value > 0)) return 0;
  const double unit = std::ldexp(1.0, std::ilogb(value) - (digits - 1));
  const double rounded = side == Towards::zero ? std::floor(value / unit) : std::ceil(value / unit);
  const auto result = static_cast<float>(rounded * unit);
  return result == 0 && side == Towards::infinity ? std::numeric_limits<float>::min() : result;
}

/// How far it may be off: at most 3 % more than is so.
void append_range(std::vector<float>& values, const Color& off) {
  for (int channel = 0; channel < 3; ++channel) values.push_back(rounded_to(6, off[channel], Towards::infinity));
}

void append_pixel(std::vector<float>& values, const Reference& reference, std::size_t k) {
  const Color& value = reference.value.pixels[k];
  append(values, value);
  append_range(values, value - reference.least.pixels[k]);
  append_range(values, reference.greatest.pixels[k] - value);
  if (reference.each) {
    const Color& each = reference.each->value.pixels[k];
    append(values, each - value);
    append_range(values, each - reference.each->least.pixels[k]);
    append_range(values, reference.each->greatest.pixels[k] - each);
  }
  values.push_back(rounded_to(3, reference.margin[k], Towards::zero));
  values.push_back(rounded_to(3, reference.sensitivity[k], Towards::infinity));
  values.push_back(static_cast<float>(reference.object[k]));
}

/// The channels of a file by their names.
class Channels {
 public:
  Channels(fs::path path, std::vector<std::string> names, std::vector<double> numbers)
      : path_(std::move(path)), names_(std::move(names)), numbers_(std::move(numbers)) {}

  bool has(const std::string& name) const { return std::find(names_.begin(), names_.end(), name) != names_.end(); }

  std::vector<double> take(const std::string& name) const {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end()) refuse_image(path_, "is a reference without the channel " + name + ": render it again");
    std::vector<double> values;
    values.reserve(numbers_.size() / names_.size());
    for (auto k = static_cast<std::size_t>(found - names_.begin()); k < numbers_.size(); k += names_.size())
      values.push_back(numbers_[k]);
    return values;
  }

  /// The channels prefix + R, G, B.
  Image take_colors(const std::string& prefix, ImageSize size) const {
    const std::array channels{take(prefix + "R"), take(prefix + "G"), take(prefix + "B")};
    Image image(size.width, size.height);
    for (std::size_t k = 0; k < image.pixels.size(); ++k)
      image.pixels[k] = Color(channels[0][k], channels[1][k], channels[2][k]);
    return image;
  }

 private:
  fs::path path_;
  std::vector<std::string> names_;
  std::vector<double> numbers_;
};

Image combined(const Image& a, double sign, const Image& b) {
  Image sum = a;
  for (std::size_t k = 0; k < sum.pixels.size(); ++k) sum.pixels[k] += sign * b.pixels[k];
  return sum;
}

/// A sum of two rounded numbers may pass 1.
Image clamped(Image image) {
  for (Color& c : image.pixels) c = {std::clamp(c.r, 0.0, 1.0), std::clamp(c.g, 0.0, 1.0), std::clamp(c.b, 0.0, 1.0)};
  return image;
}

PixelRanges ranges_around(const Image& value, const std::string& prefix, const Channels& channels) {
  const ImageSize size{value.width, value.height};
  return {value, combined(value, -1, channels.take_colors(prefix + "below.", size)),
          combined(value, 1, channels.take_colors(prefix + "above.", size))};
}

bool all_in(const std::vector<double>& values, double low, double high) {
  return std::all_of(values.begin(), values.end(), [&](double value) { return value >= low && value <= high; });
}

bool all_in(const Image& image, double low, double high) {
  const auto in = [&](const Color& c) {
    return c.r >= low && c.r <= high && c.g >= low && c.g <= high && c.b >= low && c.b <= high;
  };
  return std::all_of(image.pixels.begin(), image.pixels.end(), in);
}

/// Differences are rounded to float beside values that are, too.
bool makes_sense(const PixelRanges& ranges) {
  constexpr double rounding = 1e-6;
  return all_in(ranges.value, 0, 1) && all_in(combined(ranges.value, -1, ranges.least), 0, 1 + rounding) &&
         all_in(combined(ranges.greatest, -1, ranges.value), 0, 1 + rounding);
}

/// The pixels of a reference, or an exception.
Reference decoded(const fs::path& path, ImageSize size, const Channels& channels) {
  const Image value = channels.take_colors("", size);
  Reference reference{ranges_around(value, "", channels), {}, channels.take("margin"), channels.take("sensitivity"), {}};
  if (channels.has("each.R"))
    reference.each = ranges_around(clamped(combined(value, 1, channels.take_colors("each.", size))), "each.", channels);
  const std::vector<double> objects = channels.take("object");
  const bool sense = makes_sense(reference) && (!reference.each || makes_sense(*reference.each)) &&
                     all_in(reference.margin, 0, 1) && all_in(reference.sensitivity, 0, 1) &&
                     all_in(objects, no_geometry, most_objects);
  if (!sense) refuse_image(path, "is a reference with values that no scene gives: render it again");
  for (const double object : objects) reference.object.push_back(static_cast<GeometryId>(object));
  return reference;
}

std::vector<std::string> channel_names(const Reference& reference) {
  std::vector<std::string> names = plain_channels;
  if (reference.each) append(names, each_channels());
  append(names, word_channels);
  return names;
}

std::vector<float> encoded(const Reference& reference) {
  std::vector<float> values;
  for (std::size_t k = 0; k < reference.value.pixels.size(); ++k) append_pixel(values, reference, k);
  return values;
}

}  // namespace

void write_reference(const fs::path& path, const Reference& reference) {
  const std::vector<std::string> names = channel_names(reference);
  const std::vector<float> values = encoded(reference);
  PartialFile file(path);
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("openexr");
  OIIO::ImageSpec spec(reference.value.width, reference.value.height, static_cast<int>(names.size()), OIIO::TypeDesc::FLOAT);
  spec.channelnames = names;
  spec.attribute("compression", "zip");
  spec.attribute("DateTime", "1970:01:01 00:00:00");  // in place of the present time: the same bytes
  spec.attribute("raylab:scene", reference.scene);
  spec.attribute("raylab:stage", reference.stage);
  spec.attribute("raylab:planes", reference.planes);
  spec.attribute("raylab:spheres", reference.spheres);
  if (!output || !output->open(file.temporary().string(), spec) ||
      !output->write_image(OIIO::TypeDesc::FLOAT, values.data()) || !output->close())
    throw std::runtime_error(path.string() + ": cannot be written: " + (output ? output->geterror() : OIIO::geterror()));
  file.commit();
}

Reference as_stored(const Reference& reference) {
  const std::vector<float> values = encoded(reference);
  const Channels channels("a reference", channel_names(reference), std::vector<double>(values.begin(), values.end()));
  Reference stored = decoded("a reference", {reference.value.width, reference.value.height}, channels);
  stored.scene = reference.scene;
  stored.stage = reference.stage;
  stored.planes = reference.planes;
  stored.spheres = reference.spheres;
  return stored;
}

Reference read_reference(const fs::path& path) {
  const std::unique_ptr<OIIO::ImageInput> input = open_image(path);
  const OIIO::ImageSpec spec = input->spec();
  if (spec.get_int_attribute("raylab:stage") > 0) {
    const Channels channels(path, spec.channelnames, read_numbers(*input, path));
    Reference reference = decoded(path, {spec.width, spec.height}, channels);
    reference.scene = spec.get_string_attribute("raylab:scene");
    reference.stage = spec.get_int_attribute("raylab:stage");
    reference.planes = spec.get_int_attribute("raylab:planes");
    reference.spheres = spec.get_int_attribute("raylab:spheres");
    return reference;
  }
  ImageFile file = read_image(path);
  const std::size_t pixels = file.image.pixels.size();
  return {{file.image, file.image, file.image},
          {},
          std::vector<double>(pixels, 1.0),
          std::vector<double>(pixels, 0.0),
          std::vector<GeometryId>(pixels, no_geometry),
          file.format};
}

std::string object_name(const Reference& reference, GeometryId object) {
  if (object == no_geometry) return "background";
  if (object < reference.planes) return "plane[" + std::to_string(object) + "]";
  const int sphere = object - reference.planes;
  if (sphere < reference.spheres) return "sphere[" + std::to_string(sphere) + "]";
  return "cloud sphere " + std::to_string(sphere - reference.spheres);
}

}  // namespace raylab
