#include "text/find_bar.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QToolButton>

namespace elsie::desktop {

FindBar::FindBar(QPlainTextEdit* text)
    : QWidget(text), text_(text), word_(new QLineEdit(this)), verdict_(new QLabel(this)) {
  setObjectName(QStringLiteral("find_bar"));
  setAutoFillBackground(true);
  word_->setObjectName(QStringLiteral("find_word"));
  word_->setAccessibleName(tr("Find in the text"));
  word_->setPlaceholderText(tr("Find"));
  verdict_->setObjectName(QStringLiteral("find_verdict"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(4, 2, 4, 2);
  row->addWidget(word_, 1);
  row->addWidget(verdict_);
  const auto button = [&](const QString& sign, const QString& name, auto action) {
    auto* made = new QToolButton(this);
    made->setText(sign);
    made->setToolTip(name);
    made->setAccessibleName(name);
    made->setAutoRaise(true);
    connect(made, &QToolButton::clicked, this, action);
    row->addWidget(made);
  };
  button(QStringLiteral("↑"), tr("Find the previous one (Shift+Enter)"),
         [this] { find(true, false); });
  button(QStringLiteral("↓"), tr("Find the next (Enter)"), [this] { find(false, false); });
  button(QStringLiteral("×"), tr("Close (Esc)"), [this] { Q_EMIT closed(); });
  connect(word_, &QLineEdit::textChanged, this, [this] { find(false, true); });
  word_->installEventFilter(this);
  hide();
}

void FindBar::open() {
  show();
  if (const QString selected = text_->textCursor().selectedText();
      !selected.isEmpty() && !selected.contains(QChar::ParagraphSeparator)) {
    word_->setText(selected);
  }
  word_->setFocus();
  word_->selectAll();
}

bool FindBar::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_Escape) {
      Q_EMIT closed();
      return true;
    }
    if (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) {
      find((key->modifiers() & Qt::ShiftModifier) != 0, false);
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

void FindBar::find(bool backward, bool from_start_of_selection) {
  const QString word = word_->text();
  verdict_->clear();
  if (word.isEmpty()) {
    return;
  }
  QTextCursor from = text_->textCursor();
  if (from_start_of_selection) {
    from.setPosition(from.selectionStart());
  }
  const auto flags = backward ? QTextDocument::FindBackward : QTextDocument::FindFlags();
  QTextCursor found = text_->document()->find(word, from, flags);
  if (found.isNull()) {
    QTextCursor edge(text_->document());
    edge.movePosition(backward ? QTextCursor::End : QTextCursor::Start);
    found = text_->document()->find(word, edge, flags);
    verdict_->setText(found.isNull() ? tr("not found") : tr("continued from the other end"));
  }
  if (!found.isNull()) {
    text_->setTextCursor(found);
  }
}

}  // namespace elsie::desktop
