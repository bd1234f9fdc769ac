// A label that says why something was refused.
#pragma once

#include <QLabel>

namespace elsie::desktop {

/// Its red is readable on the window's background, light or dark. It is hidden while it is empty.
class WarningLabel : public QLabel {
  Q_OBJECT

 public:
  explicit WarningLabel(QWidget* parent = nullptr);

  void say(const QString& sentence);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void colour();
};

/// Warns in a box that does not block the event loop; `name` is its object name.
void warn(QWidget* window, const QString& title, const QString& sentence,
          const QString& name = "warning");

}  // namespace elsie::desktop
