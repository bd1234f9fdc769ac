#include "text/xml_highlighter.h"

namespace elsie::desktop {
namespace {

// States at the end of a line; -1 means the text between tags.
enum State { kText = -1, kComment = 1, kTag, kDouble, kSingle };

}  // namespace

void XmlHighlighter::highlightBlock(const QString& text) {
  int state = previousBlockState();
  int i = 0;
  const int size = static_cast<int>(text.size());
  const auto until = [&](const QString& mark, const QTextCharFormat& format, int from) {
    return format_until(mark, format, text, from, i);
  };
  while (i < size) {
    if (state == kComment) {
      state = until(QStringLiteral("-->"), comment_, i) ? kText : kComment;
    } else if (state == kDouble || state == kSingle) {
      state = until(state == kDouble ? QStringLiteral("\"") : QStringLiteral("'"), string_, i)
                  ? kTag
                  : state;
    } else if (state == kTag) {
      if (text[i] == u'"' || text[i] == u'\'') {
        state = text[i] == u'"' ? kDouble : kSingle;
        setFormat(i++, 1, string_);
      } else if (text[i] == u'>') {
        setFormat(i++, 1, keyword_);
        state = kText;
      } else {
        setFormat(i, 1, text[i] == u'/' || text[i] == u'?' ? keyword_ : detail_);
        ++i;
      }
    } else if (text.mid(i, 4) == u"<!--") {
      state = until(QStringLiteral("-->"), comment_, i + 4) ? kText : kComment;
    } else if (text[i] == u'<') {
      const int start = i++;
      while (i < size && !text[i].isSpace() && text[i] != u'>') {
        ++i;
      }
      setFormat(start, i - start, keyword_);
      state = kTag;
    } else {
      ++i;
    }
  }
  setCurrentBlockState(state);
}

}  // namespace elsie::desktop
