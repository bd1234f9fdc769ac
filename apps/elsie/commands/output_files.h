// Checks of the files that a subcommand will write, before any work is done.
#pragma once

#include <filesystem>

#include "elsie/files/outputs.h"

namespace elsie::program {

/// Throws BadInput when a file's name is not that of a database of results.
void require_database_name(const std::filesystem::path& file, const char* option);

using files::require_writable;
/// files::require_replaceable() for a file that must begin like one of its suffix.
void require_replaceable(const std::filesystem::path& file, const char* option, const char* kind);
/// The same for a picture: its name must end in .png or .svg.
void require_picture(const std::filesystem::path& file, const char* option);

}  // namespace elsie::program
