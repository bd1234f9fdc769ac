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

}  // namespace elsie::desktop
