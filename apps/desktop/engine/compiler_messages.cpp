#include "engine/compiler_messages.h"

#include <QRegularExpression>

namespace elsie::desktop {

// "pace.cpp:13:7: error: expected ';'"
std::optional<CompilerLine> compiler_line(const QString& text) {
  static const QRegularExpression pattern(
      QStringLiteral("^(\\S[^:]*):(\\d+):(?:\\d+:)?\\s*((?:fatal )?error|warning|note): (.*)$"));
  const auto match = pattern.match(text);
  if (!match.hasMatch()) {
    return std::nullopt;
  }
  return CompilerLine{match.captured(1), match.captured(2).toInt(), match.captured(4),
                      match.captured(3).endsWith(QLatin1String("error"))};
}

Problems problems_in(const QString& message) {
  // "/home/me/pace.py: pace.py:13: SyntaxError", or with 'pace.py' in quotes.
  static const QRegularExpression refused(
      QStringLiteral("^(?:[^'\n]*')?([^'\n]+?\\.py)(?::|') [^\n:]+\\.py:(\\d+): "),
      QRegularExpression::MultilineOption);
  // "(pace.py, line 13)" or "File "pace.py", line 13".
  static const QRegularExpression python(
      QStringLiteral("(?:File \"([^\"\\n]+)\"|\\(([^(\\n]+\\.py)), line (\\d+)"));
  Problems problems;
  for (const QString& text : message.split(u'\n')) {
    const auto found = compiler_line(text);
    if (found && found->is_error) problems.push_back({found->file, found->line, found->what});
  }
  if (const auto match = refused.match(message); problems.empty() && match.hasMatch()) {
    problems.push_back({match.captured(1), match.captured(2).toInt(), message});
  }
  if (problems.empty()) {
    QRegularExpressionMatch last;
    for (auto all = python.globalMatch(message); all.hasNext();) last = all.next();
    problems.push_back({last.captured(1) + last.captured(2), last.captured(3).toInt(), message});
  }
  return problems;
}

}  // namespace elsie::desktop
