// Images that nobody has vetted: each is read in full, or refused with a reason.
#include "core/image/data_folder.hpp"
#include "core/image/image_file.hpp"
#include "tests/support.hpp"
#include "tests/temporary_folder.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

using namespace raylab;
using namespace raylab::test;

namespace {

namespace fs = std::filesystem;

fs::path fixture(const std::string& name) { return data_folder("tests/data") / "images" / name; }

/// The picture that the fixtures hold, in fifteenths.
int fifteenths(int column, int row, int channel) { return (column * (channel + 1) + 3 * row + channel) % 16; }

Image picture() {
  Image image(7, 5);
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 7; ++x)
      for (int c = 0; c < 3; ++c) image.at(x, y)[c] = fifteenths(x, y, c) / 15.0;
  return image;
}

/// "" if the file is read, or else why not, without its name.
std::string refusal(const fs::path& path) {
  try {
    read_image(path);
    return "";
  } catch (const std::runtime_error& error) {
    const std::string text = error.what();
    const std::string name = path.string() + ": ";
    return text.starts_with(name) ? text.substr(name.size()) : "without its name: " + text;
  }
}

/// The files of one folder are read from there.
struct Refused {
  const char* file;
  const char* reason;
};

std::string big_endian(std::uint32_t number) {
  std::string bytes;
  for (unsigned shift = 32; shift > 0; shift -= 8) bytes += static_cast<char>(number >> (shift - 8) & 0xFFU);
  return bytes;
}

