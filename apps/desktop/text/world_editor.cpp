#include "text/world_editor.h"

#include <QAbstractItemView>
#include <QCompleter>
#include <QKeyEvent>
#include <QScrollBar>
#include <QStringListModel>
#include <algorithm>

#include "text/completion.h"
#include "text/xml_highlighter.h"

namespace elsie::desktop {

WorldEditor::WorldEditor(QWidget* parent)
    : CodeEditor(parent),
      highlighter_(new XmlHighlighter(document())),
      words_(new QStringListModel(this)),
      completer_(new QCompleter(words_, this)) {
  setObjectName(QStringLiteral("world_editor"));
  setAccessibleName(tr("Text of the world"));
  setUndoRedoEnabled(false);
  highlighter_->use_palette(palette());
  completer_->setWidget(this);
  completer_->setCaseSensitivity(Qt::CaseInsensitive);
  completer_->popup()->setObjectName(QStringLiteral("completions"));
  typing_.setSingleShot(true);
  typing_.setInterval(400);
  connect(&typing_, &QTimer::timeout, this, [this] { Q_EMIT edited(whole_text()); });
  // Not textChanged(), which highlighting also raises.
  connect(document(), &QTextDocument::contentsChange, this, [this](int, int removed, int added) {
    if (!from_outside_ && (removed > 0 || added > 0)) {
      typing_.start();
    }
  });
  connect(completer_, qOverload<const QString&>(&QCompleter::activated), this,
          &WorldEditor::take_word);
}

void WorldEditor::use_palette() { highlighter_->use_palette(palette()); }

void WorldEditor::set_text(const QString& text) {
  const QString now = whole_text();
  if (text == now || typing_.isActive()) {
    return;
  }
  const auto shorter = std::min(now.size(), text.size());
  qsizetype same = 0;
  while (same < shorter && now[same] == text[same]) {
    ++same;
  }
  qsizetype tail = 0;
  while (tail < shorter - same && now[now.size() - 1 - tail] == text[text.size() - 1 - tail]) {
    ++tail;
  }
  const int down = verticalScrollBar()->value();
  const int right = horizontalScrollBar()->value();
  const QTextCursor before = textCursor();
  const int anchor = before.anchor();
  const int position = before.position();
  from_outside_ = true;
  QTextCursor change(document());
  change.setPosition(static_cast<int>(same));
  change.setPosition(static_cast<int>(now.size() - tail), QTextCursor::KeepAnchor);
  change.insertText(text.mid(same, text.size() - same - tail));
  from_outside_ = false;
  if (anchor <= same && position <= same) {  // Qt moves a cursor where text is inserted
    QTextCursor kept = textCursor();
    kept.setPosition(anchor);
    kept.setPosition(position, QTextCursor::KeepAnchor);
    setTextCursor(kept);
  }
  verticalScrollBar()->setValue(down);
  horizontalScrollBar()->setValue(right);
  mark_lines();
}

void WorldEditor::commit() {
  if (typing_.isActive()) {
    typing_.stop();
    Q_EMIT edited(whole_text());
  }
}

void WorldEditor::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  if (completer_->popup()->isVisible() && (key == Qt::Key_Return || key == Qt::Key_Enter ||
                                           key == Qt::Key_Tab || key == Qt::Key_Escape)) {
    event->ignore();  // the popup handles these
    return;
  }
  const bool control = (event->modifiers() & Qt::ControlModifier) != 0;
  if (control && key == Qt::Key_Z) {
    if ((event->modifiers() & Qt::ShiftModifier) != 0) {
      Q_EMIT redo_wished();
    } else {
      Q_EMIT undo_wished();
    }
  } else if (control && key == Qt::Key_Space) {
    offer_words(true);
  } else {
    CodeEditor::keyPressEvent(event);
    if (!control && !event->text().isEmpty() && event->text()[0].isPrint()) {
      offer_words(false);
    } else if (key != Qt::Key_Shift) {
      completer_->popup()->hide();
    }
  }
}

void WorldEditor::offer_words(bool wished) {
  const Completion found = complete(catalog_, whole_text().left(textCursor().position()));
  words_->setStringList(found.words);
  completer_->setCompletionPrefix(found.prefix);
  const bool is_whole =
      completer_->completionCount() == 1 && completer_->currentCompletion() == found.prefix;
  if (found.words.isEmpty() || completer_->completionCount() == 0 || is_whole) {
    completer_->popup()->hide();
    return;
  }
  if (wished && completer_->completionCount() == 1) {
    take_word(completer_->currentCompletion());
    return;
  }
  QAbstractItemView* popup = completer_->popup();
  QRect place = cursorRect().translated(viewport()->pos());
  place.setWidth(popup->sizeHintForColumn(0) + popup->verticalScrollBar()->sizeHint().width());
  completer_->complete(place);
  popup->setCurrentIndex(completer_->completionModel()->index(0, 0));
}

void WorldEditor::take_word(const QString& word) {
  QTextCursor cursor = textCursor();
  cursor.movePosition(QTextCursor::Left, QTextCursor::KeepAnchor,
                      static_cast<int>(completer_->completionPrefix().size()));
  cursor.insertText(word);
  setTextCursor(cursor);
}

}  // namespace elsie::desktop
