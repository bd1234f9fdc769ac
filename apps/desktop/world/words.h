// The names of world files in words.
#pragma once

#include <QString>

namespace elsie::desktop {

/// A name of a world file as users read it: "Max speed" for "max_speed", without the unit that it
/// may end in: "Heading" for "heading_deg" in deg. In the language of the window if that has a word
/// for it.
QString in_words(const QString& name, const QString& unit = {});
/// A unit as users read it: "°" for "deg".
QString unit_in_words(const QString& unit);

}  // namespace elsie::desktop
