#include "text/highlighter.h"

#include <QPalette>

namespace elsie::desktop {

Highlighter::Highlighter(QTextDocument* document) : QSyntaxHighlighter(document) {
  keyword_.setFontWeight(QFont::DemiBold);
  comment_.setFontItalic(true);
}

void Highlighter::use_palette(const QPalette& palette) {
  const bool dark = palette.color(QPalette::Base).lightnessF() < 0.5F;
  keyword_.setForeground(QColor(dark ? 0x7cb7ff : 0x0b4fa3));
  detail_.setForeground(QColor(dark ? 0xd9b36c : 0x7a4b00));
  string_.setForeground(QColor(dark ? 0x8fd18f : 0x1f6b2a));
  comment_.setForeground(QColor(dark ? 0x9a9a9a : 0x666666));
  rehighlight();
}

bool Highlighter::format_until(const QString& mark, const QTextCharFormat& format,
                               const QString& line, int from, int& at) {
  const auto found = line.indexOf(mark, from);
  const auto end = static_cast<int>(found < 0 ? line.size() : found + mark.size());
  setFormat(at, end - at, format);
  at = end;
  return found >= 0;
}

}  // namespace elsie::desktop
