#include "core/image/image_file.hpp"

#include "core/image/label.hpp"
#include "core/image/partial_file.hpp"
#include "core/image/terminal.hpp"
#include "tests/support.hpp"
#include "tests/temporary_folder.hpp"

using namespace raylab;
using namespace raylab::test;

namespace {

Image gradient() {
  Image image(7, 5);
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 7; ++x) image.at(x, y) = Color(x / 7.0, y / 5.0, (x + 7 * y) / 35.0);
  return image;
}

}  // namespace

TEST_CASE("image: 8 bits are floor(255 c + 1/2)", "[image]") {
  CHECK(quantise(0) == 0);
  CHECK(quantise(1) == 255);
  CHECK(quantise(0.49 / 255) == 0);
  CHECK(quantise(0.51 / 255) == 1);
  CHECK(quantise(0.49607843137254903) == 127);  // hard case A07: the double nearest 126.5/255
  CHECK(quantise(-3) == 0);
  CHECK(quantise(7) == 255);
  CHECK(quantise(std::nan("")) == 0);
}

TEST_CASE("image: a PNG holds the quantised values, and is tagged sRGB with no other gamma", "[image]") {
  const TemporaryFolder folder;
  const Image image = gradient();
  write_image(folder / "a.png", image);
  const Image read = read_image(folder / "a.png").image;
  REQUIRE(read.width == 7);
  REQUIRE(read.height == 5);
  for (std::size_t k = 0; k < image.pixels.size(); ++k)
    for (int c = 0; c < 3; ++c) CHECK(read.pixels[k][c] == within(1e-7, quantise(image.pixels[k][c]) / 255.0));

  const std::string png = bytes_of(folder / "a.png");
  CHECK(png.find("sRGB") != std::string::npos);
  const std::size_t gamma = png.find("gAMA");
  if (gamma != std::string::npos) CHECK(png.substr(gamma + 4, 4) == std::string("\x00\x00\xb1\x8f", 4));  // 1/2.2
}

TEST_CASE("image: an EXR holds floats in channels R, G, B", "[image]") {
  const TemporaryFolder folder;
  const Image image = gradient();
  write_image(folder / "a.exr", image);
  const Image read = read_image(folder / "a.exr").image;
  for (std::size_t k = 0; k < image.pixels.size(); ++k)
    for (int c = 0; c < 3; ++c) CHECK(read.pixels[k][c] == static_cast<double>(static_cast<float>(image.pixels[k][c])));
}

TEST_CASE("image: a TIFF holds doubles, bit for bit", "[image]") {
  const TemporaryFolder folder;
  const Image image = gradient();
  for (const char* name : {"a.tif", "a.tiff", "a.TIF"}) {
    write_image(folder / name, image);
    CHECK(read_image(folder / name).image.pixels == image.pixels);
  }
}

TEST_CASE("image: the same pixels give the same bytes", "[image]") {
  const TemporaryFolder folder;
  for (const char* name : {"time.tif", "time.exr"}) {
    write_image(folder / name, gradient());
    CHECK(bytes_of(folder / name).find("1970:01:01 00:00:00") != std::string::npos);  // in place of the present time
  }
  for (const std::string ending : {".png", ".exr", ".tif"}) {
    write_image(folder / ("a" + ending), gradient());
    write_image(folder / ("b" + ending), gradient());
    CHECK(bytes_of(folder / ("a" + ending)) == bytes_of(folder / ("b" + ending)));
  }
}

TEST_CASE("image: rows may come in bands", "[image]") {
  const TemporaryFolder folder;
  const Image image = gradient();
  ImageWriter writer(folder / "bands.tif", 7, 5);
  const std::span<const Color> pixels(image.pixels);
  writer.write_rows(0, pixels.subspan(0, 14));
  writer.write_rows(2, pixels.subspan(14, 21));
  writer.finish();
  CHECK(read_image(folder / "bands.tif").image.pixels == image.pixels);
}

TEST_CASE("image: a file appears whole or not at all", "[image]") {
  const TemporaryFolder folder;
  {
    ImageWriter writer(folder / "half.png", 7, 5);
    writer.write_rows(0, std::vector<Color>(7));
    CHECK_FALSE(std::filesystem::exists(folder / "half.png"));
  }
  CHECK(folder.files() == 0);
  write_image(folder / "kept.png", gradient());
  const std::string before = bytes_of(folder / "kept.png");
  { ImageWriter writer(folder / "kept.png", 7, 5); }
  CHECK(bytes_of(folder / "kept.png") == before);
  CHECK(folder.files() == 1);
}

