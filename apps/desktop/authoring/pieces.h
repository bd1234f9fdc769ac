// Pieces of a world on the clipboard.
#pragma once

#include "engine/elements.h"

namespace elsie::desktop {

/// One element of a text that holds several.
struct Piece {
  QString name;
  QString markup;
};

/// The elements of a text, one after the other. Empty if it is no XML.
std::vector<Piece> pieces_of(const QString& text);

/// The piece with this attribute in its first tag instead of the one that it has. A null value
/// takes the attribute away.
QString with_attribute(const Piece& piece, const QString& attribute, const QString& value);
/// "" if its first tag has no such attribute.
QString attribute_of(const Piece& piece, const QString& attribute);

}  // namespace elsie::desktop
