// Moving, turning and resizing by keys: what follows G, R and S in the view.
#pragma once

#include <QString>

class QKeyEvent;

namespace elsie::desktop {

/// An axis and a number, typed one key after the other: "X - 0 . 5". Enter and Esc are left to the
/// view.
class TypedDrag {
 public:
  enum class Kind { none, move, turn, resize };
  enum class Axis { both, x, y };

  void begin(Kind kind) { *this = TypedDrag(), kind_ = kind; }
  void end() { begin(Kind::none); }
  bool is_on() const { return kind_ != Kind::none; }
  Kind kind() const { return kind_; }

  /// Whether the key belongs to it.
  bool take(const QKeyEvent& key);
  bool has_number() const;
  /// m, degrees, or a factor of the size.
  double number() const;
  /// The axis; x if a way is typed without one, as along both there would be two.
  Axis axis() const;
  /// What is typed so far, for the user.
  QString text() const;

 private:
  Kind kind_ = Kind::none;
  Axis axis_ = Axis::both;
  QString number_;
};

}  // namespace elsie::desktop
