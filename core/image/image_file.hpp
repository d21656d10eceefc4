#pragma once

#include "core/image/image.hpp"
#include "core/image/number_format.hpp"
#include "core/scene/scene.hpp"

#include <filesystem>
#include <memory>
#include <span>

namespace raylab {

/// An 8-bit value for a color component from 0 to 1: floor(255 c + 1/2), no transfer curve (docs/model.md, D19).
unsigned char quantise(double component);

/// Writes an image file row by row. The file appears under its name whole, at finish(), or not at all.
///
/// .exr: channels R, G, B as 32-bit floats. .tif, .tiff: 64-bit floats. All others, .png first of all: 8 bits by quantise(),
/// tagged sRGB so that viewers show the values as they are.
class ImageWriter {
 public:
  /// Makes the folder if it is missing, and a temporary file in it.
  /// Throws std::runtime_error, with the reason, if the format is not known or the place cannot be written.
  ImageWriter(const std::filesystem::path& path, int width, int height);
  ~ImageWriter();
  ImageWriter(const ImageWriter&) = delete;
  ImageWriter& operator=(const ImageWriter&) = delete;

  /// The next rows from the top, whole ones. Throws std::runtime_error if they cannot be written (a full disk, say).
  void write_rows(int first_row, std::span<const Color> pixels);

  /// Completes the file and gives it its name. Throws std::runtime_error if that fails.
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Writes a whole image, as ImageWriter does.
void write_image(const std::filesystem::path& path, const Image& image);

/// An image from a file, and how the file stores its components.
struct ImageFile {
  Image image;
  NumberFormat format = NumberFormat::uint8;
};

/// Reads an image of the channels R, G, B from any file, vetted or not. The numbers are as stored, with no transfer curve
/// taken off or put on (docs/model.md, D19): whole numbers as fractions of the largest, floats as they are, finite or not.
/// Throws std::runtime_error, "PATH: what is wrong: what to do", if that cannot be done in full; it never waits.
ImageFile read_image(const std::filesystem::path& path);

/// The size that such a file's header tells, with no pixel decoded. Throws as read_image() does.
ImageSize image_size(const std::filesystem::path& path);

}  // namespace raylab
