#include "paint/number_boxes.h"

#include <QLocale>

#include "paint/quiet_wheel.h"

namespace elsie::desktop {
namespace {

QLocale plain() {
  QLocale locale = QLocale::c();
  locale.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
  return locale;
}

}  // namespace

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent) {
  setLocale(plain());
  quiet_wheel(this);
}

QValidator::State NumberBox::validate(QString& text, int& cursor) const {
  text.replace(u',', u'.');
  return QDoubleSpinBox::validate(text, cursor);
}

CountBox::CountBox(QWidget* parent) : QSpinBox(parent) {
  setLocale(plain());
  quiet_wheel(this);
}

QValidator::State CountBox::validate(QString& text, int& cursor) const {
  const bool is_broken = text.contains(u'.') || text.contains(u',');
  return is_broken ? QValidator::Intermediate : QSpinBox::validate(text, cursor);
}

}  // namespace elsie::desktop
