// Numbers and tables as plain text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// printf-style, for one number.
std::string text(const char* format, double value);

/// "1 run", "2 runs".
std::string counted(std::int64_t count, const std::string& what);
/// "is" or "are".
const char* are(std::int64_t count);

/// Rows of cells in columns two spaces apart. The first `text_columns` stand to the left, the
/// others, numbers, to the right. Width counts characters of UTF-8.
std::string laid_out(const std::vector<std::vector<std::string>>& rows, std::size_t text_columns);
