#include "core/image/open_image.hpp"

#include "core/image/check_exr.hpp"
#include "core/image/check_png.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace raylab {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t most_bytes = 1U << 30U;
constexpr long long longest_side = 65536;     // as of an image in a scene
constexpr long long most_pixels = 1LL << 25;  // of three channels
constexpr int most_channels = 32;

/// Everything that can be said without opening the file: opening a pipe or a device may wait for ever.
void check_place(const fs::path& path) {
  std::error_code error;
  const fs::file_type type = fs::symlink_status(path, error).type();
  if (type == fs::file_type::not_found) refuse_image(path, "no such file: check the name");
  if (type == fs::file_type::none) refuse_image(path, "cannot be looked at: " + error.message());
  if (type == fs::file_type::symlink) refuse_image(path, "is a link: name the file itself");
  if (type == fs::file_type::directory) refuse_image(path, "is a folder: name an image in it");
  if (type != fs::file_type::regular) refuse_image(path, "is a pipe, a socket or a device: copy the image to a file");
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) refuse_image(path, "cannot be looked at: " + error.message());
  if (size == 0) refuse_image(path, "is empty: make or copy it again");
  if (size > most_bytes)
    refuse_image(path, "has " + std::to_string(size) + " bytes, and at most " + std::to_string(most_bytes) +
                           " are read: save a smaller image");
}

