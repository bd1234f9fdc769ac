// The reading of a bumper.
#pragma once

namespace elsie {

/// Whether something presses on a part of the body.
struct BumperReading {
  static constexpr const char* kind = "bumper";
  bool pressed = false;
  double force_n = 0.0;  // mean of the control period, along the normals of the contacts

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("pressed", pressed);
    visitor("force", force_n, "N");
  }
};

}  // namespace elsie
