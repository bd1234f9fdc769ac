#include "elsie/picture/bodies.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "elsie/world/files.h"
#include "elsie/world/tree.h"

namespace elsie::picture {

namespace {

using world::Element;

// Leaves out goals about time and events, also in groups.
void leave_places_only(Element& goals) {
  std::erase_if(goals.children, [](Element& goal) {
    if (goal.name != "any" && goal.name != "all") {
      return goal.name == "endure" || goal.name == "event";
    }
    leave_places_only(goal);
    return goal.children.empty();
  });
}

// Leaves only the parts that a picture of the arena shows, goals at places included.
void leave_bodies_only(Element& root, const plugin::Host& drives) {
  const auto drop = [](Element& from, std::initializer_list<std::string_view> parts) {
    std::erase_if(from.children, [&](const Element& part) {
      return std::find(parts.begin(), parts.end(), part.name) != parts.end();
    });
  };
  drop(root, {"limits", "measures", "rules", "changes"});
  if (Element* goals = root.child("goals")) leave_places_only(*goals);
  if (Element* robots = root.child("robots")) {
    for (Element& robot : robots->children) {
      drop(robot, {"sensors", "actuators", "behaviors", "coordinator", "localisation"});
      const Element* drive = robot.child("drive");
      if (drive && !drive->children.empty() &&
          !drives.find(PluginKind::drive, drive->children.front().name)) {
        drop(robot, {"drive"});
      }
    }
  }
}

// An image of the floor that is no longer there is left out.
void leave_out_missing_image(Element& root, const world::Files& files) {
  Element* const floor = root.child("floor");
  const world::Attribute* const image = floor ? floor->find("image") : nullptr;
  if (image && !files.find(image->value, image->where)) {
    for (const char* name : {"image", "image_length", "image_width"}) floor->erase(name);
  }
}

}  // namespace

world::World bodies_of(std::string_view text, const std::string& file, const plugin::Host& drives) {
  Element root = world::tree_of_world(text, file);
  const world::Files files(file, {});
  world::Problems problems;
  world::merge_templates(root, drives, files, problems);
  leave_bodies_only(root, drives);
  leave_out_missing_image(root, files);
  return world::world_of_tree(std::move(root), file, drives, files, {}, problems);
}

}  // namespace elsie::picture
