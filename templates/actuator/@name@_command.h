// The command of @name@: plain numbers, which visit() lists.
#pragma once

struct @Class@Command {
  static constexpr const char* kind = "@name@";
  bool on = false;

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("on", on);
  }
};
