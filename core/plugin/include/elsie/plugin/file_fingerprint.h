// Detects whether a file has changed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include <sys/stat.h>

namespace elsie::plugin {

/// Differs when a file was replaced or written to.
struct Fingerprint {
  dev_t device = 0;
  ino_t inode = 0;
  off_t size = 0;
  std::int64_t changed_ns = 0;  // last change of its content, since 1970

  friend bool operator==(const Fingerprint&, const Fingerprint&) = default;
};

/// None when there is no such file.
inline std::optional<Fingerprint> fingerprint_of(const std::filesystem::path& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return Fingerprint{status.st_dev, status.st_ino, status.st_size,
                     std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec};
}

}  // namespace elsie::plugin