TEST_CASE("image: a folder on the way is made", "[image]") {
  const TemporaryFolder folder;
  write_image(folder / "new" / "deep" / "a.png", gradient());
  CHECK(std::filesystem::exists(folder / "new" / "deep" / "a.png"));
}

TEST_CASE("image: what cannot be written says why", "[image]") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH(ImageWriter(folder / "a", 7, 5), ContainsSubstring("needs an ending"));
  CHECK_THROWS_WITH(ImageWriter(folder / "a.xyz", 7, 5), ContainsSubstring("'.xyz': use .png, .exr or .tif"));
  CHECK_THROWS_WITH(ImageWriter(folder / "a.txt", 7, 5), ContainsSubstring("use .png, .exr or .tif"));
  const std::string too_long(300, 'n');
  CHECK_THROWS_WITH(write_image(folder / (too_long + ".png"), gradient()), ContainsSubstring("cannot be written"));
  std::filesystem::create_directory(folder / "dir.png");
  CHECK_THROWS_WITH(ImageWriter(folder / "dir.png", 7, 5), ContainsSubstring("is a folder"));
  write_image(folder / "file.png", gradient());
  CHECK_THROWS_WITH(ImageWriter(folder / "file.png" / "a.png", 7, 5), ContainsSubstring("cannot make its folder"));
}

TEST_CASE("image: a name of any length that the system takes is written, and through a link its target", "[image]") {
  const TemporaryFolder folder;
  const std::string longest = std::string(251, 'n') + ".png";
  write_image(folder / longest, gradient());
  CHECK(std::filesystem::exists(folder / longest));
  std::filesystem::create_symlink("target.png", folder / "link.png");
  write_image(folder / "link.png", gradient());
  CHECK(std::filesystem::is_symlink(folder / "link.png"));
  CHECK(std::filesystem::is_regular_file(folder / "target.png"));
}

TEST_CASE("image: a text file is committed whole or removed", "[image]") {
  const TemporaryFolder folder;
  {
    PartialFile file(folder / "stats.json");
    std::ofstream(file.temporary()) << "{}";
  }
  CHECK(folder.files() == 0);
  PartialFile file(folder / "stats.json");
  std::ofstream(file.temporary()) << "{}";
  file.commit();
  CHECK(bytes_of(folder / "stats.json") == "{}");
}

TEST_CASE("image: the terminal shows two pixels in a character", "[image]") {
  Preview preview(2, 2, 80, 80);
  const std::vector<Color> pixels{Color(1, 0, 0), Color(0, 1, 0), Color(0, 0, 1), Color(1, 1, 1)};
  preview.add_rows(0, pixels);
  CHECK(preview.half_blocks() ==
        "\x1b[38;2;255;0;0m\x1b[48;2;0;0;255m\u2580\x1b[38;2;0;255;0m\x1b[48;2;255;255;255m\u2580\x1b[0m\n");
}

TEST_CASE("image: the terminal's copy is the mean of blocks, in the image's proportions", "[image]") {
  Preview preview(8, 4, 4, 80);  // 4 x 2
  std::vector<Color> row(8);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 8; ++x) row[static_cast<std::size_t>(x)] = Color(x % 2 == 0 ? 1 : 0);
    preview.add_rows(y, row);
  }
  const std::string block = "\x1b[38;2;128;128;128m\x1b[48;2;128;128;128m\u2580";
  CHECK(preview.half_blocks() == block + block + block + block + "\x1b[0m\n");
}

TEST_CASE("image: a label is drawn where it should be, and cut off at the edge", "[image]") {
  Image image(20, 12);
  draw_label(image, 2, 2, "I", Color(1), 1);  // a bar with serifs: its middle column is full
  for (int y = 2; y < 9; ++y) CHECK(image.at(4, y) == Color(1));
  CHECK(image.at(4, 1) == Color(0));
  CHECK(image.at(1, 2) == Color(0));
  draw_label(image, 15, 8, "WWW", Color(1), 3);  // writes nothing outside, says the sanitizer
}
