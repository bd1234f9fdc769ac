#include "text/world_editor.h"

#include <QAbstractItemView>
#include <QCompleter>
#include <QContextMenuEvent>
#include <QFontDatabase>
#include <QHelpEvent>
#include <QMenu>
#include <QPainter>
#include <QScrollBar>
#include <QStringListModel>
#include <QTextBlock>
#include <QToolTip>
#include <algorithm>

#include "paint/axes.h"
#include "text/completion.h"
#include "text/find_bar.h"
#include "text/xml_highlighter.h"

namespace elsie::desktop {
namespace {

class Margin : public QWidget {
 public:
  explicit Margin(WorldEditor* editor) : QWidget(editor), editor_(editor) {}

 protected:
  void paintEvent(QPaintEvent* event) override { editor_->paint_margin(event->rect()); }
  bool event(QEvent* event) override {
    if (event->type() == QEvent::ToolTip) {
      const auto* help = static_cast<QHelpEvent*>(event);
      QToolTip::showText(help->globalPos(), editor_->problem_at(help->pos().y()), this);
      return true;
    }
    return QWidget::event(event);
  }

 private:
  WorldEditor* editor_;
};

}  // namespace

WorldEditor::WorldEditor(QWidget* parent, bool is_xml)
    : QPlainTextEdit(parent),
      highlighter_(new XmlHighlighter(document())),
      margin_(new Margin(this)),
      find_(new FindBar(this)),
      words_(new QStringListModel(this)),
      completer_(new QCompleter(words_, this)) {
  setObjectName(QStringLiteral("world_editor"));
  setAccessibleName(tr("Text of the world"));
  QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  fixed.setPointSizeF(font().pointSizeF());
  setFont(fixed);
  setLineWrapMode(QPlainTextEdit::NoWrap);
  setTabStopDistance(2 * fontMetrics().horizontalAdvance(u' '));
  setUndoRedoEnabled(false);
  is_xml ? highlighter_->use_palette(palette()) : highlighter_->setDocument(nullptr);
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
  connect(find_, &FindBar::closed, this, [this] {
    find_->hide();
    lay_out();
    setFocus();
  });
  connect(this, &QPlainTextEdit::blockCountChanged, this, &WorldEditor::lay_out);
  connect(this, &QPlainTextEdit::updateRequest, this, [this](const QRect& rect, int dy) {
    dy != 0 ? margin_->scroll(0, dy)
            : margin_->update(0, rect.y(), margin_->width(), rect.height());
  });
  connect(this, &QPlainTextEdit::cursorPositionChanged, this, &WorldEditor::mark_lines);
  lay_out();
}

// Not toPlainText(), which turns all other blanks into plain ones.
QString WorldEditor::whole_text() const {
  QString text = document()->toRawText();
  text.replace(QChar::ParagraphSeparator, u'\n');
  text.replace(QChar::LineSeparator, u'\n');
  return text;
}

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

void WorldEditor::set_problems(const std::vector<Problem>& problems) {
  problems_.clear();
  for (const Problem& problem : problems) {
    QString& text = problems_[std::max(problem.line, 1)];
    text += (text.isEmpty() ? QString() : QStringLiteral("\n")) + problem.message;
  }
  mark_lines();
  margin_->update();
}

void WorldEditor::go_to(int line) {
  const QTextBlock block = document()->findBlockByNumber(std::clamp(line, 1, blockCount()) - 1);
  setTextCursor(QTextCursor(block));
  centerCursor();
  setFocus();
}

void WorldEditor::open_find() {
  find_->open();
  lay_out();
  ensureCursorVisible();
}

int WorldEditor::margin_width() const {
  const auto digits = QString::number(std::max(blockCount(), 99)).size();
  return fontMetrics().horizontalAdvance(u'9') * (static_cast<int>(digits) + 2);
}

void WorldEditor::lay_out() {
  const int below = find_->isHidden() ? 0 : find_->sizeHint().height();
  setViewportMargins(margin_width(), 0, 0, below);
  const QRect inside = contentsRect();
  margin_->setGeometry(inside.left(), inside.top(), margin_width(), inside.height() - below);
  find_->setGeometry(inside.left(), inside.bottom() + 1 - below, inside.width(), below);
}

void WorldEditor::paint_margin(const QRect& dirty) {
  QPainter painter(margin_);
  painter.setFont(font());
  painter.fillRect(dirty, palette().color(QPalette::AlternateBase));
  QTextBlock block = firstVisibleBlock();
  qreal top = blockBoundingGeometry(block).translated(contentOffset()).top();
  for (; block.isValid() && top <= dirty.bottom(); block = block.next()) {
    const int line = block.blockNumber() + 1;
    const bool wrong = problems_.contains(line);
    QFont number = font();
    number.setBold(wrong);
    painter.setFont(number);
    painter.setPen(wrong ? red(palette()) : palette().color(QPalette::PlaceholderText));
    const int space = fontMetrics().horizontalAdvance(u'9');
    painter.drawText(QRectF(0, top, margin_->width() - space / 2, fontMetrics().height()),
                     Qt::AlignRight,
                     (wrong ? QStringLiteral("!") : QString()) + QString::number(line));
    top += blockBoundingRect(block).height();
  }
}

QString WorldEditor::problem_at(int y) const {
  const auto found = problems_.find(cursorForPosition(QPoint(0, y)).blockNumber() + 1);
  return found == problems_.end() ? QString() : found->second;
}

void WorldEditor::mark_lines() {
  QList<QTextEdit::ExtraSelection> marks;
  QTextEdit::ExtraSelection current;
  QColor back = palette().color(QPalette::Highlight);
  back.setAlphaF(0.12F);
  current.format.setBackground(back);
  current.format.setProperty(QTextFormat::FullWidthSelection, true);
  current.cursor = textCursor();
  current.cursor.clearSelection();
  marks << current;
  for (const auto& [line, message] : problems_) {
    QTextEdit::ExtraSelection mark;
    mark.cursor = QTextCursor(document()->findBlockByNumber(std::min(line, blockCount()) - 1));
    const QString text = mark.cursor.block().text();
    const auto first = std::find_if(text.begin(), text.end(), [](QChar c) { return !c.isSpace(); });
    mark.cursor.movePosition(QTextCursor::Right, QTextCursor::MoveAnchor,
                             static_cast<int>(first - text.begin()));
    mark.cursor.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
    mark.format.setUnderlineStyle(QTextCharFormat::WaveUnderline);
    mark.format.setUnderlineColor(red(palette()));
    mark.format.setToolTip(message);
    marks << mark;
  }
  setExtraSelections(marks);
}

bool WorldEditor::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Find)) {
      event->accept();
      return true;
    }
  }
  return QPlainTextEdit::event(event);
}

bool WorldEditor::viewportEvent(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    QToolTip::showText(help->globalPos(), problem_at(help->pos().y()), this);
    return true;
  }
  return QPlainTextEdit::viewportEvent(event);
}

void WorldEditor::changeEvent(QEvent* event) {
  QPlainTextEdit::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    highlighter_->use_palette(palette());
    mark_lines();
  } else if (event->type() == QEvent::FontChange) {
    lay_out();
  }
}

void WorldEditor::resizeEvent(QResizeEvent* event) {
  QPlainTextEdit::resizeEvent(event);
  lay_out();
}

void WorldEditor::contextMenuEvent(QContextMenuEvent* event) {
  const std::unique_ptr<QMenu> menu(createStandardContextMenu(event->pos()));
  menu->addSeparator();
  menu->addAction(tr("Find..."), QKeySequence(QKeySequence::Find), this, &WorldEditor::open_find);
  menu->exec(event->globalPos());
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
  } else if (event->matches(QKeySequence::Find)) {
    open_find();
  } else if (control && key == Qt::Key_Space) {
    offer_words(true);
  } else if (key == Qt::Key_Escape && !find_->isHidden()) {
    Q_EMIT find_->closed();
  } else {
    QPlainTextEdit::keyPressEvent(event);
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
