// Picture files: their type by suffix, their size, and writing them in one piece.
#pragma once

#include <filesystem>
#include <string>

#include "elsie/picture/size.h"

namespace elsie::picture {

enum class FileType { png, svg, pdf, page };  // page: an SVG inside of an HTML page

/// Throws std::invalid_argument for a suffix other than .png, .svg and .pdf, in any case of
/// letters.
FileType file_type(const std::filesystem::path& file);

/// Throws std::invalid_argument for a size out of range.
void check_size(const Size& size);

/// files::write_whole(). Throws std::runtime_error with file and reason.
void write_whole(const std::filesystem::path& file, const std::string& content);

}  // namespace elsie::picture
