#include "paint/boxes.h"

#include <QEvent>
#include <QLocale>

namespace elsie::desktop {
namespace {

QLocale plain() {
  QLocale locale = QLocale::c();
  locale.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
  return locale;
}

class QuietWheel : public QObject {
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() != QEvent::Wheel || static_cast<QWidget*>(watched)->hasFocus()) {
      return false;
    }
    event->ignore();  // the page below it takes the event
    return true;
  }
};

}  // namespace

void quiet_wheel(QWidget* box) {
  box->setFocusPolicy(Qt::StrongFocus);
  box->installEventFilter(new QuietWheel(box));
}

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
