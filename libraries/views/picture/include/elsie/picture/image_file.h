// Camera pictures as files.
#pragma once

#include <filesystem>
#include <string>

#include "elsie/api/image.h"

namespace elsie::picture {

/// Writes an image with one channel (grey) or three (red, green, blue) as a PNG file, pixel by
/// pixel. The same image gives the same bytes.
///
/// Throws std::invalid_argument for an image that is empty, has another number of channels, or the
/// wrong number of bytes for its size; std::runtime_error when the file cannot be written; an
/// existing file is then unchanged.
void write_png(const Image& image, const std::filesystem::path& file);

/// The bytes of this file. Throws std::invalid_argument likewise.
std::string png(const Image& image);

}  // namespace elsie::picture
