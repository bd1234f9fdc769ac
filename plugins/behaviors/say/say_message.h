// A place that robots tell each other: 8 bytes, which also a range and bearing carries.
#pragma once

namespace elsie {

struct PlaceMessage {
  static constexpr const char* kind = "place";
  float x = 0.0F;  // m, as the sender believes
  float y = 0.0F;  // m

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("x", x, "m");
    visitor("y", y, "m");
  }
};

}  // namespace elsie
