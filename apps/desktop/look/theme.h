// Light and dark: the colours and the style of all windows.
#pragma once

#include <QColor>
#include <QString>

class QPalette;

namespace elsie::desktop {

/// Gives the application its style, and the palette that the user has chosen. Call it once, when
/// the application has been made.
void begin_theme();

/// "system" (as the desktop is, the default), "light" or "dark".
QString theme();
/// Stores the choice for this user, and shows it at once in all windows.
void choose_theme(const QString& name);

bool is_dark(const QPalette& palette);
/// The colour of what stands for "go".
QColor accent(const QPalette& palette);
/// The colour of thin lines between parts of a window.
QColor line_colour(const QPalette& palette);
/// The colour of words that matter less, readable on the palette's base.
QColor quiet(const QPalette& palette);

}  // namespace elsie::desktop
