#include "elsie/base/near_name.h"

#include <algorithm>
#include <cctype>
#include <cstddef>

#include "elsie/base/words.h"

namespace elsie::base {
namespace {

std::string folded(std::string_view name) {
  std::string result(name);
  for (char& c : result) {
    c = c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return result;
}

/// Optimal string alignment distance: Damerau's distance where no letter is edited twice.
std::size_t distance(std::string_view a, std::string_view b) {
  const std::size_t columns = b.size() + 1;
  std::vector<std::size_t> table((a.size() + 1) * columns);
  const auto at = [&](std::size_t i, std::size_t j) -> std::size_t& {
    return table[i * columns + j];
  };
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        at(i, j) = i + j;
        continue;
      }
      const std::size_t wrong = a[i - 1] == b[j - 1] ? 0 : 1;
      at(i, j) = std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, at(i - 1, j - 1) + wrong});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
      }
    }
  }
  return at(a.size(), b.size());
}

constexpr std::size_t kLongestName = 100;  // longer texts are not misspelled names

}  // namespace

std::optional<std::string_view> nearest_name(std::string_view name,
                                             std::span<const std::string_view> candidates) {
  if (name.empty() || name.size() > kLongestName) return std::nullopt;
  const std::string wanted = folded(name);
  std::optional<std::string_view> nearest;
  std::size_t limit = std::max<std::size_t>(1, wanted.size() / 3) + 1;
  for (const std::string_view candidate : candidates) {
    if (candidate.empty() || candidate.size() > kLongestName) continue;
    const std::size_t here = distance(wanted, folded(candidate));
    // If every letter changed, the two names have nothing in common.
    if (here < limit && here < std::max(wanted.size(), candidate.size())) {
      nearest = candidate;
      limit = here;
    }
  }
  if (!nearest && wanted.size() >= 3) {
    const auto begun = std::find_if(
        candidates.begin(), candidates.end(),
        [&](std::string_view candidate) { return folded(candidate).starts_with(wanted); });
    if (begun != candidates.end()) {
      nearest = *begun;
    }
  }
  return nearest;
}

std::string near_or_all(const std::string& wrong, const std::vector<std::string>& names,
                        const std::string& before_all) {
  const std::string near = did_you_mean(wrong, names);
  return !near.empty() || names.empty() ? near : "; " + before_all + ": " + listed(names);
}

}  // namespace elsie::base
