// Boxes for typed numbers, which read them alike in every language.
#pragma once

#include <QDoubleSpinBox>
#include <QSpinBox>

namespace elsie::desktop {

/// A comma that is typed is a decimal point; no character separates thousands. The wheel changes
/// the box only while it has the keyboard focus (quiet_wheel.h).
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
