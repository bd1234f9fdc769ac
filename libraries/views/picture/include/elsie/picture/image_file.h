// Pictures of cameras as files.
#pragma once

#include <filesystem>
#include <string>

#include "elsie/api/image.h"

namespace elsie::picture {

/// Writes an image of one channel (grey) or three (red, green, blue) as a PNG file, pixel by pixel.
/// The same image gives the same bytes.
///
/// Throws std::invalid_argument for an image that is empty, has another number of channels, or has
/// more or fewer bytes than its size says; std::runtime_error when the file cannot be written. An
/// existing file is unchanged then.
void write_png(const Image& image, const std::filesystem::path& file);

/// The bytes of the same file. Throws std::invalid_argument likewise.
std::string png(const Image& image);

}  // namespace elsie::picture
