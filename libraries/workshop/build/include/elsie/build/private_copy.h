// A private copy of a library.
#pragma once

#include <filesystem>
#include <string>

#include "elsie/base/emergency.h"

namespace elsie::plugin {

/// A loaded library must not be overwritten, and the system does not load a file again whose path
/// it knows. So a library that may be replaced is loaded from a copy in a folder of its own, which
/// this object removes. The first copy of a process removes the copies of killed processes of this
/// user.
class PrivateCopy final : private base::EmergencyWriter {
 public:
  /// Throws std::runtime_error with a sentence.
  explicit PrivateCopy(const std::filesystem::path& file);
  ~PrivateCopy() override;

  std::filesystem::path path() const { return file_; }

 private:
  void clean_up_now() noexcept override;

  std::string folder_;
  std::string file_;
};

}  // namespace elsie::plugin
