#include "text/code_highlighter.h"

#include <QSet>

namespace elsie::desktop {
namespace {

// States at the end of a line.
enum CodeState { kCode = -1, kBlockComment = 1, kDoubles, kSingles };  // the last two: """ and '''

const QSet<QString>& words_of(CodeHighlighter::Language language) {
  const auto split = [](const char* words) {
    const QStringList all = QString::fromLatin1(words).split(u' ');
    return QSet<QString>(all.begin(), all.end());
  };
  static const QSet<QString> cpp = split(
      "auto bool break case catch char class const constexpr continue default delete do double "
      "else "
      "enum explicit false final float for friend if inline int long mutable namespace new "
      "noexcept "
      "nullptr operator override private protected public return short signed sizeof static struct "
      "switch template this throw true try typename union unsigned using virtual void while "
      "#include #define #pragma");
  static const QSet<QString> python = split(
      "False None True and as assert break class continue def del elif else except finally for "
      "from "
      "global if import in is lambda not or pass raise return self try while with yield");
  return language == CodeHighlighter::Language::cpp ? cpp : python;
}

}  // namespace

void CodeHighlighter::set_language(Language language) {
  language_ = language;
  rehighlight();
}

void CodeHighlighter::highlightBlock(const QString& text) {
  const bool is_cpp = language_ == Language::cpp;
  const QString line_comment = is_cpp ? QStringLiteral("//") : QStringLiteral("#");
  const auto size = static_cast<int>(text.size());
  int state = previousBlockState();
  int i = 0;
  const auto until = [&](const QString& mark, const QTextCharFormat& format, int from) {
    return format_until(mark, format, text, from, i);
  };
  const auto is_part = [&](int at) { return text[at].isLetterOrNumber() || text[at] == u'_'; };
  while (i < size) {
    if (state == kBlockComment) {
      state = until(QStringLiteral("*/"), comment_, i) ? kCode : kBlockComment;
    } else if (state == kDoubles || state == kSingles) {
      const QString quotes(3, state == kDoubles ? u'"' : u'\'');
      state = until(quotes, string_, i) ? kCode : state;
    } else if (QStringView(text).mid(i).startsWith(line_comment)) {
      setFormat(i, size - i, comment_);
      i = size;
    } else if (is_cpp && QStringView(text).mid(i, 2) == u"/*") {
      state = until(QStringLiteral("*/"), comment_, i + 2) ? kCode : kBlockComment;
    } else if (text[i] == u'"' || text[i] == u'\'') {
      const QChar quote = text[i];
      const QString quotes(3, quote);
      if (!is_cpp && QStringView(text).mid(i, 3) == quotes) {
        const int open = quote == u'"' ? kDoubles : kSingles;
        state = until(quotes, string_, i + 3) ? kCode : open;
        continue;
      }
      const int start = i++;
      while (i < size && text[i] != quote) i += text[i] == u'\\' ? 2 : 1;
      i = std::min(i + 1, size);
      setFormat(start, i - start, string_);
    } else if (is_part(i) || text[i] == u'#') {
      const int start = i++;
      while (i < size && is_part(i)) ++i;
      const QString word = text.mid(start, i - start);
      if (words_of(language_).contains(word)) {
        setFormat(start, i - start, keyword_);
      } else if (word[0].isDigit()) {
        setFormat(start, i - start, detail_);
      }
    } else {
      ++i;
    }
  }
  setCurrentBlockState(state);
}

}  // namespace elsie::desktop
