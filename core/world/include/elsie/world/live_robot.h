// What a change does to a robot of a world that runs.
#pragma once

#include "elsie/api/declaration.h"
#include "elsie/world/description.h"

namespace elsie::world {

struct AttributePlace;

/// A robot whose attributes change while its world runs. An attribute is live when the vocabulary
/// names the function here that changes it. A value is of the attribute's type and in its range;
/// each function may throw std::invalid_argument with a sentence when the robot cannot take it.
class LiveRobot {
 public:
  virtual void set_x(double metres) = 0;
  virtual void set_y(double metres) = 0;
  virtual void set_z(double metres) = 0;
  virtual void set_heading_deg(double degrees) = 0;
  virtual void set_max_speed(double metres_per_second) = 0;
  virtual void set_coverage(double metres) = 0;
  virtual void set_leader(bool leader) = 0;
  /// What is in the battery now.
  virtual void set_energy(double units) = 0;
  virtual void set_energy_cost(const PluginUse& sensor, double units_per_second) = 0;
  virtual void set_priority(const PluginUse& behavior, double priority) = 0;
  /// One that a plugin of the robot declares.
  virtual void set_parameter(const AttributePlace& place, const ParameterValue& value) = 0;

 protected:
  ~LiveRobot() = default;
};

}  // namespace elsie::world
