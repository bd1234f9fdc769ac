// A lock that ends with the process that holds it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace elsie::batch {

/// A file next to the locked one, locked by flock(2) and removed by the destructor. A file that a
/// killed process left behind holds no lock.
class LockFile {
 public:
  /// "results.sqlite-lock" for "results.sqlite", also for a link to it.
  static std::filesystem::path path_for(const std::filesystem::path& file);

  /// Takes the lock. Throws DatabaseRefused if another process holds it, or the lock file cannot be
  /// created.
  explicit LockFile(const std::filesystem::path& locked);
  ~LockFile();
  LockFile(LockFile&& other) noexcept;
  LockFile& operator=(LockFile&&) = delete;

  /// The holder of a file's lock, "process 123 on host"; none if it is not locked.
  static std::optional<std::string> holder(const std::filesystem::path& locked);

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
};

}  // namespace elsie::batch