std::string first_bytes(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse_image(path, "cannot be opened: check that you are allowed to read it");
  std::string bytes(4, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

/// OpenImageIO's name of the format that the file's first bytes announce. Left to itself it would go by the file's name and
/// then let each of its many readers try, from movies to fonts.
std::string format_name(const fs::path& path) {
  using namespace std::string_view_literals;
  struct Signature {
    std::string_view bytes;
    const char* format;
  };
  static constexpr std::array signatures{Signature{"\x89PNG"sv, "png"},
                                         Signature{"\x76\x2f\x31\x01"sv, "openexr"},
                                         Signature{"II*\0"sv, "tiff"},
                                         Signature{"MM\0*"sv, "tiff"},
                                         Signature{"II+\0"sv, "tiff"},
                                         Signature{"MM\0+"sv, "tiff"},
                                         Signature{"\xff\xd8\xff"sv, "jpeg"},
                                         Signature{"BM"sv, "bmp"},
                                         Signature{"P3"sv, "pnm"},
                                         Signature{"P6"sv, "pnm"}};
  const std::string bytes = first_bytes(path);
  for (const Signature& signature : signatures)
    if (bytes.starts_with(signature.bytes)) return signature.format;
  refuse_image(path, "is not an image of a format that is read: save it as PNG, EXR, TIFF, JPEG, BMP or PPM");
}

/// OpenImageIO stretches numbers with another maximum to 8 or 16 bits without a word, and 65535 to 65534.
void check_pnm(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string magic;
  file >> magic;
  std::array<long long, 3> header{};  // width, height, maximum
  for (long long& number : header) {
    while ((file >> std::ws).peek() == '#') file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    file >> number;
  }
  if (!file) refuse_image(path, "is a PPM whose header is truncated or damaged: make or copy it again");
  check_image_size(path, header[0], header[1], 3);
  if (header[2] != 255)
    refuse_image(path, "is a PPM with the maximum " + std::to_string(header[2]) + ": save it with the maximum 255");
}

[[noreturn]] void refuse_large(const fs::path& path, const std::string& size) {
  refuse_image(path, "is too large" + size + ": read are up to 33554432 pixels of 3 channels, and 65536 in a row or column");
}

[[noreturn]] void refuse_damaged(const fs::path& path, const OIIO::ImageInput& input) {
  const std::string errors = input.geterror();
  if (errors.find("\"limits:") != std::string::npos) refuse_large(path, "");
  const std::string first_line = errors.substr(0, std::min<std::size_t>(errors.find('\n'), 200));
  refuse_image(path, "is truncated or damaged, or of a kind that is not read" +
                         (first_line.empty() ? "" : " (" + first_line + ")") + ": make or copy it again");
}

/// Does the file hold this subimage, or this level of a texture? Leaves `input` at the first of all.
bool has(OIIO::ImageInput& input, const fs::path& path, int subimage, int level) {
  const bool found = input.seek_subimage(subimage, level);
  input.geterror();  // that there is no such thing is no error
  if (!input.seek_subimage(0, 0)) refuse_damaged(path, input);
  return found;
}

void check_header(const fs::path& path, OIIO::ImageInput& input) {
  const OIIO::ImageSpec spec = input.spec();
  if (spec.deep) refuse_image(path, "is a deep image: save it flat");
  if (spec.depth > 1) refuse_image(path, "is a volume: save it as a flat image");
  check_image_size(path, spec.width, spec.height, spec.nchannels);
  if (has(input, path, 1, 0)) refuse_image(path, "holds several images: save one alone");
  if (has(input, path, 0, 1)) refuse_image(path, "is a texture with several resolutions: save it as a plain image");
  if (spec.x != spec.full_x || spec.y != spec.full_y || spec.width != spec.full_width || spec.height != spec.full_height)
    refuse_image(path, "is a part of a larger image, or reaches beyond it: save the whole image and no more");
  if (spec.get_int_attribute("Orientation", 1) != 1)
    refuse_image(path, "is stored turned or mirrored (tag Orientation): save it upright");
  // OpenImageIO 2.4 reads these as zeros, and tells of success.
  const bool is_tiff = std::string_view(input.format_name()) == "tiff";
  if (is_tiff && spec.format == OIIO::TypeDesc::DOUBLE && (spec.tile_width > 0 || spec.height == 1))
    refuse_image(path, "is a TIFF of 64-bit floats in tiles or in one row, which is not read: save it as 32-bit floats");
}

/// The largest whole number of a type, 0 for floats.
double largest(OIIO::TypeDesc type) {
  if (type == OIIO::TypeDesc::UINT8) return 255;
  if (type == OIIO::TypeDesc::UINT16) return 65535;
  if (type == OIIO::TypeDesc::UINT32) return 4294967295;
  return 0;
}

/// Of a truncated TIFF or JPEG OpenImageIO fills up the missing part, tells of success, and leaves only messages; after 16
/// MB of them it stops the program. So it is asked after each band of rows.
bool read_pixels(OIIO::ImageInput& input, double* numbers) {
  const OIIO::ImageSpec& spec = input.spec();
  constexpr OIIO::TypeDesc type = OIIO::TypeDesc::DOUBLE;
  if (spec.tile_width > 0) {
    const auto failed = [](void* reader, float) { return static_cast<OIIO::ImageInput*>(reader)->has_error(); };
    constexpr OIIO::stride_t dense = OIIO::AutoStride;
    return input.read_image(0, 0, 0, spec.nchannels, type, numbers, dense, dense, dense, failed, &input) &&
           !input.has_error();
  }
  // Whole strips of a TIFF, and never a single row: of 64-bit floats it would be read as zeros.
  const int strip = std::clamp(spec.get_int_attribute("tiff:RowsPerStrip", 1), 1, spec.height);
  const int band = strip * std::max(1, 256 / strip);
  for (int done = 0; done < spec.height;) {
    const int rows = spec.height - done <= band + 1 ? spec.height - done : band;
    const int first = spec.y + done;
    double* const place = numbers + static_cast<std::ptrdiff_t>(done) * spec.width * spec.nchannels;
    if (!input.read_scanlines(0, 0, first, first + rows, 0, 0, spec.nchannels, type, place) || input.has_error())
      return false;
    done += rows;
  }
  return true;
}

}  // namespace

void refuse_image(const fs::path& path, std::string why) {
  for (char& c : why)
    if (c < ' ' || c > '~') c = '?';
  throw std::runtime_error(path.string() + ": " + why);
}

void check_image_size(const fs::path& path, long long width, long long height, int channels) {
  if (width < 1 || height < 1 || channels < 1) refuse_image(path, "has no pixels: make it again");
  const std::string size = ", " + std::to_string(width) + " x " + std::to_string(height) + " pixels" +
                           (channels > 3 ? " of " + std::to_string(channels) + " channels" : "");
  if (width > longest_side || height > longest_side || channels > most_channels ||
      width * height * std::max(channels, 3) > most_pixels * 3)
    refuse_large(path, size);
}

std::unique_ptr<OIIO::ImageInput> open_image(const fs::path& path) {
  check_place(path);
  const std::string format = format_name(path);
  if (format == "png") check_png(path);
  if (format == "openexr") check_exr(path);
  if (format == "pnm") check_pnm(path);

  // The same limits once more, for the readers that ask for them.
  OIIO::attribute("limits:imagesize_MB", static_cast<int>(most_pixels * 3 * static_cast<int>(sizeof(double)) >> 20));
  OIIO::attribute("limits:channels", most_channels);
  std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(format);
  if (!input) {
    OIIO::geterror();  // its text speaks of plug-ins
    refuse_image(path, "cannot be read: this OpenImageIO knows no " + format + ": save it as PNG");
  }
  OIIO::ImageSpec hints, spec;
  hints.attribute("oiio:RawColor", 1);           // no conversion of colors ...
  hints.attribute("oiio:UnassociatedAlpha", 1);  // ... and no multiplication by alpha
  // A JPEG that ends in its header is opened all the same, with a message.
  if (!input->open(path.string(), spec, hints) || input->has_error()) refuse_damaged(path, *input);
  check_header(path, *input);
  return input;
}

std::vector<double> read_numbers(OIIO::ImageInput& input, const fs::path& path) {
  const OIIO::ImageSpec& spec = input.spec();
  const auto channels = static_cast<std::size_t>(spec.nchannels);
  std::vector<double> numbers(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) * channels);
  if (!read_pixels(input, numbers.data())) refuse_damaged(path, input);
  for (std::size_t channel = 0; channel < channels; ++channel) {
    const double levels = largest(spec.channelformat(static_cast<int>(channel)));
    if (levels == 0) continue;
    // OpenImageIO has divided in float.
    for (std::size_t k = channel; k < numbers.size(); k += channels) numbers[k] = std::round(numbers[k] * levels) / levels;
  }
  return numbers;
}

}  // namespace raylab
