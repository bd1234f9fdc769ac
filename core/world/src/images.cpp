#include "elsie/world/images.h"

#include "elsie/plugin/engine_libraries.h"

namespace elsie::world {

bool is_image(const std::string& content) {
  return content.starts_with("\x89PNG") || content.starts_with("P5") || content.starts_with("P2");
}

Image read_image(const std::string& content, int channels) {
  return reinterpret_cast<ReadImage*>(plugin::part_symbol("images", plugin::part_file("images"),
                                                          "elsie_read_image"))(content, channels);
}

}  // namespace elsie::world
