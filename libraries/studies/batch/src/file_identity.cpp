#include "file_identity.h"

#include <system_error>

#include <sys/stat.h>

namespace elsie::batch {
namespace {

FileIdentity identity(const struct stat& status) { return {status.st_dev, status.st_ino}; }

}  // namespace

std::optional<FileIdentity> FileIdentity::of(const std::filesystem::path& file) {
  struct stat status {};
  return stat(file.c_str(), &status) == 0 ? std::optional(identity(status)) : std::nullopt;
}

std::optional<FileIdentity> FileIdentity::of(int descriptor) {
  struct stat status {};
  return fstat(descriptor, &status) == 0 ? std::optional(identity(status)) : std::nullopt;
}

std::optional<std::filesystem::path> name_of_open_file(const FileIdentity& file) {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", error)) {
    if (FileIdentity::of(entry.path()) != file) {
      continue;
    }
    const auto name = std::filesystem::read_symlink(entry.path(), error);
    if (!error &&
        FileIdentity::of(name) == file) {  // the name of a removed file ends in " (deleted)"
      return name;
    }
  }
  return std::nullopt;
}

}  // namespace elsie::batch
