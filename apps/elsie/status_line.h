// The status line at the bottom of a terminal.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace elsie::program {

/// The width of the terminal behind a descriptor; `otherwise` without one, or if it is too narrow.
std::size_t terminal_columns(int descriptor, std::size_t otherwise);

/// Wipes the line that is drawn, if any; also in signal handlers.
void wipe_status() noexcept;

/// A line on standard error that shows how far some work is, drawn over the one before; wiped at
/// the end.
class StatusLine {
 public:
  /// `is_wanted`: false, or no terminal, draws nothing.
  explicit StatusLine(bool is_wanted);
  ~StatusLine() { wipe_status(); }
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  bool is_shown() const { return is_shown_; }
  /// Whether it is shown and the last line was drawn a while ago.
  bool is_due() const;
  /// Draws the line, shortened with "..." to the terminal's width, because a wrapped line could not
  /// be drawn over. ASCII.
  void draw(const std::string& line);

 private:
  bool is_shown_;
  std::chrono::steady_clock::time_point last_drawn_;
};

}  // namespace elsie::program
