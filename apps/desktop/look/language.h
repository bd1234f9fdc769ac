// The language of the windows' texts.
#pragma once

#include <QString>
#include <QStringList>

namespace elsie::desktop {

/// The languages that there are, by their codes: "en", and each that has a translation.
QStringList languages();
/// What a language is called in its own words ("Deutsch"), in the language of the windows, and in
/// English.
QStringList names_of_language(const QString& code);
/// The English of a text that a window has shown, in any case and with or without the marks of a
/// menu; the text itself if it is none.
QString english_of(const QString& text);
/// "system" (the user's, the default), or one of languages().
QString language();
/// Stores the choice for this user. Windows that are opened from then on have it.
void choose_language(const QString& code);
/// Shows all texts of windows that are made from now on in that language, Qt's own, too. Numbers
/// keep their decimal point.
void begin_language();

}  // namespace elsie::desktop
