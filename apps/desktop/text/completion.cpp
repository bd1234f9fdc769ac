#include "text/completion.h"

#include <QRegularExpression>

namespace elsie::desktop {
namespace {

const Json& element(const Json& catalog, const QString& name) {
  return member(member(catalog, "elements"), name.toUtf8().constData());
}

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

/// All attributes of an element inside `parent`: its own, and if it is a plugin, its parameters.
std::vector<const Json*> attributes(const Json& catalog, const QString& name,
                                    const QString& parent) {
  std::vector<const Json*> all;
  const auto take = [&](const Json& list) {
    for (const Json& attribute : list) {
      all.push_back(&attribute);
    }
  };
  const QString kind = text_of(element(catalog, parent), "holds");
  take(member(element(catalog, kind.isEmpty() ? name : kind), "attributes"));
  for (const Json& plugin : member(catalog, "plugins")) {
    if (!kind.isEmpty() && text_of(plugin, "name") == name && text_of(plugin, "kind") == kind) {
      take(member(plugin, "parameters"));
    }
  }
  return all;
}

}  // namespace

Completion complete(const Json& catalog, const QString& before) {
  static const QRegularExpression value(QStringLiteral("^([\\w:.-]+)\\s*=\\s*([\"'])"));
  Completion result;
  const qsizetype start = open_tag(before);
  if (start < 0) {
    return result;
  }
  const QStringList open = open_elements(before.left(start));
  const QString parent = open.value(open.size() - 1);
  const QString tag = before.mid(start + 1);
  static const QRegularExpression blank(QStringLiteral("\\s"));
  const qsizetype name_end = tag.indexOf(blank);

  if (name_end < 0) {
    if (tag.startsWith(u'/')) {
      result.prefix = tag.mid(1);
      result.words << parent;
    } else {
      result.prefix = tag;
      const Json& declared = element(catalog, parent);
      for (const Json& child : member(declared, "children")) {
        result.words << QString::fromStdString(child.get<std::string>());
      }
      if (const QString kind = text_of(declared, "holds"); !kind.isEmpty()) {
        for (const Json& plugin : member(catalog, "plugins")) {
          if (text_of(plugin, "kind") == kind) {
            result.words << text_of(plugin, "name");
          }
        }
      }
      if (open.isEmpty()) {
        result.words << QStringLiteral("world");
      }
    }
  } else {
    // Whole attributes are removed first; the rest is an unfinished value, or part of a name.
    static const QRegularExpression whole(
        QStringLiteral("([\\w:.-]+)\\s*=\\s*(?:\"[^\"]*\"|'[^']*')"));
    const QString inside = tag.mid(name_end);
    QStringList given;
    qsizetype rest = 0;
    for (auto all = whole.globalMatch(inside); all.hasNext();) {
      const auto match = all.next();
      given << match.captured(1);
      rest = match.capturedEnd();
    }
    const QString last = inside.mid(rest).trimmed();
    const auto in_value = value.match(last);
    for (const Json* attribute : attributes(catalog, tag.left(name_end), parent)) {
      const QString name = text_of(*attribute, "name");
      if (!in_value.hasMatch()) {
        if (!given.contains(name)) {
          result.words << name;
        }
      } else if (name == in_value.captured(1)) {
        for (const Json& choice : member(*attribute, "choices")) {
          result.words << QString::fromStdString(choice.get<std::string>());
        }
        if (text_of(*attribute, "type") == u"boolean") {
          result.words << QStringLiteral("true") << QStringLiteral("false");
        }
      }
    }
    result.prefix = in_value.hasMatch() ? last.mid(in_value.capturedEnd()) : last;
  }
  result.words.removeDuplicates();
  result.words.removeAll(QString());
  result.words.sort();
  return result;
}

}  // namespace elsie::desktop
