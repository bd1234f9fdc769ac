// The command of a gripper.
#pragma once

namespace elsie {

struct GripCommand {
  static constexpr const char* kind = "grip";
  bool closed = false;  // true: it takes what is within its reach, and keeps it; false: it lets go

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("closed", closed);
  }
};

}  // namespace elsie
