// Undoes the parts of an edit that cannot be completed.
#pragma once

#include <functional>
#include <utility>
#include <vector>

namespace elsie::simulation {

class Undo {
 public:
  Undo() = default;
  Undo(const Undo&) = delete;
  Undo& operator=(const Undo&) = delete;
  /// Undoes everything in reverse order, unless settle() was called.
  ~Undo() {
    while (!actions_.empty()) {
      try {
        actions_.back()();
      } catch (...) {  // a plugin refuses its old values; continue with the rest
      }
      actions_.pop_back();
    }
  }

  void add(std::function<void()> action) { actions_.push_back(std::move(action)); }
  /// Will restore the present values of these variables.
  template <class... Values>
  void keep(Values&... values) {
    (add([&values, before = values] { values = before; }), ...);
  }
  /// Keeps all changes made so far.
  void settle() { actions_.clear(); }

 private:
  std::vector<std::function<void()>> actions_;
};

}  // namespace elsie::simulation
