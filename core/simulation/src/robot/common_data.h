// What the robots of a world have in common.
#pragma once

#include <array>
#include <deque>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/api/image.h"
#include "elsie/api/sensor.h"
#include "elsie/world/description.h"

#include "robot/drive_slot.h"

namespace elsie::simulation {

/// The ids of all robots that a run has had.
using RobotIds = std::set<std::string, std::less<>>;

/// Data that robots share, so that it stays in the processor's cache. It only grows, with the
/// places and wheels that edits try.
class CommonData {
 public:
  explicit CommonData(const world::World& world, std::shared_ptr<const RobotIds> ids = nullptr);

  /// The number of a robot in its team, in file order, from 0.
  int number_of(std::size_t robot) const { return numbers_[robot]; }
  /// The colours of the resources that a robot of this team may collect, each once, in file order.
  /// The world must be the same in each call.
  const std::vector<Colour>& resource_colours(const world::World& world, const std::string& team);

  /// Throws base::Error with a sentence if the run has never had a robot with this id.
  void require_robot(const std::string& id) const;

  /// The core's drives of robots with such wheels: radius and half axle, m.
  std::map<std::pair<double, double>, std::shared_ptr<DriveSlot>> drives;

  /// The place for a sensor there, one for all sensors. Valid for the life of this object.
  const SensorPlace& place(const Mounting& mounting);

 private:
  std::shared_ptr<const RobotIds> ids_;
  std::vector<int> numbers_;
  std::map<std::string, std::vector<Colour>> colours_;  // of teams that were asked for
  std::map<std::array<double, 6>, const SensorPlace*> known_;
  std::deque<SensorPlace> places_;
};

}  // namespace elsie::simulation
