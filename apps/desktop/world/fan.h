// Several sensors of one kind side by side, made at once.
#pragma once

#include <QWidget>
#include <vector>

class QDoubleSpinBox;
class QSpinBox;

namespace elsie::desktop {

/// How many there are, and the angle over which they are spread.
class Fan : public QWidget {
  Q_OBJECT

 public:
  explicit Fan(int count, QWidget* parent = nullptr);

  /// One only, unless the user has chosen how many: what has a name or a heading of its own is one.
  void become_one();

  /// Headings in degrees, from the right to the left of the middle one, which is `middle_deg`. Over
  /// 360 degrees they are a ring without the same heading twice.
  std::vector<double> headings_deg(double middle_deg) const;

 private:
  QSpinBox* count_;
  bool is_chosen_ = false;
  QDoubleSpinBox* spread_deg_;
};

}  // namespace elsie::desktop
