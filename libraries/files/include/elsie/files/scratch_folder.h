// A folder for what is half done.
#pragma once

#include <filesystem>
#include <string>

#include "elsie/files/emergency.h"

namespace elsie::files {

/// A new, empty folder with a name of its own, so that two programs that work in the same place do
/// not collide. It is removed with all that is in it, also when the process crashes or is
/// interrupted.
class ScratchFolder final : private EmergencyWriter {
 public:
  /// Makes it in `parent`. The user's mask applies. Throws std::filesystem::filesystem_error.
  explicit ScratchFolder(const std::filesystem::path& parent);
  ~ScratchFolder() override;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// It becomes the folder `target`, which does not exist yet, with all that is in it. Throws
  /// std::filesystem::filesystem_error.
  void become(const std::filesystem::path& target);

 private:
  void clean_up_now() noexcept override;

  std::filesystem::path path_;
};

}  // namespace elsie::files
