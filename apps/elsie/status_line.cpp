#include "status_line.h"

#include <csignal>
#include <cstdio>
#include <string_view>

#include <sys/ioctl.h>
#include <unistd.h>

namespace elsie::program {

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kRedraw = std::chrono::milliseconds(100);
constexpr std::string_view kWipe = "\r\033[K";

// A signal handler can only reach a global of this kind.
volatile std::sig_atomic_t is_drawn = 0;

}  // namespace

std::size_t terminal_columns(int descriptor, std::size_t otherwise) {
  constexpr std::size_t kFewest = 40;
  struct winsize size {};
  const bool terminal = isatty(descriptor) != 0 && ioctl(descriptor, TIOCGWINSZ, &size) == 0;
  return terminal && size.ws_col >= kFewest ? size.ws_col : otherwise;
}

StatusLine::StatusLine(bool is_wanted)
    : is_shown_(is_wanted && isatty(STDERR_FILENO) != 0), last_drawn_(Clock::now()) {}

bool StatusLine::is_due() const { return is_shown_ && Clock::now() - last_drawn_ >= kRedraw; }

void StatusLine::draw(const std::string& line) {
  if (!is_shown_) {
    return;
  }
  last_drawn_ = Clock::now();
  is_drawn = 1;
  // The last column stays free, because some terminals then wrap the line.
  const std::size_t columns = terminal_columns(STDERR_FILENO, 80) - 1;
  const std::string shown = line.size() <= columns ? line : line.substr(0, columns - 3) + "...";
  std::fprintf(stderr, "\r%s\033[K", shown.c_str());
  std::fflush(stderr);
}

void wipe_status() noexcept {
  if (is_drawn != 0) {
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kWipe.data(), kWipe.size());
    is_drawn = 0;
  }
}

}  // namespace elsie::program
