// The reading that the sensor gives to behaviours: this header is all that the two share.
#pragma once

struct @Class@Reading {
  static constexpr const char* kind = "@name@";
  double brightness = 0.0;  // 1 at the lamp, less with the square of the distance

  template <class Visitor>
  void visit(Visitor&& visitor) const {  // its values in recordings and plots; arrays, too
    visitor("brightness", brightness);
  }
};
