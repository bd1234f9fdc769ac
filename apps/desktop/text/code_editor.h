// An editor of code: line numbers, marks of errors, find.
#pragma once

#include <QPlainTextEdit>
#include <map>
#include <vector>

#include "engine/problem.h"

namespace elsie::desktop {

class FindBar;

class CodeEditor : public QPlainTextEdit {
  Q_OBJECT

 public:
  explicit CodeEditor(QWidget* parent = nullptr);

  /// The present text, with each character as it was typed or read.
  QString whole_text() const;
  /// Underlines these lines and makes their numbers red; the messages are tool tips. All problems
  /// must be of this text.
  void set_problems(const std::vector<Problem>& problems);
  /// Puts the cursor at the start of the line, counted from 1, in the middle of the view.
  void go_to(int line);
  void open_find();

  /// These are for the margin.
  int margin_width() const;
  void paint_margin(const QRect& dirty);
  /// The messages of the line at this height of the view, one per line; "" if there are none.
  QString problem_at(int y) const;

 protected:
  bool event(QEvent* event) override;
  bool viewportEvent(QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

  /// The palette has changed: the highlighter should use it.
  virtual void use_palette() {}
  void mark_lines();

 private:
  void lay_out();

  QWidget* margin_;
  FindBar* find_;
  std::map<int, QString> problems_;  // by line, from 1
};

}  // namespace elsie::desktop
