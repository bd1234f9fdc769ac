// Detects files that change while they are read.
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

/// Distinguishes contents; no protection against forgery.
class Hash {
 public:
  Hash& add(std::string_view bytes);
  std::string text() const;

 private:
  base::Fnv1a hash_;
};

/// None when the file cannot be read.
std::optional<std::string> content_of(const std::filesystem::path& file);

/// The state of a file when it was read.
struct Seen {
  std::string hash;                    // of its content; of nothing when it cannot be read
  std::int64_t status_changed_ns = 0;  // when it was last written to, renamed or replaced, by the
                                       // clock of its file system; 0 when there is no such file

  friend bool operator==(const Seen&, const Seen&) = default;
};
using Sight = std::map<std::filesystem::path, Seen>;

Sight look_at(const std::vector<std::filesystem::path>& files);

/// A file that changed between the two sights, or, if the first does not have it, after the instant
/// `start_ns`; none when there is no such file.
std::optional<std::filesystem::path> changed_file(const Sight& before, const Sight& after,
                                                  std::int64_t start_ns);

/// An instant of the file system's clock before now: files written from now on are later. Waits for
/// the clock's step of some milliseconds; if its steps are longer, files written just before count
/// as later, too. Writes to the scratch file.
std::int64_t instant_before_now(const std::filesystem::path& scratch);

}  // namespace elsie::build
