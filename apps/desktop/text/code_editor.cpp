#include "text/code_editor.h"

#include <QContextMenuEvent>
#include <QFontDatabase>
#include <QHelpEvent>
#include <QMenu>
#include <QPainter>
#include <QTextBlock>
#include <QToolTip>
#include <algorithm>

#include "paint/axes.h"
#include "text/find_bar.h"

namespace elsie::desktop {
namespace {

class Margin : public QWidget {
 public:
  explicit Margin(CodeEditor* editor) : QWidget(editor), editor_(editor) {}

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
  CodeEditor* editor_;
};

}  // namespace

CodeEditor::CodeEditor(QWidget* parent)
    : QPlainTextEdit(parent), margin_(new Margin(this)), find_(new FindBar(this)) {
  QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  fixed.setPointSizeF(font().pointSizeF());
  setFont(fixed);
  setLineWrapMode(QPlainTextEdit::NoWrap);
  setTabStopDistance(2 * fontMetrics().horizontalAdvance(u' '));
  connect(find_, &FindBar::closed, this, [this] {
    find_->hide();
    lay_out();
    setFocus();
  });
  connect(this, &QPlainTextEdit::blockCountChanged, this, &CodeEditor::lay_out);
  connect(this, &QPlainTextEdit::updateRequest, this, [this](const QRect& rect, int dy) {
    dy != 0 ? margin_->scroll(0, dy)
            : margin_->update(0, rect.y(), margin_->width(), rect.height());
  });
  connect(this, &QPlainTextEdit::cursorPositionChanged, this, &CodeEditor::mark_lines);
  lay_out();
}

// Not toPlainText(), which turns all other blanks into plain ones.
QString CodeEditor::whole_text() const {
  QString text = document()->toRawText();
  text.replace(QChar::ParagraphSeparator, u'\n');
  text.replace(QChar::LineSeparator, u'\n');
  return text;
}

void CodeEditor::set_problems(const std::vector<Problem>& problems) {
  problems_.clear();
  for (const Problem& problem : problems) {
    QString& text = problems_[std::max(problem.line, 1)];
    text += (text.isEmpty() ? QString() : QStringLiteral("\n")) + problem.message;
  }
  mark_lines();
  margin_->update();
}

void CodeEditor::go_to(int line) {
  const QTextBlock block = document()->findBlockByNumber(std::clamp(line, 1, blockCount()) - 1);
  setTextCursor(QTextCursor(block));
  centerCursor();
  setFocus();
}

void CodeEditor::open_find() {
  find_->open();
  lay_out();
  ensureCursorVisible();
}

int CodeEditor::margin_width() const {
  const auto digits = QString::number(std::max(blockCount(), 99)).size();
  return fontMetrics().horizontalAdvance(u'9') * (static_cast<int>(digits) + 2);
}

void CodeEditor::lay_out() {
  const int below = find_->isHidden() ? 0 : find_->sizeHint().height();
  setViewportMargins(margin_width(), 0, 0, below);
  const QRect inside = contentsRect();
  margin_->setGeometry(inside.left(), inside.top(), margin_width(), inside.height() - below);
  find_->setGeometry(inside.left(), inside.bottom() + 1 - below, inside.width(), below);
}

void CodeEditor::paint_margin(const QRect& dirty) {
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

QString CodeEditor::problem_at(int y) const {
  const auto found = problems_.find(cursorForPosition(QPoint(0, y)).blockNumber() + 1);
  return found == problems_.end() ? QString() : found->second;
}

void CodeEditor::mark_lines() {
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

bool CodeEditor::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Find)) {
      event->accept();
      return true;
    }
  }
  return QPlainTextEdit::event(event);
}

bool CodeEditor::viewportEvent(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    QToolTip::showText(help->globalPos(), problem_at(help->pos().y()), this);
    return true;
  }
  return QPlainTextEdit::viewportEvent(event);
}

void CodeEditor::changeEvent(QEvent* event) {
  QPlainTextEdit::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    use_palette();
    mark_lines();
  } else if (event->type() == QEvent::FontChange) {
    lay_out();
  }
}

void CodeEditor::resizeEvent(QResizeEvent* event) {
  QPlainTextEdit::resizeEvent(event);
  lay_out();
}

void CodeEditor::contextMenuEvent(QContextMenuEvent* event) {
  const std::unique_ptr<QMenu> menu(createStandardContextMenu(event->pos()));
  menu->addSeparator();
  menu->addAction(tr("Find..."), QKeySequence(QKeySequence::Find), this, &CodeEditor::open_find);
  menu->exec(event->globalPos());
}

void CodeEditor::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Find)) {
    open_find();
  } else if (event->key() == Qt::Key_Escape && !find_->isHidden()) {
    Q_EMIT find_->closed();
  } else {
    QPlainTextEdit::keyPressEvent(event);
  }
}

}  // namespace elsie::desktop
