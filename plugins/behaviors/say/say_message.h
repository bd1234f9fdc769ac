// A place that robots tell each other.
#pragma once

namespace elsie {

struct PlaceMessage {
  static constexpr const char* kind = "place";
  double x = 0.0;  // m, as the sender believes
  double y = 0.0;  // m

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("x", x, "m");
    visitor("y", y, "m");
  }
};

}  // namespace elsie
