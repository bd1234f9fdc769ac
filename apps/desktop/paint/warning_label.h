// A sentence that says why something is not so.
#pragma once

#include <QLabel>

namespace elsie::desktop {

/// Red that can be read on the window's background, light or dark. Hidden while it is empty.
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
