// Folders whose content only this user and root can change.
#pragma once

#include <filesystem>

namespace elsie::build {

/// What a folder is for, and the variable of the environment that names another; for messages.
struct FolderUse {
  const char* content;
  const char* variable;
};
inline constexpr FolderUse kCompiledPlugins{"compiled plugins", "ELSIE_CACHE"};
inline constexpr FolderUse kCopiesOfPlugins{"copies of plugins", "TMPDIR"};

/// Makes the folder and those above it that are missing, for this user only (mode 0700). Returns
/// its full path without symbolic links. Throws plugin::PluginError with a sentence when it cannot
/// be made, and when another user could put files into it or replace it.
///
/// Files are named and loaded by their paths, and a path that was checked is safe only if nobody
/// can change it between check and use. Therefore every folder on the path, and every link, has to
/// belong to this user or root, and no one else may write to it; a folder above with the sticky bit
/// (such as /tmp) may be written by others, as they cannot rename what is in it.
std::filesystem::path own_folder(const std::filesystem::path& folder, const FolderUse& use);

/// Whether this is a regular file, not a link, of this user or root.
bool is_own_file(const std::filesystem::path& file);

}  // namespace elsie::build
