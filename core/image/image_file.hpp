#pragma once

#include "core/image/image.hpp"

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

/// Reads an image of three channels, as numbers from 0 to 1. Throws std::runtime_error with the reason if that fails.
Image read_image(const std::filesystem::path& path);

}  // namespace raylab
