// Checks of the files that a subcommand will write, before any work is done.
#pragma once

#include <filesystem>

namespace elsie::program {

/// Throws BadInput when a file's name is not that of a database of results.
void require_database_name(const std::filesystem::path& file, const char* option);

/// Checks, before any work is done, that a file can be written there. Throws BadInput.
void require_writable(const std::filesystem::path& file, const char* option);
/// The same. A file that exists must also begin like a file of its suffix, so that a world, an
/// experiment or a database is not overwritten by mistake. `kind`: for messages, such as "picture".
void require_replaceable(const std::filesystem::path& file, const char* option, const char* kind);
/// The same for a recording: its name must have a suffix of recording::formats().
void require_recording(const std::filesystem::path& file, const char* option);
/// The same for a picture: its name must end in .png or .svg.
void require_picture(const std::filesystem::path& file, const char* option);

}  // namespace elsie::program
