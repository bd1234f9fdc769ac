// What hands do: clicks and keys go to the window, which passes them on as those of the system.
#pragma once

#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QTimer>
#include <QWheelEvent>
#include <QWindow>

#include "scene/scene_view.h"
#include "window.h"
#include "world/form.h"
#include "world/properties.h"

namespace elsie::desktop {

inline void click_at(QWidget* widget, const QPoint& at, Qt::MouseButton button = Qt::LeftButton,
                     Qt::KeyboardModifiers keys = {}) {
  QTest::mouseClick(widget->window()->windowHandle(), button, keys,
                    widget->mapTo(widget->window(), at));
}
inline void click_on(QWidget* widget, Qt::MouseButton button = Qt::LeftButton,
                     Qt::KeyboardModifiers keys = {}) {
  REQUIRE(widget);
  REQUIRE(widget->isVisible());
  const auto centre = [&] { return widget->mapTo(widget->window(), widget->rect().center()); };
  REQUIRE(wait_for([&] { return widget->window()->rect().contains(centre()); }));  // laid out
  click_at(widget, widget->rect().center(), button, keys);
}
/// In whatever has the focus in the window of the widget. Shortcuts act in the active window only,
/// and a dialog that closes gives that back some time later.
inline void press_key(QWidget* in, Qt::Key key, Qt::KeyboardModifiers keys = {}) {
  if (!in->window()->isActiveWindow() && !QApplication::activeModalWidget() &&
      !QApplication::activePopupWidget()) {
    activate(*in->window());
  }
  QTest::keyClick(in->window()->windowHandle(), key, keys);
}
inline void type_text(QWidget* in, const char* text) {
  for (const char* letter = text; *letter; ++letter) {
    QTest::keyClick(in->window()->windowHandle(), *letter);
  }
}
inline void turn_wheel(QWidget* widget, const QPoint& at, int eighths) {
  QWheelEvent wheel(at, widget->mapToGlobal(at), {}, {0, eighths}, Qt::NoButton, {},
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(widget, &wheel);
}

/// A line of the form in Properties.
inline QLineEdit* field(Window& window, const char* name) {
  auto* edit = qobject_cast<QLineEdit*>(window.get<Properties>("properties")->form().editor(name));
  REQUIRE(edit);
  return edit;
}

/// The pixel of a point of the world in the view.
inline QPoint pixel_at(Window& window, const Vector3& point) {
  const auto at = window->scene().pixel_of(point);
  REQUIRE(at);
  return at->toPoint();
}

/// Clicks on a row of a tree.
inline void click_row(WorldTree* tree, const QString& path, Qt::MouseButton button = Qt::LeftButton,
                      Qt::KeyboardModifiers keys = {}) {
  QTreeWidgetItem* item = tree->item(path);
  REQUIRE(item);
  for (QTreeWidgetItem* above = item->parent(); above; above = above->parent()) {
    above->setExpanded(true);
  }
  tree->tree()->scrollToItem(item);
  click_at(tree->tree()->viewport(), tree->tree()->visualItemRect(item).center() - QPoint(0, 0),
           button, keys);
}

/// Clicks on the entry of the menu that opens next whose text has `part`; "": closes it.
inline std::shared_ptr<bool> pick_when_open(const char* menu_name, const QString& part) {
  auto done = std::make_shared<bool>(false);
  auto* waiting = new QTimer(qApp);
  QObject::connect(waiting, &QTimer::timeout, waiting, [=] {
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    if (!menu || menu->objectName() != menu_name) {
      return;
    }
    waiting->stop();
    waiting->deleteLater();
    for (QAction* action : menu->actions()) {
      if (!part.isEmpty() && action->text().remove('&').contains(part)) {
        *done = true;
        QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
        return;
      }
    }
    *done = part.isEmpty();
    menu->close();
  });
  waiting->start(20);
  return done;
}

/// What a menu offers.
struct Offered {
  QStringList entries;
  bool has_active = false;  // one is highlighted at once
};
/// Opens a menu, which blocks until it is closed, and closes it.
inline Offered offered_by(const std::function<void()>& open) {
  Offered offered;
  QTimer waiting;
  QObject::connect(&waiting, &QTimer::timeout, &waiting, [&] {
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    if (!menu) return;
    waiting.stop();
    offered.has_active = menu->activeAction() != nullptr;
    for (const QAction* action : menu->actions()) offered.entries << action->text().remove('&');
    menu->close();
  });
  waiting.start(20);
  open();
  return offered;
}

/// A drag in steps, as a hand makes it.
inline void drag_by_hand(QWidget* widget, Qt::MouseButton button, const QPoint& from,
                         const QPoint& to, Qt::KeyboardModifiers keys = {}) {
  QTest::mousePress(widget, button, keys, from);
  for (int i = 1; i <= 4; ++i) {
    const QPoint at = from + (to - from) * i / 4;
    QMouseEvent move(QEvent::MouseMove, at, widget->mapToGlobal(at), Qt::NoButton, button, keys);
    QApplication::sendEvent(widget, &move);
  }
  QTest::mouseRelease(widget, button, keys, to);
}

}  // namespace elsie::desktop
