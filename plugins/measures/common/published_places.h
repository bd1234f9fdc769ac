// Where numbers are that plugins publish.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <elsie/api/measure.h>

/// The place of a number among those of a robot or of the world.
struct PublishedPlace {
  static constexpr auto kWorld = std::numeric_limits<std::size_t>::max();  // no robot

  std::size_t robot = kWorld;
  std::size_t number = 0;

  /// NaN while it is not there.
  double value(const elsie::Observation& now) const {
    const auto* const numbers = robot == kWorld ? now.numbers : now.robots[robot].numbers;
    return numbers->now()[number];
  }
};

/// Adds the places of the numbers with this name to `places`, and the names of all others, each
/// once, to `others`. `robot`: PublishedPlace::kWorld for numbers of the world. `name_of`: gives
/// the name of an ObservedNumber; "" leaves it out.
template <class NameOf>
void find_published(const elsie::Observation& start, std::size_t robot, const std::string& name,
                    const NameOf& name_of, std::vector<PublishedPlace>& places,
                    std::vector<std::string>& others) {
  const std::span<const elsie::ObservedNumber> published =
      robot == PublishedPlace::kWorld ? start.published : start.robots[robot].published;
  for (std::size_t k = 0; k < published.size(); ++k) {
    std::string found = name_of(published[k]);
    if (found == name) {
      places.push_back({robot, k});
    } else if (!found.empty() && std::find(others.begin(), others.end(), found) == others.end()) {
      others.push_back(std::move(found));
    }
  }
}
