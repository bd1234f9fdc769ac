#include "text/completion.h"

#include <QRegularExpression>

namespace elsie::desktop {
namespace {

/// The elements that are open at the end of the text, outermost first.
QStringList open_elements(const QString& text) {
  static const QRegularExpression tag(
      QStringLiteral("<!--.*?(-->|$)|<(/?)([\\w:.-]+)((?:\"[^\"]*\"|'[^']*'|[^>\"'])*?)(/?)>"),
      QRegularExpression::DotMatchesEverythingOption);
  QStringList open;
  for (auto tags = tag.globalMatch(text); tags.hasNext();) {
    const QRegularExpressionMatch match = tags.next();
    const QString name = match.captured(3);
    if (name.isEmpty() || !match.captured(5).isEmpty()) {
      continue;
    }
    if (match.captured(2).isEmpty()) {
      open << name;
    } else if (const auto place = open.lastIndexOf(name); place >= 0) {
      open = open.mid(0, place);
    }
  }
  return open;
}

/// Where the tag begins that contains the end of the text; -1 outside of tags and in comments.
qsizetype open_tag(const QString& text) {
  qsizetype start = -1;
  QChar quote;
  for (qsizetype i = 0; i < text.size(); ++i) {
    const QChar c = text[i];
    if (start < 0 && QStringView(text).mid(i).startsWith(u"<!--")) {
      i = text.indexOf(QStringLiteral("-->"), i + 4);
      if (i < 0) {
        return -1;
      }
      i += 2;
    } else if (start < 0) {
      start = c == u'<' ? i : -1;
    } else if (!quote.isNull()) {
      quote = c == quote ? QChar() : quote;
    } else if (c == u'"' || c == u'\'') {
      quote = c;
    } else if (c == u'>') {
      start = -1;
    } else if (c == u'<') {
      start = i;
    }
  }
  return start;
}

/// The names of the elements that may stand in the last of these, each of which stands in the one
/// before.
QStringList elements_in(const Catalog& catalog, const QStringList& open) {
  if (open.isEmpty()) {
    return {QStringLiteral("world")};
  }
  QStringList names;
  for (const Kind& each : catalog.members(open.back())) names << each.name;
  if (const auto kind = catalog.kind_of(open)) {
    names << kind->elements;
    if (kind->holds_behaviors)
      names << QStringLiteral("behaviors") << QStringLiteral("coordinator");
  }
  return names;
}

/// The words that fit into a tag after the element's name: attributes, or within quotation marks
/// the values of the attribute. Sets the part that is typed already.
QStringList words_in_tag(const Kind& kind, const QString& inside, QString& prefix) {
  // Whole attributes are removed first; the rest is an unfinished value, or part of a name.
  static const QRegularExpression whole(
      QStringLiteral("([\\w:.-]+)\\s*=\\s*(?:\"[^\"]*\"|'[^']*')"));
  static const QRegularExpression value(QStringLiteral("^([\\w:.-]+)\\s*=\\s*([\"'])"));
  QStringList given;
  qsizetype rest = 0;
  for (auto all = whole.globalMatch(inside); all.hasNext();) {
    const auto match = all.next();
    given << match.captured(1);
    rest = match.capturedEnd();
  }
  const QString last = inside.mid(rest).trimmed();
  const auto in_value = value.match(last);
  prefix = in_value.hasMatch() ? last.mid(in_value.capturedEnd()) : last;
  QStringList words;
  if (!in_value.hasMatch()) {
    for (const Field& field : kind.fields) words << field.name;
    if (kind.can_be_removed) words << QStringLiteral("remove");
    words.removeIf([&](const QString& word) { return given.contains(word); });
    return words;
  }
  for (const Field& field : kind.fields) {
    if (field.name == in_value.captured(1)) {
      words << field.choices;
      if (field.type == u"boolean") words << QStringLiteral("true") << QStringLiteral("false");
    }
  }
  return words;
}

}  // namespace

Completion complete(const Catalog& catalog, const QString& before) {
  Completion result;
  const qsizetype start = open_tag(before);
  if (start < 0) {
    return result;
  }
  const QStringList open = open_elements(before.left(start));
  const QString tag = before.mid(start + 1);
  static const QRegularExpression blank(QStringLiteral("\\s"));
  const qsizetype name_end = tag.indexOf(blank);
  if (tag.startsWith(u'/')) {
    result.prefix = tag.mid(1);
    result.words << open.value(open.size() - 1);
  } else if (name_end < 0) {
    result.prefix = tag;
    result.words = elements_in(catalog, open);
  } else if (const auto kind = catalog.kind_of(open + QStringList{tag.left(name_end)})) {
    result.words = words_in_tag(*kind, tag.mid(name_end), result.prefix);
  }
  result.words.removeDuplicates();
  result.words.removeAll(QString());
  result.words.sort();
  return result;
}

}  // namespace elsie::desktop
