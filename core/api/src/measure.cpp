#include "elsie/api/measure.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace elsie {
namespace {

/// "; there are 'r1', 'r2' and 3 more".
template <class Range, class IdOf>
std::string those_there(const Range& range, IdOf id_of) {
  constexpr std::size_t kMost = 12;
  if (range.empty()) return "; there is none";
  std::string text = range.size() == 1 ? "; there is " : "; there are ";
  for (std::size_t i = 0; i < std::min(range.size(), kMost); ++i) {
    text.append(i == 0 ? "'" : ", '").append(id_of(range[i])).append("'");
  }
  return range.size() <= kMost ? text
                               : text + " and " + std::to_string(range.size() - kMost) + " more";
}

}  // namespace

const char* to_string(RunEnd::Outcome outcome) {
  switch (outcome) {
    case RunEnd::Outcome::success:
      return "success";
    case RunEnd::Outcome::failure:
      return "failure";
    case RunEnd::Outcome::time_limit:
      return "time_limit";
    case RunEnd::Outcome::running:
      break;
  }
  return "running";
}

const ObservedBehavior* ObservedRobot::behavior(std::string_view path) const {
  const auto found =
      std::find_if(behaviors.begin(), behaviors.end(),
                   [&](const ObservedBehavior& behavior) { return behavior.path == path; });
  return found == behaviors.end() ? nullptr : &*found;
}

const ObservedRobot& Observation::robot(std::string_view id) const {
  const auto found = std::find_if(robots.begin(), robots.end(),
                                  [&](const ObservedRobot& robot) { return robot.id == id; });
  if (found == robots.end()) {
    throw std::invalid_argument(
        "there is no robot '" + std::string(id) + "' in the world" +
        those_there(robots, [](const ObservedRobot& robot) { return robot.id; }));
  }
  return *found;
}

void Observation::require_team(std::string_view id) const {
  if (std::find(teams.begin(), teams.end(), id) == teams.end()) {
    throw std::invalid_argument("there is no team '" + std::string(id) + "' in the world" +
                                those_there(teams, [](std::string_view team) { return team; }));
  }
}

void Measure::equipped(const Observation& /*start*/) {}

}  // namespace elsie
