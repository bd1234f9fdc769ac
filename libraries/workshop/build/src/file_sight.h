// Files as they are read, so that it is noticed when one changes meanwhile.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/base/fnv1a.h"

namespace elsie::build {

/// Tells contents apart; does not guard them against forgery.
class Hash {
 public:
  Hash& add(std::string_view bytes);
  std::string text() const;

 private:
  base::Fnv1a hash_;
};

/// None when the file cannot be read.
std::optional<std::string> content_of(const std::filesystem::path& file);

/// A file as it was when it was looked at.
struct Seen {
  std::string hash;                    // of its content; of nothing when it cannot be read
  std::int64_t status_changed_ns = 0;  // when it was last written to, renamed or replaced, by the
                                       // clock of its file system; 0 when there is no such file

  friend bool operator==(const Seen&, const Seen&) = default;
};
using Sight = std::map<std::filesystem::path, Seen>;

Sight look_at(const std::vector<std::filesystem::path>& files);

/// A file that is no longer as it was before, or, where it was not looked at before, one that was
/// changed after the instant `start_ns`; none when there is no such file.
std::optional<std::filesystem::path> changed_file(const Sight& before, const Sight& after,
                                                  std::int64_t start_ns);

/// An instant of the file system's clock that is over: files that are written from now on are
/// later. The clock goes in steps of some milliseconds, which this waits for; where they are
/// longer, files that were written just before count as later too. Writes to the scratch file.
std::int64_t instant_before_now(const std::filesystem::path& scratch);

}  // namespace elsie::build
