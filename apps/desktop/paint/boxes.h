// Boxes for values: the mouse wheel, and numbers that are typed.
#pragma once

#include <QDoubleSpinBox>
#include <QSpinBox>

namespace elsie::desktop {

/// Lets the wheel change the box only while the box has the keyboard focus, which the wheel does
/// not give it. Otherwise the wheel moves the page that contains the box (QGIS#4245).
void quiet_wheel(QWidget* box);

/// Reads numbers alike in every language: a comma that is typed is a decimal point; no character
/// separates thousands. With quiet_wheel().
class NumberBox : public QDoubleSpinBox {
 public:
  explicit NumberBox(QWidget* parent = nullptr);
  QValidator::State validate(QString& text, int& cursor) const override;
};

/// For whole numbers: a point or comma makes the text wrong, and the last right number comes back.
class CountBox : public QSpinBox {
 public:
  explicit CountBox(QWidget* parent = nullptr);
  QValidator::State validate(QString& text, int& cursor) const override;
  void fixup(QString& /*text*/) const override {}  // Qt would take the comma out
};

}  // namespace elsie::desktop
