#include "authoring/pieces.h"

#include <QRegularExpression>
#include <QXmlStreamReader>
#include <algorithm>
#include <cmath>

#include "scene/stage.h"

namespace elsie::desktop {
namespace {

constexpr double kLeast_m = 0.2;  // the size of an object that does not give it

QRegularExpressionMatch match_of(const Piece& piece, const QString& attribute) {
  // Values may contain '>', so they are skipped as a whole.
  const QRegularExpression form(
      "^<[^\\s/>]+(?:\\s+[^\\s=]+\\s*=\\s*(?:\"[^\"]*\"|'[^']*'))*?(\\s+" +
      QRegularExpression::escape(attribute) + "\\s*=\\s*(?:\"([^\"]*)\"|'([^']*)'))");
  return form.match(piece.markup);
}

}  // namespace

QString number(double value, double step) {
  const double rounded = std::round(value / step) * step;
  return QString::number(rounded == 0.0 ? 0.0 : rounded, 'g', 9);
}

std::vector<Piece> pieces_of(const QString& text) {
  const QString before = "<pieces>";
  const QString whole = before + text + "</pieces>";
  QXmlStreamReader reader(whole);
  std::vector<Piece> pieces;
  int depth = 0;
  QString list;
  // Where the token before this one ended; the reader may have looked ahead by one character.
  qint64 last = 0;
  qint64 start = 0;
  const auto is_piece = [&](int at) { return at == (list.isEmpty() ? 2 : 3); };
  while (!reader.atEnd()) {
    const auto token = reader.readNext();
    if (token == QXmlStreamReader::StartElement) {
      const QString name = reader.name().toString();
      if (++depth == 2) {
        list = member_word(name).isEmpty() ? QString() : name;
      }
      if (is_piece(depth)) {
        start = whole.indexOf('<', last - 1);
        pieces.push_back({name, {}, list});
      }
    } else if (token == QXmlStreamReader::EndElement) {
      if (is_piece(depth--)) {
        const qint64 end = whole.indexOf('>', reader.characterOffset() - 1) + 1;
        pieces.back().markup = whole.mid(start, end - start);
      }
    }
    last = reader.characterOffset();
  }
  return reader.hasError() ? std::vector<Piece>() : pieces;
}

QString listed(const QString& markup, const QString& list) {
  return list.isEmpty() ? markup : '<' + list + '>' + markup + "</" + list + '>';
}

QString with_attribute(const Piece& piece, const QString& attribute, const QString& value) {
  QString markup = piece.markup;
  const QString written =
      value.isNull() ? QString() : ' ' + attribute + "=\"" + escaped(value) + '"';
  const QRegularExpressionMatch match = match_of(piece, attribute);
  if (match.hasMatch()) {
    return markup.replace(match.capturedStart(1), match.capturedLength(1), written);
  }
  return markup.insert(1 + piece.name.size(), written);
}

QString attribute_of(const Piece& piece, const QString& attribute) {
  const QRegularExpressionMatch match = match_of(piece, attribute);
  return match.captured(match.capturedStart(2) >= 0 ? 2 : 3);
}

double room_of(const std::function<QString(const char*)>& attribute) {
  const auto side = [&](const char* name) {
    return std::max(attribute(name).toDouble(), kLeast_m);
  };
  return 0.5 * std::hypot(side("length"), side("width"));
}

bool is_free_at_start(const Json& world, const QPointF& at, double room) {
  bool is_free = true;
  visit(world, [&](const ElementPlace& place) {
    const QString list = place.parent ? name_of(*place.parent) : QString();
    if (!place.list.isEmpty() || !kPlaced.contains(list) || Stage::is_bodiless(place.path)) {
      return is_free;
    }
    const auto given = [&](const char* name) { return attribute(*place.element, name); };
    const QPointF by = at - QPointF(given("x").toDouble(), given("y").toDouble());
    is_free = is_free && std::hypot(by.x(), by.y()) > room + room_of(given);
    return false;
  });
  return is_free;
}

}  // namespace elsie::desktop
