// Checks whether a name still refers to the same file.
#pragma once

#include <filesystem>
#include <optional>

#include <sys/types.h>

namespace elsie::batch {

/// Stays the same when a file is renamed or written.
struct FileIdentity {
  dev_t device = 0;
  ino_t inode = 0;

  /// None if there is no such file.
  static std::optional<FileIdentity> of(const std::filesystem::path& file);
  static std::optional<FileIdentity> of(int descriptor);

  friend bool operator==(const FileIdentity&, const FileIdentity&) = default;
};

/// The current name of a file that this process has open; none if it was removed or is not open.
std::optional<std::filesystem::path> name_of_open_file(const FileIdentity& file);

}  // namespace elsie::batch
