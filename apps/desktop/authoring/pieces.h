// Pieces of a world on the clipboard.
#pragma once

#include "engine/elements.h"

namespace elsie::desktop {

/// Lists of things that stand in the arena.
inline const QStringList kPlaced{"robots", "obstacles", "resources", "chargers"};

/// As a file has it, to the millimetre or another step: what a hand can do.
QString number(double value, double step = 0.001);

/// One element of a text that holds several.
struct Piece {
  QString name;
  QString markup;
  QString list = {};  // in which it is: "sensors"; "" if the text does not say
};

/// The elements of a text, one after the other; of those that are lists, the elements in them.
/// Empty if it is no XML.
std::vector<Piece> pieces_of(const QString& text);
/// A text that pieces_of() reads, of an element in this list; "": in none.
QString listed(const QString& markup, const QString& list);

/// The piece with this attribute in its first tag instead of the one that it has. A null value
/// takes the attribute away.
QString with_attribute(const Piece& piece, const QString& attribute, const QString& value);
/// "" if its first tag has no such attribute.
QString attribute_of(const Piece& piece, const QString& attribute);

}  // namespace elsie::desktop
