// Files that are written whole or not at all.
#pragma once

#include <filesystem>
#include <string_view>

namespace elsie::files {

enum class Durable { no, yes };

/// Writes a new file in the same folder and then renames it, so that a reader sees the old content
/// or all of the new one. An existing file keeps its permissions, even if they forbid writing; the
/// user's mask applies to a new one. A symbolic link stays: the file that it points to is written.
/// A device or a pipe is written in place, and so is a file in a folder without write permission.
///
/// `durable`: the content is on the disk before the file is renamed. Returns zero or errno; after
/// an error the file has its old content, and no other file is left.
int write_whole(const std::filesystem::path& file, std::string_view content,
                Durable durable = Durable::no);

/// The same; throws base::Error with file and reason.
void write_whole_or_throw(const std::filesystem::path& file, std::string_view content,
                          Durable durable = Durable::no);

/// write(2), to the end: writes all bytes to a descriptor. Returns zero or errno. Signal handlers
/// may use it.
int write_all(int descriptor, std::string_view bytes) noexcept;

/// The end of a chain of symbolic links, whether it exists or not. Returns `file` itself when it is
/// not a link, or when the links form a circle.
std::filesystem::path end_of_links(std::filesystem::path file);

}  // namespace elsie::files
