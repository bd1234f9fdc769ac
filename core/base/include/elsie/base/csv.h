// Cells of comma-separated values (RFC 4180).
#pragma once

#include <string>
#include <string_view>

namespace elsie::base {

/// The text as one cell. It is quoted when it holds a comma, a quote, an end of line, or '#', which
/// some readers take for the start of a comment.
std::string csv_cell(std::string_view text);

}  // namespace elsie::base
