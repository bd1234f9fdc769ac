#include "bodies.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "elsie/shapes/outline.h"
#include "elsie/world/error.h"
#include "elsie/world/floor.h"
#include "elsie/world/parts.h"
#include "elsie/world/tree.h"

namespace elsie::layouts {

namespace {

constexpr double kMarkHeight = 0.1;  // m: no box stands on the mark of a charger

Footprint footprint_of(const world::Charger& charger) {
  Footprint disc;
  disc.x = charger.x;
  disc.y = charger.y;
  disc.half_length = disc.half_width = charger.radius;
  disc.top = kMarkHeight;
  disc.round = true;
  return disc;
}

Footprint footprint_of(const world::Lamp& lamp) {
  Footprint disc{.x = lamp.x, .y = lamp.y, .round = true};
  disc.half_length = disc.half_width = world::kLampRadius;
  disc.bottom = lamp.z - world::kLampRadius;
  disc.top = lamp.z + world::kLampRadius;
  return disc;
}

/// The pieces of a patch without a height: they overlap nothing.
Body body_of(const world::Patch& patch) {
  Body body;
  for (const world::FloorPiece& piece : world::pieces_of(patch)) {
    Footprint& area = body.emplace_back();
    const auto& corners = piece.corners;
    area.round = corners.empty();
    area.x = piece.middle.x;
    area.y = piece.middle.y;
    area.half_length = area.half_width = piece.radius;
    if (area.round) continue;
    for (const Vector2& corner : corners) {
      area.x += corner.x / static_cast<double>(corners.size());
      area.y += corner.y / static_cast<double>(corners.size());
    }
    for (const Vector2& corner : corners) {
      area.outline.push_back({corner.x - area.x, corner.y - area.y});
      area.half_length = std::max(area.half_length, std::abs(area.outline.back().x));
      area.half_width = std::max(area.half_width, std::abs(area.outline.back().y));
    }
  }
  return body;
}

Body body_of(const world::Robot& robot) {
  return world::footprints_of(world::plan_of(robot), {robot.x, robot.y, radians(robot.heading_deg)},
                              robot.z);
}

/// Reads the world of a tree. Bodies need not be at the places that it gives.
std::optional<world::World> read(const Drawing& drawing, Element tree, Problems& mistakes) {
  world::ReadOptions options = drawing.options;
  options.edits.clear();
  options.is_running = true;
  Problems problems;
  try {
    return world::world_of_tree(std::move(tree), drawing.file, drawing.host, drawing.files, options,
                                problems);
  } catch (const world::WorldError& error) {
    mistakes.add(error);
    return std::nullopt;
  }
}

/// A copy of the world without elements that may refer to things that are not drawn yet.
Element without(const Element& world, std::initializer_list<const char*> names) {
  Element rest;
  rest.name = world.name;
  rest.where = world.where;
  rest.attributes = world.attributes;
  std::copy_if(world.children.begin(), world.children.end(), std::back_inserter(rest.children),
               [&](const Element& child) {
                 return std::none_of(names.begin(), names.end(),
                                     [&](const char* name) { return child.name == name; });
               });
  return rest;
}

}  // namespace

double covered(const Body& body) {
  double area = 0.0;
  for (const Footprint& each : body) {
    area += !each.outline.empty()
                ? area_of(each.outline)
                : (each.round ? std::numbers::pi : 4.0) * each.half_length * each.half_width;
  }
  return area;
}

Body moved(const Body& body, double x, double y, double heading_deg) {
  const Pose pose{x, y, radians(heading_deg)};
  Body there = body;
  for (Footprint& each : there) {
    const Vector2 at = point_of(pose, {each.x, each.y});
    each.x = at.x;
    each.y = at.y;
    each.heading_rad += pose.heading_rad;
  }
  return there;
}

std::vector<Body> bodies_of(const Drawing& drawing, const std::string& list,
                            std::vector<Element> things, Problems& problems) {
  Element tree = without(
      drawing.world, {"obstacles", "resources", "chargers", "nests", "lamps", "floor", "patches",
                      "robots", "goals", "measures", "rules", "changes", "limits"});
  Element holder;
  holder.name = list;
  holder.where = drawing.world.where;
  for (Element& thing : things) {
    thing.set("x", "0", thing.where);
    thing.set("y", "0", thing.where);
    if (has_heading(thing.name)) thing.set("heading_deg", "0", thing.where);
  }
  holder.children = std::move(things);
  tree.children.push_back(std::move(holder));
  const auto world = read(drawing, std::move(tree), problems);
  std::vector<Body> bodies;
  if (world) {
    for (const world::Obstacle& box : world->obstacles) {
      bodies.push_back({world::footprint_of(box)});
    }
    for (const auto& charger : world->chargers) bodies.push_back({footprint_of(charger)});
    for (const world::Lamp& lamp : world->lamps) bodies.push_back({footprint_of(lamp)});
    for (const world::Nest& nest : world->nests) bodies.push_back(body_of(patch_of(nest)));
    for (const world::Patch& patch : world->patches) bodies.push_back(body_of(patch));
    for (const world::Robot& robot : world->robots) bodies.push_back(body_of(robot));
  }
  return bodies;
}

bool Occupied::add_world(const Drawing& drawing) {
  const auto world = read(drawing,
                          without(drawing.world, {"floor", "patches", "goals", "measures", "rules",
                                                  "changes", "limits"}),
                          drawing.problems);
  if (!world) {
    return false;
  }
  for (const world::Obstacle& box : world->obstacles) add({world::footprint_of(box)});
  for (const world::Charger& charger : world->chargers) add({footprint_of(charger)});
  for (const world::Lamp& lamp : world->lamps) add({footprint_of(lamp)});
  for (const world::Robot& robot : world->robots) add(body_of(robot));
  return true;
}

base::Grid::Block Occupied::cells(const Footprint& area) const {
  return grid_.block(area.x - area.reach(-1.0, 0.0), area.y - area.reach(0.0, -1.0),
                     area.x + area.reach(1.0, 0.0), area.y + area.reach(0.0, 1.0));
}

void Occupied::add(const Body& body) {
  for (const Footprint& each : body) {
    grid_.insert(static_cast<base::Grid::Id>(there_.size()), cells(each));
    there_.push_back(each);
  }
}

bool Occupied::has_room_for(const Body& body, double gap) const {
  return std::all_of(body.begin(), body.end(), [&](const Footprint& each) {
    const Footprint area = each.grown(gap);
    if (world::outside(arena_, "", area)) {
      return false;
    }
    const base::Grid::Block block = cells(area);
    for (int y = block.y0; y <= block.y1; ++y) {
      for (int x = block.x0; x <= block.x1; ++x) {
        for (const base::Grid::Id other : grid_.cell(x, y)) {
          if (world::overlap(area, there_[other])) return false;
        }
      }
    }
    return true;
  });
}

}  // namespace elsie::layouts
