// Numbers and tables as plain text.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// printf-style, for one number.
std::string text(const char* format, double value);

/// Rows of cells in columns two spaces apart. The first `text_columns` stand to the left, the
/// others, numbers, to the right. Width counts characters of UTF-8.
std::string laid_out(const std::vector<std::vector<std::string>>& rows, std::size_t text_columns);
