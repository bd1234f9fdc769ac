// The reading of a sensor that looks at the floor.
#pragma once

namespace elsie {

/// The floor below the sensor. Each number from 0 (black) to 1.
struct GroundReading {
  static constexpr const char* kind = "ground";
  double grey = 1.0;  // 0.299 red + 0.587 green + 0.114 blue
  double red = 1.0;
  double green = 1.0;
  double blue = 1.0;

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("grey", grey);
    visitor("red", red);
    visitor("green", green);
    visitor("blue", blue);
  }
};

}  // namespace elsie
