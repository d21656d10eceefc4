#include "core/image/image_file.hpp"

#include "core/image/open_image.hpp"
#include "core/image/partial_file.hpp"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <random>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace raylab {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& why) {
  throw std::runtime_error(path.string() + ": " + why);
}

std::string lower_extension(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

OIIO::TypeDesc component_type(const fs::path& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".exr") return OIIO::TypeDesc::FLOAT;
  if (extension == ".tif" || extension == ".tiff") return OIIO::TypeDesc::DOUBLE;
  return OIIO::TypeDesc::UINT8;
}

/// The components of `pixels` in the type that the file stores.
template <class T>
std::vector<T> components(std::span<const Color> pixels) {
  std::vector<T> values;
  values.reserve(3 * pixels.size());
  for (const Color& pixel : pixels)
    for (int channel = 0; channel < 3; ++channel) {
      if constexpr (std::is_same_v<T, unsigned char>)
        values.push_back(quantise(pixel[channel]));
      else
        values.push_back(static_cast<T>(pixel[channel]));
    }
  return values;
}

/// Where in a pixel its R, G and B stand.
std::array<std::size_t, 3> channel_places(const fs::path& path, const OIIO::ImageSpec& spec) {
  if (spec.nchannels != 3) {
    const std::string advice = spec.nchannels < 3 ? "save it in color" : "save it without alpha or other channels";
    refuse_image(path, "has " + std::to_string(spec.nchannels) + (spec.nchannels == 1 ? " channel" : " channels") +
                           ", wanted 3 (R, G, B): " + advice);
  }
  constexpr int rgb = 2;  // of TIFF's tag; any other is a palette or needs a conversion
  if (spec.get_int_attribute("tiff:PhotometricInterpretation", rgb) != rgb)
    refuse_image(path, "stores its colors as other than R, G, B, by a palette, say: save it as RGB");
  const std::vector<std::string>& names = spec.channelnames;
  std::array<std::size_t, 3> places{};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto found = std::find(names.begin(), names.end(), std::string(1, "RGB"[c]));
    if (found == names.end())
      refuse_image(path, "has the channels " + names[0] + ", " + names[1] + ", " + names[2] + ": name them R, G, B");
    places[c] = static_cast<std::size_t>(found - names.begin());
  }
  return places;
}

NumberFormat number_format(const fs::path& path, const OIIO::ImageSpec& spec) {
  static constexpr std::array<std::pair<OIIO::TypeDesc::BASETYPE, NumberFormat>, 5> formats{{
      {OIIO::TypeDesc::UINT8, NumberFormat::uint8},
      {OIIO::TypeDesc::UINT16, NumberFormat::uint16},
      {OIIO::TypeDesc::HALF, NumberFormat::float16},
      {OIIO::TypeDesc::FLOAT, NumberFormat::float32},
      {OIIO::TypeDesc::DOUBLE, NumberFormat::float64},
  }};
  const OIIO::TypeDesc type = spec.format;
  if (!spec.channelformats.empty()) refuse_image(path, "has channels of different number types: save it with one type");
  const int bits = spec.get_int_attribute("oiio:BitsPerSample", 0);
  for (const auto& [base, format] : formats)
    if (type == base && (bits == 0 || bits == static_cast<int>(8 * type.size()))) return format;
  const std::string stored = bits > 0 ? std::to_string(bits) + "-bit " + type.c_str() : type.c_str();
  refuse_image(path, "stores " + stored + " numbers: save it with 8 or 16 bits, or floats of 16, 32 or 64");
}

}  // namespace

unsigned char quantise(double component) {
  // Written so that a NaN, which converts to no integer, gives 0.
  const double level = std::floor(255 * component + 0.5);
  return level > 0 ? static_cast<unsigned char>(std::min(level, 255.0)) : static_cast<unsigned char>(0);
}

struct ImageWriter::State {
  fs::path path;
  int width;
  OIIO::TypeDesc type;
  PartialFile file;
  std::unique_ptr<OIIO::ImageOutput> output;
  int height;
  bool open = false;
  int rows_written = 0;

  ~State() {
    if (open && type == OIIO::TypeDesc::UINT8) quieten_libpng();
  }

