// Tables for a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace elsie::process {

/// Lays rows of cells out in columns that are `gap` blanks apart. The first `text_columns` are
/// aligned left, the others, numbers, right. Rows may have different lengths. Width counts
/// characters of UTF-8. Cells are cleaned by files::one_line(). No line ends in blanks.
std::string laid_out(std::vector<std::vector<std::string>> rows, std::size_t text_columns,
                     std::size_t gap = 2);

}  // namespace elsie::process
