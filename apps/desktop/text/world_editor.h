// The editor of a world's text.
#pragma once

#include <QPlainTextEdit>
#include <QTimer>
#include <map>
#include <vector>

#include "engine/catalog.h"
#include "engine/problem.h"

class QCompleter;
class QStringListModel;

namespace elsie::desktop {

class FindBar;
class XmlHighlighter;

/// Shows the text of the document, which the window owns: set_text() sets it, and edited() reports
/// what was typed. The editor has no undo of its own; it leaves the keys to the window.
class WorldEditor : public QPlainTextEdit {
  Q_OBJECT

 public:
  /// Without `is_xml`, for texts of other languages, in one colour.
  explicit WorldEditor(QWidget* parent = nullptr, bool is_xml = true);

  /// Changes only what differs, so that cursor and scroll position stay, without edited(). While
  /// typed text waits for its edited(), the text stays as typed, and edited() sends it.
  void set_text(const QString& text);
  /// The present text, with each character as it was typed or read.
  QString whole_text() const;
  /// Emits edited() now if it waits.
  void commit();
  /// Underlines these lines and makes their numbers red; the messages are tool tips. All problems
  /// must be of this text.
  void set_problems(const std::vector<Problem>& problems);
  void set_catalog(const Catalog& catalog) { catalog_ = catalog; }
  /// Puts the cursor at the start of the line, counted from 1, in the middle of the view.
  void go_to(int line);
  void open_find();

  /// These are for the margin.
  int margin_width() const;
  void paint_margin(const QRect& dirty);
  /// The messages of the line at this height of the view, one per line; "" if there are none.
  QString problem_at(int y) const;

 Q_SIGNALS:
  /// Emitted 400 ms after the last key stroke.
  void edited(const QString& text);
  void undo_wished();
  void redo_wished();

 protected:
  bool event(QEvent* event) override;
  bool viewportEvent(QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void lay_out();
  void mark_lines();
  void offer_words(bool wished);
  void take_word(const QString& word);

  XmlHighlighter* highlighter_;
  QWidget* margin_;
  FindBar* find_;
  QStringListModel* words_;
  QCompleter* completer_;
  QTimer typing_;
  bool from_outside_ = false;
  std::map<int, QString> problems_;  // by line, from 1
  Catalog catalog_;
};

}  // namespace elsie::desktop
