// The line at the bottom of a terminal that tells how far something is.
#pragma once

#include <cstddef>
#include <string>

namespace elsie::program {

/// Columns of the terminal behind a file descriptor; `otherwise` when it is none, or too narrow to
/// be believed.
std::size_t terminal_columns(int descriptor, std::size_t otherwise);

/// The line, with "..." in the place of what does not fit into so many columns (at least 4): one
/// that went on below could not be drawn over. ASCII.
std::string cut_to(const std::string& line, std::size_t columns);

/// Draws it on standard error, over the one before.
void draw_status(const std::string& line);
/// Leaves an empty line.
void wipe_status();

}  // namespace elsie::program
