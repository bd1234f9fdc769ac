// Files that are written whole or not at all.
#pragma once

#include <filesystem>
#include <string_view>

namespace elsie::base {

enum class Durable { no, yes };

/// Writes into a new file beside `file`, then gives it that name: whoever reads it meanwhile sees
/// what was there before or all of the content. A symbolic link stays one: what it points to is
/// written. What is no regular file (a device, a pipe) is written to as it is, and so is a file in
/// a folder that takes no new ones.
///
/// `durable`: the content is on the disk before it takes the place of another one. Zero, or the
/// error number (errno) of what went wrong; then the file is as it was, and nothing is left over.
int write_whole(const std::filesystem::path& file, std::string_view content,
                Durable durable = Durable::no);

/// What a symbolic link points to, by whatever number of links, there or not; the file itself when
/// it is none. A circle of links is left as it is.
std::filesystem::path end_of_links(std::filesystem::path file);

}  // namespace elsie::base
