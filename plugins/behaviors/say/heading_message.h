// What robots of a group tell each other to be noticed, and which way they look: 4 bytes.
#pragma once

namespace elsie {

/// Range and bearing adds from where it is said.
struct HeadingMessage {
  static constexpr const char* kind = "heading";
  float heading_rad = 0.0F;  // counter-clockwise from east, as the sender believes

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("heading_rad", heading_rad, "rad");
  }
};

}  // namespace elsie
