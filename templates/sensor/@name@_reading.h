// What the sensor hands to behaviours: both sides include this header, and nothing else of each other.
#pragma once

struct @Class@Reading {
  static constexpr const char* kind = "@name@";
  double brightness = 0.0;  // 1 at the lamp, less with the square of the distance

  template <class Visitor>
  void visit(Visitor&& visitor) const {  // what recordings show of it
    visitor("brightness", brightness);
  }
};
