#include "engine/compiler_messages.h"

#include <QRegularExpression>

namespace elsie::desktop {

Problems problems_in(const QString& message) {
  // "pace.cpp:13:7: error: expected ';'", and "(pace.py, line 13)" or "File "pace.py", line 13".
  static const QRegularExpression compiler(
      QStringLiteral("^(\\S[^:\\n]*):(\\d+):(?:\\d+:)? (?:fatal )?error: (.*)$"),
      QRegularExpression::MultilineOption);
  static const QRegularExpression python(
      QStringLiteral("(?:File \"([^\"\\n]+)\"|\\(([^(\\n]+\\.py)), line (\\d+)"));
  Problems problems;
  for (auto all = compiler.globalMatch(message); all.hasNext();) {
    const auto found = all.next();
    problems.push_back({found.captured(1), found.captured(2).toInt(), found.captured(3)});
  }
  if (problems.empty()) {
    QRegularExpressionMatch last;
    for (auto all = python.globalMatch(message); all.hasNext();) last = all.next();
    problems.push_back({last.captured(1) + last.captured(2), last.captured(3).toInt(), message});
  }
  return problems;
}

}  // namespace elsie::desktop
