// Moving, turning and resizing by keys: the input after G, R and S in the view.
#pragma once

#include <QString>

class QKeyEvent;

namespace elsie::desktop {

/// An axis and a number, typed one key after the other: "X - 0 . 5". The view handles Enter and
/// Esc.
class TypedDrag {
 public:
  enum class Kind { none, move, turn, resize };
  enum class Axis { both, x, y };

  void begin(Kind kind) { *this = TypedDrag(), kind_ = kind; }
  void end() { begin(Kind::none); }
  bool is_on() const { return kind_ != Kind::none; }
  Kind kind() const { return kind_; }

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
  Kind kind_ = Kind::none;
  Axis axis_ = Axis::both;
  QString number_;
};

}  // namespace elsie::desktop