  bool write(int first_row, int rows, const void* values) {
    rows_written = first_row + rows;
    return output->write_scanlines(first_row, first_row + rows, 0, type, values);
  }

  /// libpng complains on standard error when a file is closed before any of its data has left the compressor. An abandoned
  /// file therefore gets some rows of noise, which cannot be held back by compression.
  void quieten_libpng() {
    constexpr std::size_t enough_bytes = 1 << 17;
    std::minstd_rand noise;
    std::vector<unsigned char> row(3 * static_cast<std::size_t>(width));
    for (std::size_t written = 0; written < enough_bytes && rows_written < height; written += row.size()) {
      for (unsigned char& byte : row) byte = static_cast<unsigned char>(noise() >> 8);
      if (!write(rows_written, 1, row.data())) return;
    }
  }
};

ImageWriter::ImageWriter(const fs::path& path, int width, int height) {
  if (path.extension().empty()) fail(path, "an image's name needs an ending that says its format: .png, .exr or .tif");
  state_.reset(new State{path, width, component_type(path), PartialFile(path), nullptr, height});
  const std::string temporary = state_->file.temporary().string();
  state_->output = OIIO::ImageOutput::create(temporary);
  if (!state_->output) {
    OIIO::geterror();  // its text speaks of plug-ins
    fail(path, "no image format is known for the ending '" + path.extension().string() + "': use .png, .exr or .tif");
  }
  // Other formats keep the whole image in memory, or stop the program beyond their own limit.
  constexpr int most_pixels_across = 16384;
  const std::string extension = lower_extension(path);
  if (state_->type == OIIO::TypeDesc::UINT8 && extension != ".png" && std::max(width, height) > most_pixels_across)
    fail(path, "is written up to 16384 pixels wide and high in this format: use .png, .exr or .tif");
  OIIO::ImageSpec spec(width, height, 3, state_->type);
  spec.channelnames = {"R", "G", "B"};
  // OpenImageIO takes floats for linear light, which they are as little as the bytes: they are to be shown as they are.
  spec.attribute("oiio:ColorSpace", "sRGB");
  // OpenImageIO would put the time into some formats; the same image shall be the same bytes.
  if (state_->type != OIIO::TypeDesc::UINT8) spec.attribute("DateTime", "1970:01:01 00:00:00");
  state_->open = state_->output->open(temporary, spec);
  if (!state_->open) fail(path, "cannot be written: " + state_->output->geterror());
}

ImageWriter::~ImageWriter() = default;

void ImageWriter::write_rows(int first_row, std::span<const Color> pixels) {
  const int rows = static_cast<int>(pixels.size() / static_cast<std::size_t>(state_->width));
  const bool written =
      state_->type == OIIO::TypeDesc::UINT8   ? state_->write(first_row, rows, components<unsigned char>(pixels).data())
      : state_->type == OIIO::TypeDesc::FLOAT ? state_->write(first_row, rows, components<float>(pixels).data())
                                              : state_->write(first_row, rows, components<double>(pixels).data());
  if (!written) fail(state_->path, "cannot be written: " + state_->output->geterror());
}

void ImageWriter::finish() {
  if (!state_->output->close()) fail(state_->path, "cannot be written: " + state_->output->geterror());
  state_->file.commit();
}

void write_image(const fs::path& path, const Image& image) {
  ImageWriter writer(path, image.width, image.height);
  writer.write_rows(0, image.pixels);
  writer.finish();
}

ImageFile read_image(const fs::path& path) {
  const std::unique_ptr<OIIO::ImageInput> input = open_image(path);
  const std::array<std::size_t, 3> places = channel_places(path, input->spec());
  const NumberFormat format = number_format(path, input->spec());
  const std::vector<double> numbers = read_numbers(*input, path);
  Image image(input->spec().width, input->spec().height);
  for (std::size_t k = 0; k < image.pixels.size(); ++k)
    image.pixels[k] = Color(numbers[3 * k + places[0]], numbers[3 * k + places[1]], numbers[3 * k + places[2]]);
  return {std::move(image), format};
}

ImageSize image_size(const fs::path& path) {
  const std::unique_ptr<OIIO::ImageInput> input = open_image(path);
  return {input->spec().width, input->spec().height};
}

}  // namespace raylab
