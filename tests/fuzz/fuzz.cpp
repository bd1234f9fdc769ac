#include "fuzz.h"

#include <cstdlib>
#include <vector>

#include <sys/mman.h>
#include <unistd.h>

namespace elsie::fuzz {

std::filesystem::path file_of(const std::uint8_t* data, std::size_t size) {
  static const int file = memfd_create("input", 0);
  if (file < 0 || ftruncate(file, 0) != 0 ||
      pwrite(file, data, size, 0) != static_cast<ssize_t>(size)) {
    std::abort();
  }
  return "/proc/self/fd/" + std::to_string(file);
}

const plugin::Host& plugins() {
  static const plugin::Host host(
      std::vector<plugin::SearchDirectory>{{plugin_folder(), "the build tree"}});
  return host;
}

std::string plugin_folder() { return ELSIE_PLUGIN_DIR; }

std::string source_folder() { return ELSIE_SOURCE_DIR; }

}  // namespace elsie::fuzz
