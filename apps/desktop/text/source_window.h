// A window with the text of a file that is not the world: a template, or the source of a plugin.
#pragma once

#include <QWidget>

namespace elsie::desktop {

class CodeEditor;

/// Ctrl+S writes the file; the engine reads again what it watches. Asks about unsaved changes when
/// it is closed.
class SourceWindow : public QWidget {
  Q_OBJECT

 public:
  /// Shows the file at that line, in the window that has it already, or in a new one of `parent`.
  /// Returns why the file cannot be shown; "" if it is.
  static QString show(const QString& file, int line, QWidget* parent);

  bool save();

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  SourceWindow(const QString& file, const QString& text, QWidget* parent);

  QString file_;
  CodeEditor* editor_;
};

}  // namespace elsie::desktop
