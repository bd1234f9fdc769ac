// The line below a text that searches the text.
#pragma once

#include <QWidget>

class QLabel;
class QLineEdit;
class QPlainTextEdit;

namespace elsie::desktop {

/// Enter finds the next match, Shift+Enter the previous one, Esc closes.
class FindBar : public QWidget {
  Q_OBJECT

 public:
  explicit FindBar(QPlainTextEdit* text);

  /// Shows the line, filled with the selected text.
  void open();

 Q_SIGNALS:
  void closed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void find(bool backward, bool from_start_of_selection);

  QPlainTextEdit* text_;
  QLineEdit* word_;
  QLabel* verdict_;
};

}  // namespace elsie::desktop
