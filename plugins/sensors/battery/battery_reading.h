// The reading of a sensor of the battery.
#pragma once

namespace elsie {

struct BatteryReading {
  static constexpr const char* kind = "battery";
  double charge = 1.0;  // energy / capacity
  double energy = 0.0;  // units
  bool charging = false;

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("charge", charge);
    visitor("energy", energy, "units");
    visitor("charging", charging);
  }
};

}  // namespace elsie
