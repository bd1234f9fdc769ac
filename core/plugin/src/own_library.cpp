#include "elsie/plugin/own_library.h"

#include <dlfcn.h>

namespace elsie::plugin {

namespace fs = std::filesystem;

const void* place_in_this_library() noexcept {
  static const char here = 0;  // its address is in this library
  return &here;
}

fs::path file_of_this_library() {
  static const fs::path file = [] {  // dladdr() reads all symbols of the library
    Dl_info info{};
    const bool known = dladdr(place_in_this_library(), &info) != 0 && info.dli_fname;
    return known ? fs::path(info.dli_fname) : fs::path();
  }();
  return file;
}

}  // namespace elsie::plugin
