// The command of a pen.
#pragma once

namespace elsie {

struct PenCommand {
  static constexpr const char* kind = "pen";
  double flow = 0.0;  // of its rate, in [0, 1]; 0: it is up

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("flow", flow);
  }
};

}  // namespace elsie
