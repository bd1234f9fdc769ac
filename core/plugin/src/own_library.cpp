#include "elsie/plugin/own_library.h"

#include <dlfcn.h>

#include "elsie/plugin/search_path.h"

namespace elsie::plugin {

std::filesystem::path file_of_this_library() {
  Dl_info info{};
  const void* const here = &kPluginPathVariable;
  return dladdr(here, &info) != 0 && info.dli_fname ? std::filesystem::path(info.dli_fname)
                                                    : std::filesystem::path();
}

}  // namespace elsie::plugin