std::string little_endian(std::uint32_t number) {
  std::string bytes = big_endian(number);
  std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// A part of a PNG, with its right checksum.
std::string png_part(const std::string& name, const std::string& data) {
  std::uint32_t sum = 0xFFFFFFFFU;
  for (const char c : name + data) {
    sum ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1U) ^ ((sum & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return big_endian(static_cast<std::uint32_t>(data.size())) + name + data + big_endian(~sum);
}

constexpr std::size_t png_header_end = 33;

std::string png_header(std::uint32_t width, std::uint32_t height) {
  using namespace std::string_literals;
  return "\x89PNG\r\n\x1a\n" + png_part("IHDR", big_endian(width) + big_endian(height) + "\x08\x02\0\0\0"s);
}

std::string replaced(std::string text, std::size_t at, const std::string& by) { return text.replace(at, by.size(), by); }

}  // namespace

TEST_CASE("image: a number format says its name and half its step", "[image]") {
  CHECK(name_of(NumberFormat::uint8) == "8 bits");
  CHECK(name_of(NumberFormat::uint16) == "16 bits");
  CHECK(name_of(NumberFormat::float16) == "16-bit floats");
  CHECK(name_of(NumberFormat::float32) == "32-bit floats");
  CHECK(name_of(NumberFormat::float64) == "64-bit floats");
  CHECK(half_step(NumberFormat::uint8, 0.3) == 0.5 / 255);
  CHECK(half_step(NumberFormat::uint16, 0.3) == 0.5 / 65535);
  CHECK(half_step(NumberFormat::float16, 1) == 0x1p-11);
  CHECK(half_step(NumberFormat::float16, 0.999) == 0x1p-12);
  CHECK(half_step(NumberFormat::float16, -0.5) == 0x1p-12);
  CHECK(half_step(NumberFormat::float16, 0x1p-14) == 0x1p-25);  // the least normal number
  CHECK(half_step(NumberFormat::float16, 0x1p-20) == 0x1p-25);
  CHECK(half_step(NumberFormat::float16, 0) == 0x1p-25);
  CHECK(half_step(NumberFormat::float32, 0.75) == 0x1p-25);
  CHECK(half_step(NumberFormat::float32, 0x1p-140) == 0x1p-150);
  CHECK(half_step(NumberFormat::float64, 0.75) == 0x1p-54);
}

TEST_CASE("image: every number format is read exactly, and told", "[image]") {
  const TemporaryFolder folder;
  const Image expected = picture();
  const auto check = [&](const fs::path& path, NumberFormat format, auto stored) {
    INFO(path);
    const ImageFile file = read_image(path);
    CHECK(file.format == format);
    REQUIRE(file.image.width == 7);
    REQUIRE(file.image.height == 5);
    for (std::size_t k = 0; k < expected.pixels.size(); ++k)
      for (int c = 0; c < 3; ++c) CHECK(file.image.pixels[k][c] == stored(expected.pixels[k][c]));
  };
  const auto eighth_bits = [](double v) { return std::round(255 * v) / 255; };
  const auto sixteen_bits = [](double v) { return std::round(65535 * v) / 65535; };
  const auto half = [](double v) {
    const double step = 2 * half_step(NumberFormat::float16, v);
    return std::nearbyint(v / step) * step;
  };
  const auto single = [](double v) { return static_cast<double>(static_cast<float>(v)); };
  const auto same = [](double v) { return v; };
  for (const char* name : {"gamma.png", "palette.png", "interlaced.png", "planes.tif"})
    check(fixture(name), NumberFormat::uint8, eighth_bits);
  for (const char* name : {"rgb16.png", "16_bits.tif"}) check(fixture(name), NumberFormat::uint16, sixteen_bits);
  for (const char* name : {"half.exr", "tiled.exr", "moved.exr", "half.tif"})
    check(fixture(name), NumberFormat::float16, half);
  check(fixture("float.tif"), NumberFormat::float32, single);
  for (const char* name : {"a.png", "a.bmp", "a.ppm"}) {
    write_image(folder / name, expected);
    check(folder / name, NumberFormat::uint8, eighth_bits);
  }
  write_image(folder / "a.exr", expected);
  check(folder / "a.exr", NumberFormat::float32, single);
  write_image(folder / "a.tif", expected);
  check(folder / "a.tif", NumberFormat::float64, same);
  check(folder.write(
            "a.ppm", "P3 # by hand\n7 5\n# rows follow\n255\n" +
                         [&] {
                           std::string text;
                           for (const Color& pixel : expected.pixels)
                             for (int c = 0; c < 3; ++c) text += std::to_string(quantise(pixel[c])) + "\n";
                           return text;
                         }()),
        NumberFormat::uint8, eighth_bits);
  write_image(folder / "a.jpg", Image(8, 8, Color(0.2)));
  CHECK(read_image(folder / "a.jpg").format == NumberFormat::uint8);
}

TEST_CASE("image: what a file's name says of its format does not matter", "[image]") {
  const TemporaryFolder folder;
  for (const std::string ending : {"png", "exr", "tif"}) {
    write_image(folder / ("a." + ending), picture());
    const Image image = read_image(folder / ("a." + ending)).image;
    for (const char* lie : {"b.exr", "b.png", "b.null", "b"}) {
      fs::copy_file(folder / ("a." + ending), folder / lie, fs::copy_options::overwrite_existing);
      CHECK(read_image(folder / lie).image.pixels == image.pixels);
    }
  }
}

TEST_CASE("image: infinities and what is not a number are read as they are", "[image]") {
  const TemporaryFolder folder;
  for (const char* name : {"a.exr", "a.tif"}) {
    write_image(folder / name, Image(1, 2, Color(infinity, -infinity, std::nan(""))));
    const Color pixel = read_image(folder / name).image.pixels[1];
    CHECK(pixel.x == infinity);
    CHECK(pixel.y == -infinity);
    CHECK(std::isnan(pixel.z));
    write_image(folder / name, Image(1, 2, Color(-0.25, 2.5, 1e30)));
    CHECK(read_image(folder / name).image.pixels[0].x == -0.25);
    CHECK(read_image(folder / name).image.pixels[0].y == 2.5);
    CHECK(read_image(folder / name).image.pixels[0].z == within(1e23, 1e30));
  }
}

TEST_CASE("image: only a regular file is opened, and only by its own name", "[image]") {
  const TemporaryFolder folder;
  CHECK(refusal(folder / "none.png") == "no such file: check the name");
  CHECK(refusal(folder / "x.null") == "no such file: check the name");
  CHECK(refusal("x.null?RES=1x1") == "no such file: check the name");
  CHECK(refusal("") == "no such file: check the name");
  CHECK(refusal(folder / "") == "is a folder: name an image in it");
  write_image(folder / "a.png", picture());
  fs::create_symlink("a.png", folder / "link.png");
  fs::create_symlink("nowhere.png", folder / "dangling.png");
  CHECK(refusal(folder / "link.png") == "is a link: name the file itself");
  CHECK(refusal(folder / "dangling.png") == "is a link: name the file itself");
  CHECK(refusal(folder / "a.png" / "b.png") == "no such file: check the name");
  for (const char* device : {"/dev/null", "/dev/zero"})
    if (fs::exists(device)) CHECK(refusal(device) == "is a pipe, a socket or a device: copy the image to a file");
  CHECK(refusal(folder.write("empty.png", "")) == "is empty: make or copy it again");
  fs::resize_file(folder / "empty.png", (1U << 30U) + 1);  // a hole: takes no space
  CHECK(refusal(folder / "empty.png") == "has 1073741825 bytes, and at most 1073741824 are read: save a smaller image");
}

TEST_CASE("image: a file that may not be read is told from one that is damaged", "[image]") {
  const TemporaryFolder folder;
  write_image(folder / "a.png", picture());
  fs::permissions(folder / "a.png", fs::perms::none);
  if (std::ifstream(folder / "a.png")) return;  // the superuser may read everything
  CHECK(refusal(folder / "a.png") == "cannot be opened: check that you are allowed to read it");
}

TEST_CASE("image: what is no image, or of another format, is refused with the list of formats", "[image]") {
  const TemporaryFolder folder;
  const std::string reason = "is not an image of a format that is read: save it as PNG, EXR, TIFF, JPEG, BMP or PPM";
  for (const char* text : {"not a picture", "P", "x", "GIF89a", "#?RADIANCE", "P5 1 1 255 a", "\x89", "II*"})
    CHECK(refusal(folder.write("a.png", text)) == reason);
  write_image(folder / "a.tga", picture());  // which OpenImageIO would read
  CHECK(refusal(folder / "a.tga") == reason);
}

TEST_CASE("image: other than three channels R, G, B of one type and one picture is refused, each with its reason",
          "[image]") {
  const Refused cases[] = {
      {"gray.png", "has 1 channel, wanted 3 (R, G, B): save it in color"},
      {"gray_1_bit.png", "has 1 channel, wanted 3 (R, G, B): save it in color"},
      {"gray.exr", "has 1 channel, wanted 3 (R, G, B): save it in color"},
      {"gray_alpha.png", "has 2 channels, wanted 3 (R, G, B): save it in color"},
      {"two_channels.exr", "has 2 channels, wanted 3 (R, G, B): save it in color"},
      {"rgba.png", "has 4 channels, wanted 3 (R, G, B): save it without alpha or other channels"},
      {"rgba.exr", "has 4 channels, wanted 3 (R, G, B): save it without alpha or other channels"},
      {"palette_alpha.png", "has 4 channels, wanted 3 (R, G, B): save it without alpha or other channels"},
      {"xyz.exr", "has the channels X, Y, Z: name them R, G, B"},
      {"layer.exr", "has the channels l.R, l.G, l.B: name them R, G, B"},
      {"mixed.exr", "has channels of different number types: save it with one type"},
      {"uint.exr", "stores uint numbers: save it with 8 or 16 bits, or floats of 16, 32 or 64"},
      {"signed.tif", "stores 16-bit int16 numbers: save it with 8 or 16 bits, or floats of 16, 32 or 64"},
      {"12_bits.tif", "stores 12-bit uint16 numbers: save it with 8 or 16 bits, or floats of 16, 32 or 64"},
      {"ycbcr.tif", "stores its colors as other than R, G, B, by a palette, say: save it as RGB"},
      {"deep.exr", "is a deep image: save it flat"},
      {"parts.exr", "holds several images: save one alone"},
      {"pages.tif", "holds several images: save one alone"},
      {"texture.exr", "is a texture with several resolutions: save it as a plain image"},
      {"crop.exr", "is a part of a larger image, or reaches beyond it: save the whole image and no more"},
      {"overscan.exr", "is a part of a larger image, or reaches beyond it: save the whole image and no more"},
      {"offset.tif", "is a part of a larger image, or reaches beyond it: save the whole image and no more"},
      {"turned.tif", "is stored turned or mirrored (tag Orientation): save it upright"},
  };
  for (const Refused& refused : cases) {
    INFO(refused.file);
    CHECK(refusal(fixture(refused.file)) == refused.reason);
  }
}

TEST_CASE("image: a PPM counts to 255", "[image]") {
  const TemporaryFolder folder;
  for (const int maximum : {0, 1, 100, 1023, 65535}) {
    const std::string number = std::to_string(maximum);
    CHECK(refusal(folder.write("a.ppm", "P3 1 1 " + number + "\n0 0 0\n")) ==
          "is a PPM with the maximum " + number + ": save it with the maximum 255");
  }
  std::string levels = "P3\n256 1\n255\n";
  for (int level = 0; level < 256; ++level) levels += "0 " + std::to_string(level) + " 0\n";
  const Image image = read_image(folder.write("a.ppm", levels)).image;
  REQUIRE(image.width == 256);
  for (int level = 0; level < 256; ++level) CHECK(image.at(level, 0) == Color(0, level / 255.0, 0));
  for (const char* text : {"P3", "P3 1 x", "P3 1 1", "P3 # 1 1 255"})
    CHECK(refusal(folder.write("a.ppm", text)) == "is a PPM whose header is truncated or damaged: make or copy it again");
  CHECK(refusal(folder.write("a.ppm", "P3 1 1 255\n1 2")).starts_with("is truncated or damaged"));
}

TEST_CASE("image: a TIFF of 64-bit floats that OpenImageIO would read as zeros is refused", "[image]") {
  const TemporaryFolder folder;
  const std::string reason =
      "is a TIFF of 64-bit floats in tiles or in one row, which is not read: save it as 32-bit floats";
  write_image(folder / "row.tif", Image(7, 1, Color(0.5)));
  CHECK(refusal(folder / "row.tif") == reason);
  CHECK(refusal(fixture("tiles64.tif")) == reason);
  write_image(folder / "rows.tif", Image(7, 2, Color(0.5)));
  CHECK(read_image(folder / "rows.tif").image.pixels == std::vector<Color>(14, Color(0.5)));
  for (const int height : {256, 257, 258, 513}) {  // about the bands of rows in which files are read
    write_image(folder / "rows.tif", Image(3, height, Color(0.1, 0.2, 0.3)));
    const std::vector<Color> expected(3 * static_cast<std::size_t>(height), Color(0.1, 0.2, 0.3));
    CHECK((read_image(folder / "rows.tif").image.pixels == expected));
  }
}

TEST_CASE("image: a truncated file is refused, or has lost nothing of its picture", "[image]") {
  const TemporaryFolder folder;
  // OpenImageIO alone fills up the missing part of a TIFF or a JPEG, and tells of success.
  for (const std::string name : {"a.png", "a.exr", "a.tif", "a.jpg", "a.bmp", "a.ppm"}) {
    write_image(folder / name, name == "a.jpg" ? Image(16, 16, Color(0.5)) : picture());
    const std::string whole = bytes_of(folder / name);
    const Image image = read_image(folder / name).image;
    const std::size_t step = whole.size() < 250 ? 1 : 7;
    for (std::size_t size = 1; size < whole.size(); size += size + step < whole.size() ? step : 1) {
      INFO(name << " cut to " << size << " of " << whole.size() << " bytes");
      const std::string reason = refusal(folder.write("cut", whole.substr(0, size)));
      if (reason.empty())  // a TIFF may end with its date
        CHECK(((name == "a.tif") && read_image(folder / "cut").image.pixels == image.pixels));
      else
        CHECK((reason.find("truncated or damaged") != std::string::npos || reason.starts_with("is not an image") ||
               reason.starts_with("is a PPM with the maximum 2")));
    }
  }
}

TEST_CASE("image: a TIFF that lacks all of many rows is refused at the first of them", "[image]") {
  const TemporaryFolder folder;
  const std::string whole = bytes_of(fixture("planes.tif"));
  const std::string height_entry = std::string("\x01\x01\x03\x00", 4) + little_endian(1);  // tag 257, a short, one
  const std::size_t height = whole.find(height_entry) + height_entry.size();
  // OpenImageIO would collect a message for each row of each channel, and stop the program after 16 MB.
  CHECK(
      refusal(folder.write("a.tif", replaced(whole, height, little_endian(65285)))).starts_with("is truncated or damaged"));
}

TEST_CASE("image: a JPEG that ends in or after its header is refused", "[image]") {
  const TemporaryFolder folder;
  write_image(folder / "a.jpg", picture());
  const std::string whole = bytes_of(folder / "a.jpg");
  const std::size_t scan = whole.find("\xff\xda");
  REQUIRE(scan != std::string::npos);
  for (std::size_t size = scan; size < scan + 30; ++size)
    CHECK(refusal(folder.write("cut", whole.substr(0, size))).starts_with("is truncated or damaged"));
}

TEST_CASE("image: a PNG with any damaged byte is refused", "[image]") {
  const TemporaryFolder folder;
  for (const char* name : {"gamma.png", "palette.png", "interlaced.png"}) {
    const std::string whole = bytes_of(fixture(name));
    for (std::size_t at = 0; at < whole.size(); ++at) {
      INFO(name << " with a wrong byte " << at);
      CHECK_FALSE(refusal(folder.write("damaged", replaced(whole, at, {static_cast<char>(whole[at] ^ 0x10)}))).empty());
    }
  }
  const std::string whole = bytes_of(fixture("gamma.png"));
  CHECK(refusal(folder.write("damaged", replaced(whole, 20, "x"))) ==
        "is a PNG that is truncated or damaged (the checksum of "
        "its part IHDR is wrong): make or copy it again");
  CHECK(refusal(folder.write("damaged", whole.substr(0, png_header_end) + whole.substr(8))) ==
        "is a PNG that is truncated or damaged (it has two headers): make or copy it again");
  CHECK(refusal(folder.write("damaged", whole.substr(0, 8) + whole.substr(png_header_end))) ==
        "is a PNG that is truncated or damaged (its header is missing): make or copy it again");
}

TEST_CASE("image: a header that promises too much is refused before memory is spent", "[image]") {
  const TemporaryFolder folder;
  const std::string rest = bytes_of(fixture("gamma.png")).substr(png_header_end);
  const auto too_large = [](const std::string& size) {
    return "is too large, " + size + " pixels: read are up to 33554432 pixels of 3 channels, and 65536 in a row or column";
  };
  CHECK(refusal(folder.write("a.png", png_header(65535, 65535) + rest)) == too_large("65535 x 65535"));
  CHECK(refusal(folder.write("a.png", png_header(0x7FFFFFFF, 1) + rest)) == too_large("2147483647 x 1"));
  CHECK(refusal(folder.write("a.png", png_header(1, 65537) + rest)) == too_large("1 x 65537"));
  CHECK(refusal(folder.write("a.png", png_header(0, 5) + rest)) == "has no pixels: make it again");
  CHECK(refusal(folder.write("a.ppm", "P6 70000 70000 255\nabc")) == too_large("70000 x 70000"));
  CHECK(refusal(folder.write("a.ppm", "P6 0 1 255\nabc")) == "has no pixels: make it again");
  CHECK(refusal(folder.write("a.ppm", "P6 -5 -5 255\nabc")) == "has no pixels: make it again");

  write_image(folder / "a.bmp", picture());
  const std::string bmp = replaced(bytes_of(folder / "a.bmp"), 18, little_endian(60000) + little_endian(60000));
  CHECK(refusal(folder.write("b.bmp", bmp)) == too_large("60000 x 60000"));

  write_image(folder / "a.exr", picture());
  std::string exr = bytes_of(folder / "a.exr");
  for (const std::string window : {"dataWindow", "displayWindow"}) {
    const std::size_t corner = exr.find(window) + window.size() + 1 + 6 + 4 + 8;  // after "box2i", the length, the least
    exr = replaced(exr, corner, little_endian(39999999));
  }
  CHECK(refusal(folder.write("b.exr", exr)) == too_large("40000000 x 5"));

  const std::string tif = bytes_of(fixture("16_bits.tif"));
  const std::string width_entry = std::string("\x00\x01\x03\x00", 4) + little_endian(1);  // tag 256, a short, one
  const std::size_t width = tif.find(width_entry) + width_entry.size();
  constexpr std::size_t height = 12;  // the next entry's
  const std::string huge = replaced(replaced(tif, width, little_endian(60000)), width + height, little_endian(60000));
  // OpenImageIO comes first, with a limit of its own.
  CHECK(refusal(folder.write("b.tif", huge)) ==
        "is too large: read are up to 33554432 pixels of 3 channels, and 65536 in a row or column");
}

TEST_CASE("image: an EXR's attribute that is longer than the file is refused before memory is spent", "[image]") {
  const TemporaryFolder folder;
  const std::string whole = bytes_of(fixture("half.exr"));
  const std::size_t length = whole.find("string") + 7;
  for (const std::uint32_t promised : {0x7B7B7B7BU, 0x7FFFFFFFU, 0xFFFFFFFFU, 1000U})
    CHECK(refusal(folder.write("a.exr", replaced(whole, length, little_endian(promised)))) ==
          "is an EXR whose header is truncated or damaged: make or copy it again");
  const std::string parts = bytes_of(fixture("parts.exr"));
  const std::size_t of_second = parts.rfind("string") + 7;
  CHECK(refusal(folder.write("a.exr", replaced(parts, of_second, little_endian(0x7B7B7B7BU)))) ==
        "is an EXR whose header is truncated or damaged: make or copy it again");
  for (const char* type : {"chlist", "box2i", "float"}) {  // OpenEXR does not look at the length of these
    const std::size_t place = whole.find(type) + std::string_view(type).size() + 1;
    const std::string longer = little_endian(static_cast<unsigned char>(whole[place]) + 1U);
    CHECK(refusal(folder.write("a.exr", replaced(whole, place, longer))) ==
          "is an EXR whose header is truncated or damaged: make or copy it again");
  }
}

TEST_CASE("image: an EXR of unknown number types is refused", "[image]") {
  const TemporaryFolder folder;
  const std::string whole = bytes_of(fixture("half.exr"));
  const std::size_t type_of_blue = whole.find("chlist") + 7 + 4 + 2;  // after the length and the name
  CHECK(refusal(folder.write("a.exr", replaced(whole, type_of_blue, little_endian(3)))) ==
        "is an EXR whose header is truncated or damaged: make or copy it again");
}

TEST_CASE("image: texts and profiles of a PNG are not unpacked without end", "[image]") {
  const TemporaryFolder folder;
  const std::string whole = bytes_of(fixture("gamma.png"));
  const auto with = [&](const std::string& part) {
    return folder.write("a.png", whole.substr(0, png_header_end) + part + whole.substr(png_header_end));
  };
  using namespace std::string_literals;
  const std::string small = "k\0"s + std::string(100000, 'a');
  CHECK(refusal(with(png_part("tEXt", small))).empty());
  CHECK(refusal(with(png_part("tEXt", small) + png_part("tEXt", small) + png_part("tEXt", small))) ==
        "holds more than 256 KiB of text and profiles: save it without metadata");
}
