// The words that may be typed at a place in the text of a world, from the engine's catalog.
#pragma once

#include <QString>
#include <QStringList>

#include "engine/catalog.h"

namespace elsie::desktop {

/// The words that fit after `before`, the text up to the cursor: elements after "<", attributes
/// inside a tag (without those that it already has), choices inside the quotes of a value.
struct Completion {
  QStringList words;
  /// The part of the word that is already typed.
  QString prefix;
};

/// The text need not be complete XML.
Completion complete(const Catalog& catalog, const QString& before);

}  // namespace elsie::desktop
