// Cells of tables of comma-separated values (RFC 4180).
#pragma once

#include <string>
#include <string_view>

namespace elsie::base {

/// The text as one cell: between double quotes when it holds a comma, a quote, the end of a line,
/// or '#', which some readers take for the start of a comment.
std::string csv_cell(std::string_view text);

}  // namespace elsie::base
