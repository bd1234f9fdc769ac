// The language of the windows' texts.
#pragma once

#include <QString>
#include <QStringList>

namespace elsie::desktop {

/// The languages that there are, by their codes: "en", and each that has a translation.
QStringList languages();
/// A language in its own words: "Deutsch".
QString name_of_language(const QString& code);
/// "system" (the user's, the default), or one of languages().
QString language();
/// Stores the choice for this user. Windows that are opened from then on have it.
void choose_language(const QString& code);
/// Shows all texts of windows that are made from now on in that language, Qt's own, too. Numbers
/// keep their decimal point.
void begin_language();

}  // namespace elsie::desktop
