// Colours for XML, for light and for dark palettes.
#pragma once

#include <QSyntaxHighlighter>
#include <QTextCharFormat>

class QPalette;

namespace elsie::desktop {

class XmlHighlighter : public QSyntaxHighlighter {
 public:
  explicit XmlHighlighter(QTextDocument* document);

  /// Chooses colours that are readable on the palette's base, and highlights again.
  void use_palette(const QPalette& palette);

 protected:
  void highlightBlock(const QString& text) override;

 private:
  QTextCharFormat element_;
  QTextCharFormat attribute_;
  QTextCharFormat value_;
  QTextCharFormat comment_;
};

}  // namespace elsie::desktop
