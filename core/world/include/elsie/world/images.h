// Images in files: of floors, and of floor plans. What reads them is a library of its own,
// plugin::part_file("images"), loaded for worlds that name an image.
#pragma once

#include <cstddef>
#include <string>

#include "elsie/api/image.h"

namespace elsie::world {

/// The most pixels of an image.
inline constexpr std::size_t kMostPixels = 16'000'000;

/// Whether this begins like the content of a PNG or PGM file.
bool is_image(const std::string& content);

/// Reads the content of such a file. `channels`: 1 turns colours into greys, 3 greys into colours.
/// Transparent pixels become white. Throws std::runtime_error with the end of a sentence: "is no
/// whole PNG image: ...", and PluginError if the library cannot be loaded, which exports a function
/// of this type as `elsie_read_image`.
using ReadImage = Image(const std::string& content, int channels);
ReadImage read_image;

}  // namespace elsie::world
