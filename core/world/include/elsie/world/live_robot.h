// Changes of a robot in a running world.
#pragma once

#include "elsie/api/declaration.h"
#include "elsie/world/description.h"

namespace elsie::world {

struct AttributePlace;

/// A robot whose attributes can change while its world runs. An attribute is live if the vocabulary
/// names the function here that changes it. A value has the attribute's type and is in its range.
/// Each function may throw std::invalid_argument with a sentence if the robot cannot take it.
class LiveRobot {
 public:
  virtual void set_x(double metres) = 0;
  virtual void set_y(double metres) = 0;
  virtual void set_z(double metres) = 0;
  virtual void set_heading_deg(double degrees) = 0;
  virtual void set_max_speed(double metres_per_second) = 0;
  virtual void set_coverage(double metres) = 0;
  virtual void set_leader(bool leader) = 0;
  /// Sets the present energy of the battery.
  virtual void set_energy(double units) = 0;
  virtual void set_energy_cost(const PluginUse& sensor, double units_per_second) = 0;
  virtual void set_priority(const PluginUse& behavior, double priority) = 0;
  /// Sets a parameter that a plugin of the robot declares.
  virtual void set_parameter(const AttributePlace& place, const ParameterValue& value) = 0;

 protected:
  ~LiveRobot() = default;
};

}  // namespace elsie::world
