// Reads JSON that another process wrote. A member that is missing or of another kind is not an
// error.
#pragma once

#include <QString>
#include <QStringList>

#include "elsie/client/connection.h"

namespace elsie::desktop {

using client::Json;

/// The member of this name; null if there is none.
const Json& member(const Json& object, const char* name);
/// The text of a member; "" if it is missing or not a text.
QString text_of(const Json& object, const char* name);
/// The number of a member; NaN if it is missing, or null, which stands for numbers that are not
/// finite.
double number_of(const Json& object, const char* name);
/// The integer of a member; `otherwise` if it is missing, not a whole number, or too large.
int integer_of(const Json& object, const char* name, int otherwise);
/// A value as written in a file: a text without its quotation marks.
QString written(const Json& value);
Json list_of(const QStringList& texts);

}  // namespace elsie::desktop
