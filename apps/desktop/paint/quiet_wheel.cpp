#include "paint/quiet_wheel.h"

#include <QEvent>
#include <QWidget>

namespace elsie::desktop {
namespace {

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

}  // namespace elsie::desktop
