#include "status_line.h"

#include <cstdio>

#include <sys/ioctl.h>
#include <unistd.h>

namespace elsie::program {

std::size_t terminal_columns(int descriptor, std::size_t otherwise) {
  constexpr std::size_t kFewest = 40;
  struct winsize size {};
  const bool terminal = isatty(descriptor) != 0 && ioctl(descriptor, TIOCGWINSZ, &size) == 0;
  return terminal && size.ws_col >= kFewest ? size.ws_col : otherwise;
}

std::string cut_to(const std::string& line, std::size_t columns) {
  return line.size() <= columns ? line : line.substr(0, columns - 3) + "...";
}

void draw_status(const std::string& line) {
  // The last column stays free, because some terminals then wrap the line.
  const std::size_t columns = terminal_columns(STDERR_FILENO, 80) - 1;
  std::fprintf(stderr, "\r%s\033[K", cut_to(line, columns).c_str());
  std::fflush(stderr);
}

void wipe_status() {
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
}

}  // namespace elsie::program
