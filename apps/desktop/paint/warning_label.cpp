#include "paint/warning_label.h"

#include <QApplication>
#include <QEvent>
#include <QMessageBox>

#include "paint/axes.h"

namespace elsie::desktop {

WarningLabel::WarningLabel(QWidget* parent) : QLabel(parent) {
  setWordWrap(true);
  setTextInteractionFlags(Qt::TextSelectableByMouse);
  colour();
  hide();
}

void WarningLabel::say(const QString& sentence) {
  setText(sentence);
  setVisible(!sentence.isEmpty());
}

void WarningLabel::changeEvent(QEvent* event) {
  QLabel::changeEvent(event);
  if (event->type() == QEvent::ApplicationPaletteChange || event->type() == QEvent::StyleChange) {
    colour();
  }
}

void WarningLabel::colour() {
  QPalette own = QApplication::palette(this);
  own.setColor(QPalette::WindowText, red(own));
  setPalette(own);
}

void warn(QWidget* window, const QString& title, const QString& sentence, const QString& name) {
  auto* box = new QMessageBox(QMessageBox::Warning, title, sentence, QMessageBox::Ok, window);
  box->setObjectName(name);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

}  // namespace elsie::desktop
