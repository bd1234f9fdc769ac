// Several sensors of one kind, side by side, that are added at once.
#pragma once

#include <QWidget>
#include <vector>

class QDoubleSpinBox;
class QSpinBox;

namespace elsie::desktop {

/// The number of sensors, and the angle over which they are spread.
class Fan : public QWidget {
  Q_OBJECT

 public:
  explicit Fan(int count, QWidget* parent = nullptr);

  /// Sets the number to one, unless the user has chosen it: a sensor with its own name or heading
  /// is alone.
  void become_one();

  /// The headings in degrees, from right to left, around `middle_deg`. Over 360 degrees they are a
  /// ring without the same heading twice.
  std::vector<double> headings_deg(double middle_deg) const;

 private:
  QSpinBox* count_;
  bool is_chosen_ = false;
  QDoubleSpinBox* spread_deg_;
};

}  // namespace elsie::desktop
