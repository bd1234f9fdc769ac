// What is put back when an edit cannot be made as a whole.
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
  /// Undoes all in reverse order, unless it was settled.
  ~Undo() {
    while (!actions_.empty()) {
      try {
        actions_.back()();
      } catch (...) {  // of a plugin that does not take back what it had; the rest counts
      }
      actions_.pop_back();
    }
  }

  void add(std::function<void()> action) { actions_.push_back(std::move(action)); }
  /// Puts these back to what they are now.
  template <class... Values>
  void keep(Values&... values) {
    (add([&values, before = values] { values = before; }), ...);
  }
  /// From here on nothing is undone.
  void settle() { actions_.clear(); }

 private:
  std::vector<std::function<void()>> actions_;
};

}  // namespace elsie::simulation
