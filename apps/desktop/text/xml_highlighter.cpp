#include "text/xml_highlighter.h"

#include <QPalette>

namespace elsie::desktop {
namespace {

// States at the end of a line; -1 means the text between tags.
enum State { kText = -1, kComment = 1, kTag, kDouble, kSingle };

}  // namespace

XmlHighlighter::XmlHighlighter(QTextDocument* document) : QSyntaxHighlighter(document) {
  element_.setFontWeight(QFont::DemiBold);
  comment_.setFontItalic(true);
}

void XmlHighlighter::use_palette(const QPalette& palette) {
  const bool dark = palette.color(QPalette::Base).lightnessF() < 0.5F;
  element_.setForeground(QColor(dark ? 0x7cb7ff : 0x0b4fa3));
  attribute_.setForeground(QColor(dark ? 0xd9b36c : 0x7a4b00));
  value_.setForeground(QColor(dark ? 0x8fd18f : 0x1f6b2a));
  comment_.setForeground(QColor(dark ? 0x9a9a9a : 0x666666));
  rehighlight();
}

void XmlHighlighter::highlightBlock(const QString& text) {
  int state = previousBlockState();
  int i = 0;
  const int size = static_cast<int>(text.size());
  // Formats up to the end of `mark`; returns whether it was found in this line.
  const auto until = [&](const QString& mark, const QTextCharFormat& format, int from) {
    const auto found = static_cast<int>(text.indexOf(mark, from));
    const int end = found < 0 ? size : found + static_cast<int>(mark.size());
    setFormat(i, end - i, format);
    i = end;
    return found >= 0;
  };
  while (i < size) {
    if (state == kComment) {
      state = until(QStringLiteral("-->"), comment_, i) ? kText : kComment;
    } else if (state == kDouble || state == kSingle) {
      state = until(state == kDouble ? QStringLiteral("\"") : QStringLiteral("'"), value_, i)
                  ? kTag
                  : state;
    } else if (state == kTag) {
      if (text[i] == u'"' || text[i] == u'\'') {
        state = text[i] == u'"' ? kDouble : kSingle;
        setFormat(i++, 1, value_);
      } else if (text[i] == u'>') {
        setFormat(i++, 1, element_);
        state = kText;
      } else {
        setFormat(i, 1, text[i] == u'/' || text[i] == u'?' ? element_ : attribute_);
        ++i;
      }
    } else if (text.mid(i, 4) == u"<!--") {
      state = until(QStringLiteral("-->"), comment_, i + 4) ? kText : kComment;
    } else if (text[i] == u'<') {
      const int start = i++;
      while (i < size && !text[i].isSpace() && text[i] != u'>') {
        ++i;
      }
      setFormat(start, i - start, element_);
      state = kTag;
    } else {
      ++i;
    }
  }
  setCurrentBlockState(state);
}

}  // namespace elsie::desktop
