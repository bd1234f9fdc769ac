// The command of a lamp on a robot.
#pragma once

#include "elsie/api/image.h"

namespace elsie {

struct LedCommand {
  static constexpr const char* kind = "led";
  Colour colour{255, 255, 255};
  double brightness = 0.0;  // in [0, 1]; 0: dark

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("red", colour.red);
    visitor("green", colour.green);
    visitor("blue", colour.blue);
    visitor("brightness", brightness);
  }
};

}  // namespace elsie
