// Colours for texts, on light and on dark palettes.
#pragma once

#include <QSyntaxHighlighter>
#include <QTextCharFormat>

class QPalette;

namespace elsie::desktop {

class Highlighter : public QSyntaxHighlighter {
 public:
  explicit Highlighter(QTextDocument* document);

  /// Chooses colours that are readable on the palette's base, and highlights again.
  void use_palette(const QPalette& palette);

 protected:
  /// Formats a line from `at` to the end of `mark`, which is looked for from `from` on, and moves
  /// `at` there. Returns whether it was found in this line.
  bool format_until(const QString& mark, const QTextCharFormat& format, const QString& line,
                    int from, int& at);

  QTextCharFormat keyword_, string_, comment_;
  QTextCharFormat detail_;  // names of attributes, numbers
};

}  // namespace elsie::desktop
