// The pictures of commands and elements.
#pragma once

#include <QIcon>
#include <QString>

namespace elsie::desktop {

/// The drawing look/icons/NAME.svg in the colours of the palette of the moment, so that it fits
/// light and dark windows, and pale where it is disabled. An empty icon if there is no such
/// drawing: the button then shows its text.
QIcon icon(const QString& name);

}  // namespace elsie::desktop
