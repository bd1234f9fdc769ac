// A copy of a library that nobody else writes to.
#pragma once

#include <filesystem>
#include <string>

#include "elsie/base/emergency.h"

namespace elsie::plugin {

/// A library that is in memory must not be overwritten, and the system takes a file of a path that
/// it knows for the one that it has loaded. So a library that may be replaced is loaded from a copy
/// of its own, in a folder of its own, which goes with this object. Those of processes that were
/// killed are removed by the first copy of a later one, of the same user.
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
