// The chargers and resources of a team.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/api/image.h"
#include "elsie/world/description.h"

namespace elsie::simulation {

/// Returns the position of the nearest charger that serves the team.
std::optional<Vector2> nearest_charger(const world::World& world, const std::string& team,
                                       const Vector2& place);
/// Returns the charging rate for the team at a place, units per second, or 0.
double charger_rate(const world::World& world, const std::string& team, const Vector2& place);
/// Returns whether a robot of the team may collect the box.
bool may_collect(const std::string& team, const world::Box& box);

/// The teams of a world, which must outlive this.
class Teams {
 public:
  explicit Teams(const world::World& world);

  /// The number of a robot in its team, in file order, from 0.
  int number_of(std::size_t robot) const { return numbers_[robot]; }
  /// The colours of the resources that a robot of this team may collect, each once, in file order.
  const std::vector<Colour>& resource_colours(const std::string& team);

 private:
  const world::World& world_;
  std::vector<int> numbers_;
  std::map<std::string_view, std::vector<Colour>> colours_;  // of teams that were asked for
};

}  // namespace elsie::simulation
