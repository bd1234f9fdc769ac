// Numbers and tables as plain text.
#pragma once

#include <cstdint>
#include <string>

#include "elsie/report/text_table.h"

using elsie::report::laid_out;

/// printf-style, for one number.
std::string text(const char* format, double value);

/// "1 run", "2 runs".
std::string counted(std::int64_t count, const std::string& what);
/// "is" or "are".
const char* are(std::int64_t count);
