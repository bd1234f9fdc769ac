// Reads JSON that another process wrote: what is not there, or is of another kind, is no error.
#pragma once

#include <QString>
#include <QStringList>

#include "elsie/client/connection.h"

namespace elsie::desktop {

using client::Json;

/// The member of this name, or null.
const Json& member(const Json& object, const char* name);
/// "" if there is none, or it is no text.
QString text_of(const Json& object, const char* name);
/// NaN if there is none, or it is null: such numbers were not finite.
double number_of(const Json& object, const char* name);
/// `otherwise` if there is none, or it is no whole number that fits.
int integer_of(const Json& object, const char* name, int otherwise);
/// A value as a file has it: a text without its quotation marks.
QString written(const Json& value);
Json list_of(const QStringList& texts);

}  // namespace elsie::desktop
