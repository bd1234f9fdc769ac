// "Did you mean ...?": the nearest of the right names to a wrong one.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace elsie::base {

/// The candidate that `name` is most likely a slip of; the first one of several equally near. A
/// slip is a letter too many, missing, wrong, or swapped with its neighbour (Damerau, 1964), of
/// which a name may have one in three letters; a wrong case counts for nothing. Failing that, a
/// candidate that begins with `name`. None when nothing comes near.
std::optional<std::string_view> nearest_name(std::string_view name,
                                             std::span<const std::string_view> candidates);

/// "; did you mean 'speed'?", to be put at the end of a sentence, or nothing. `candidates` is a
/// range of strings or string views.
template <class Range>
std::string did_you_mean(std::string_view name, const Range& candidates) {
  std::vector<std::string_view> views;
  for (const auto& candidate : candidates) {
    views.emplace_back(candidate);
  }
  const auto nearest = nearest_name(name, views);
  return nearest ? "; did you mean '" + std::string(*nearest) + "'?" : std::string();
}

/// did_you_mean() when a name is near, else all of them: "; it may have: x, y" for "it may have";
/// nothing when there are none.
std::string near_or_all(const std::string& wrong, const std::vector<std::string>& names,
                        const std::string& before_all);

}  // namespace elsie::base
