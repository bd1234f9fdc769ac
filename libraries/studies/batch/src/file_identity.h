// Whether the file of a name is still the one that it was.
#pragma once

#include <filesystem>
#include <optional>

#include <sys/types.h>

namespace elsie::batch {

/// What stays the same when a file is renamed or written to.
struct FileIdentity {
  dev_t device = 0;
  ino_t inode = 0;

  /// None: there is no such file.
  static std::optional<FileIdentity> of(const std::filesystem::path& file);
  static std::optional<FileIdentity> of(int descriptor);

  friend bool operator==(const FileIdentity&, const FileIdentity&) = default;
};

/// The name by which a file that this process has open is found now; none: it was removed, or is
/// not open.
std::optional<std::filesystem::path> name_of_open_file(const FileIdentity& file);

}  // namespace elsie::batch
