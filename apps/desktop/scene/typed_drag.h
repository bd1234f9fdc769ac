// Moving, turning and resizing by keys: the input after G, R and S in the view.
#pragma once

#include <QString>

class QKeyEvent;

namespace elsie::desktop {

/// What a drag does: with the selection, or with the tape.
enum class Tool { none, move, turn, resize, measure };

/// An axis and a number, typed one key after the other: "X - 0 . 5". The view handles Enter and
/// Esc.
class TypedDrag {
 public:
  enum class Axis { both, x, y };

  void begin(Tool tool) { *this = TypedDrag(), tool_ = tool; }
  void end() { begin(Tool::none); }
  bool is_on() const { return tool_ != Tool::none; }

  /// Takes a key. Returns false if the key does not belong to the drag.
  bool take(const QKeyEvent& key);
  bool has_number() const;
  /// The number, in m, degrees, or as a factor of the size.
  double number() const;
  /// The axis. A move without an axis is along x, because both axes would need two numbers.
  Axis axis() const;
  /// The input so far, for the user.
  QString text() const;

 private:
  Tool tool_ = Tool::none;
  Axis axis_ = Axis::both;
  QString number_;
};

}  // namespace elsie::desktop
