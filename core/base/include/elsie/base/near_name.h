// "Did you mean ...?": the nearest of the right names to a wrong one.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace elsie::base {

/// The candidate that is nearest to `name`, the first of several at the same distance. Distance is
/// the number of letters added, missing, wrong, or swapped with a neighbour (Damerau, 1964); it may
/// be at most one for every three letters. Case is ignored. If no candidate is near, the first that
/// begins with `name`.
std::optional<std::string_view> nearest_name(std::string_view name,
                                             std::span<const std::string_view> candidates);

/// "; did you mean 'speed'?" for the end of a sentence, or "". `candidates` is a range of strings
/// or string views.
template <class Range>
std::string did_you_mean(std::string_view name, const Range& candidates) {
  std::vector<std::string_view> views;
  for (const auto& candidate : candidates) {
    views.emplace_back(candidate);
  }
  const auto nearest = nearest_name(name, views);
  return nearest ? "; did you mean '" + std::string(*nearest) + "'?" : std::string();
}

/// did_you_mean() if a name is near, else all names: "; it may have: x, y" if `before_all` is "it
/// may have"; "" without names.
std::string near_or_all(const std::string& wrong, const std::vector<std::string>& names,
                        const std::string& before_all);

}  // namespace elsie::base
