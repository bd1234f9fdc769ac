// Pieces of a world on the clipboard.
#pragma once

#include <QPointF>
#include <functional>

#include "engine/elements.h"

namespace elsie::desktop {

/// The lists of objects that have a place in the arena.
inline const QStringList kPlaced{"robots", "obstacles", "resources", "chargers",
                                 "nests",  "lamps",     "patches"};

/// A number as in a file, rounded to `step`; the millimetre is as exact as a hand.
QString number(double value, double step = 0.001);

/// Half the diagonal of what an element says of its size by its attributes, m.
double room_of(const std::function<QString(const char*)>& attribute);
/// Whether no object begins so near to that place, m: in a run they stand elsewhere.
bool is_free_at_start(const Json& world, const QPointF& at, double room);

/// One element of a text that holds several.
struct Piece {
  QString name;
  QString markup;
  QString list = {};  // the list that contains it: "sensors"; "" if the text does not say
};

/// The elements of a text in their order; lists are replaced by the elements in them. Empty if the
/// text is not XML.
std::vector<Piece> pieces_of(const QString& text);
/// A text that pieces_of() reads, with an element of this list; "" if it is in none.
QString listed(const QString& markup, const QString& list);

/// The piece with this attribute in its first tag, in place of the one that it has. A null value
/// removes the attribute.
QString with_attribute(const Piece& piece, const QString& attribute, const QString& value);
/// The attribute of its first tag; "" if there is none.
QString attribute_of(const Piece& piece, const QString& attribute);

}  // namespace elsie::desktop
