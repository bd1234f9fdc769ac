// What the robots of a world have in common.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/api/image.h"
#include "elsie/api/sensor.h"
#include "elsie/world/description.h"

namespace elsie::simulation {

/// Of a world, which must outlive this.
class Commons {
 public:
  explicit Commons(const world::World& world);

  /// The number of a robot in its team, in file order, from 0.
  int number_of(std::size_t robot) const { return numbers_[robot]; }
  /// The colours of the resources that a robot of this team may collect, each once, in file order.
  const std::vector<Colour>& resource_colours(const std::string& team);
  /// Sensors at the same place share it: memory that all robots use is near the processor.
  std::shared_ptr<const SensorPlace> place(const Mounting& mounting);

 private:
  const world::World& world_;
  std::vector<int> numbers_;
  std::map<std::string_view, std::vector<Colour>> colours_;  // of teams that were asked for
  std::map<std::array<double, 5>, std::shared_ptr<const SensorPlace>> places_;
};

}  // namespace elsie::simulation
