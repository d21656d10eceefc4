#pragma once

#include <OpenImageIO/imageio.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace raylab {

/// Throws std::runtime_error "PATH: why", with what is not printable in `why` replaced: it may come from the file.
[[noreturn]] void refuse_image(const std::filesystem::path& path, std::string why);

/// Refuses an image of no pixels or of too many: up to 65536 in a row or column, 2^25 of three channels in all. `channels`
/// is 1 where not yet known.
void check_image_size(const std::filesystem::path& path, long long width, long long height, int channels);

/// Opens one flat image, of any number of channels, that nobody has vetted: a regular PNG, EXR, TIFF, JPEG, BMP or PNM file,
/// told by its first bytes and not by its name. No pixel has been decoded yet.
/// Throws std::runtime_error with the reason for anything else: among others for links, pipes and devices (it never waits),
/// several images, layers of depth or resolution in one file, a part of an image, and headers that promise too much.
std::unique_ptr<OIIO::ImageInput> open_image(const std::filesystem::path& path);

/// All numbers of an open image as stored: rows from the top, pixels from the left, channels in the order of its spec. Whole
/// numbers become fractions of the largest, 255 for 8 bits; floats of any size, and what is not a number, stay what they
/// are. Throws std::runtime_error if any of it is missing or damaged.
std::vector<double> read_numbers(OIIO::ImageInput& input, const std::filesystem::path& path);

}  // namespace raylab
