// A lock that goes with the process that holds it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace elsie::batch {

/// A file beside another one, locked by flock(2). Removed in the end; one that a killed process has
/// left behind does not count.
class LockFile {
 public:
  /// "results.sqlite-lock" for "results.sqlite", and for a link to it.
  static std::filesystem::path beside(const std::filesystem::path& file);

  /// Takes the lock. Throws DatabaseRefused when another process has it, or the lock file cannot be
  /// made.
  explicit LockFile(const std::filesystem::path& locked);
  ~LockFile();
  LockFile(LockFile&& other) noexcept;
  LockFile& operator=(LockFile&&) = delete;

  /// Who holds the lock of a file: "process 123 on host"; none: nobody.
  static std::optional<std::string> holder(const std::filesystem::path& locked);

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
};

}  // namespace elsie::batch
