// A new file that takes the place of another one once it is whole.
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <string_view>

#include <sys/types.h>

#include "elsie/files/emergency.h"
#include "elsie/files/write_whole.h"

namespace elsie::files {

/// The new file is in the same folder. It is removed unless it has replaced the old one, also when
/// the process is interrupted. Until then, its mode gives others no more than that of the old one.
class Replacement final : private EmergencyWriter {
 public:
  /// `file`: no link; end_of_links() leads to it. error() says whether the new file is there.
  explicit Replacement(std::filesystem::path file);
  ~Replacement() override;
  Replacement& operator=(const Replacement&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Zero, or the errno of the first call that failed.
  int error() const { return error_; }
  /// Writes all of the content, once; instead, another program may write into path(). Returns
  /// error().
  int write(std::string_view content, Durable durable);
  /// Renames the new file, with the permissions of the old one, even if they forbid writing; the
  /// user's mask applies if there was none. Where permissions cannot be set, as on some mounted
  /// disks, it keeps those of a new file. Returns error().
  int replace();

 private:
  void clean_up_now() noexcept override;

  const std::filesystem::path file_;
  std::filesystem::path path_;
  std::optional<mode_t> mode_;  // of the old file
  int descriptor_ = -1;
  int error_ = 0;
  std::atomic<bool> is_there_{false};
};

}  // namespace elsie::files
