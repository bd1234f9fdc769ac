#include "scene/typed_drag.h"

#include <QCoreApplication>
#include <QKeyEvent>

namespace elsie::desktop {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("elsie::desktop::TypedDrag", text);
}

}  // namespace

bool TypedDrag::take(const QKeyEvent& key) {
  if (key.key() == Qt::Key_X || key.key() == Qt::Key_Y) {
    axis_ = key.key() == Qt::Key_X ? Axis::x : Axis::y;
    return true;
  }
  if (key.key() == Qt::Key_Backspace) {
    number_.chop(1);
    return true;
  }
  if (key.key() == Qt::Key_Minus) {
    number_ = number_.startsWith(u'-') ? number_.mid(1) : u'-' + number_;
    return true;
  }
  const bool is_point =
      (key.key() == Qt::Key_Period || key.key() == Qt::Key_Comma) && !number_.contains(u'.');
  if (is_point || (key.key() >= Qt::Key_0 && key.key() <= Qt::Key_9)) {
    number_ += is_point ? QChar(u'.') : QChar(key.key());
    return true;
  }
  return false;
}

bool TypedDrag::has_number() const {
  bool is_number = false;
  number_.toDouble(&is_number);
  return is_number;
}

double TypedDrag::number() const { return number_.toDouble(); }

TypedDrag::Axis TypedDrag::axis() const {
  return axis_ == Axis::both && tool_ == Tool::move ? Axis::x : axis_;
}

QString TypedDrag::text() const {
  const QString number = number_.isEmpty() ? QStringLiteral("...") : number_;
  const QString along = axis() == Axis::x ? tr("x") : axis() == Axis::y ? tr("y") : tr("x and y");
  switch (tool_) {
    case Tool::move:
      return tr("move along %1 by %2 m").arg(along, number);
    case Tool::turn:
      return tr("turn by %1\u00b0").arg(number);
    case Tool::resize:
      return tr("size along %1 times %2").arg(along, number);
    default:
      return {};
  }
}

}  // namespace elsie::desktop
