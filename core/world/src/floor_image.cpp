#include <stdexcept>

#include "elsie/plugin/error.h"
#include "elsie/world/files.h"
#include "elsie/world/images.h"
#include "elsie/world/markup.h"

#include "reading.h"

namespace elsie::world {

void read_floor_image(World& world, const Element& root, const World* before, const Files& files,
                      Problems& problems) {
  const Element* const element = root.child("floor");
  const Attribute* const image = element ? element->find("image") : nullptr;
  Floor& floor = world.floor;
  if (!image || floor.image.empty()) {
    if (floor.image_length || floor.image_width) {
      problems.add(floor.location,
                   "<floor> gives the size of an image, but has no image; expected image=\"...\"");
    }
    return;
  }
  if (before && before->floor.pixels && before->floor.image == floor.image) {
    floor.pixels = before->floor.pixels;
    floor.image_file = before->floor.image_file;
    return;
  }
  const auto refuse = [&](const std::string& why) {
    problems.add(image->where, in_words(*image, *element) + ": " + why);
  };
  const auto file = files.find(image->value, image->where);
  if (!file) return refuse(files.why_not(image->where, image->name, image->value));
  try {
    const std::string content = read_text(*file);
    if (!is_image(content)) return refuse("expected a PNG or PGM image; the file is neither");
    floor.pixels = std::make_shared<const Image>(read_image(content, 3));
    floor.image_file = Files::absolute(*file);
    floor.image = files.name_for_world(*file, image->value);
  } catch (const WorldError& error) {
    problems.add(error);
  } catch (const plugin::PluginError&) {
    throw;  // not about the file
  } catch (const std::runtime_error& error) {
    refuse(std::string("the file ") + error.what());
  }
}

}  // namespace elsie::world
