// The status line at the bottom of a terminal.
#pragma once

#include <cstddef>
#include <string>

namespace elsie::program {

/// The width of the terminal behind a descriptor; `otherwise` without one, or if it is too narrow.
std::size_t terminal_columns(int descriptor, std::size_t otherwise);

/// The line, shortened with "..." to this many columns (at least 4), because a wrapped line could
/// not be drawn over. ASCII.
std::string cut_to(const std::string& line, std::size_t columns);

/// Draws the line on standard error, over the one before.
void draw_status(const std::string& line);
/// Clears the line.
void wipe_status();

}  // namespace elsie::program
