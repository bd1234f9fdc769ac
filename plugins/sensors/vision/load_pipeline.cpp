#include <filesystem>
#include <stdexcept>
#include <string>

#include <dlfcn.h>

#include <elsie/plugin/own_library.h>

#include "pipeline.h"

namespace vision {

namespace {

/// The library is next to libelsie. This plugin itself may have been loaded from a copy elsewhere.
MakePipeline load() {
  const auto file = elsie::plugin::file_of_this_library().parent_path() / "libelsie-vision.so";
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const make = library ? dlsym(library, kMakePipeline) : nullptr;
  if (!make) {
    throw std::runtime_error("it needs '" + file.string() +
                             "', which cannot be loaded: " + dlerror() + "; install Elsie again");
  }
  return reinterpret_cast<MakePipeline>(make);
}

}  // namespace

std::unique_ptr<Pipeline> make_pipeline(const std::vector<Step>& steps,
                                        std::span<const elsie::Colour> resource_colours) {
  static const MakePipeline make = load();
  return std::unique_ptr<Pipeline>(make(steps, resource_colours));
}

}  // namespace vision
