#include "drawing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "elsie/api/geometry.h"
#include "elsie/base/number_text.h"

namespace elsie::layouts {

using base::number_text;

double rounded_m(double metres) { return std::round(metres * 1e4) / 1e4 + 0.0; }

double rounded_deg(double degrees) {
  const double hundredths = std::round(std::remainder(degrees, 360.0) * 100.0);
  return hundredths / 100.0 + 0.0;
}

std::size_t drawn_index(Random& random, std::size_t count) {
  return std::min(count - 1,
                  static_cast<std::size_t>(random.uniform() * static_cast<double>(count)));
}

bool Drawing::refuse(const Location& where, const std::string& id, const std::string& problem) {
  problems.add(where, "the layout '" + id + "' " + problem);
  return false;
}

bool Drawing::require_inside(const Area& area, const Location& where, const std::string& id) {
  constexpr double kHair = 1e-9;  // m
  const double x = std::abs(area.x) + 0.5 * area.length, y = std::abs(area.y) + 0.5 * area.width;
  if (x <= 0.5 * arena.length + kHair && y <= 0.5 * arena.width + kHair) {
    return true;
  }
  return refuse(where, id,
                "reaches from (" + number_text(rounded_m(area.left())) + ", " +
                    number_text(rounded_m(area.bottom())) + ") to (" +
                    number_text(rounded_m(area.x + 0.5 * area.length)) + ", " +
                    number_text(rounded_m(area.y + 0.5 * area.width)) +
                    "), outside of the arena, which reaches to (" +
                    number_text(0.5 * arena.length) + ", " + number_text(0.5 * arena.width) +
                    "); make it smaller, or move it");
}

void Drawing::add(const std::string& list, Element element) {
  Element* holder = world.child(list);
  if (!holder) {
    Element made;
    made.name = list;
    made.where = element.where;
    world.children.push_back(std::move(made));
    holder = &world.children.back();
  }
  if (layout) element.object = layout->object;
  holder->children.push_back(std::move(element));
}

void Drawing::add_obstacle(const std::string& id, const Area& area, double heading_deg,
                           double height, const Location& where) {
  Element box;
  box.name = "static_box";
  box.where = where;
  box.set("id", id, where);
  const auto set = [&](const char* name, double value) {
    box.set(name, number_text(value), where);
  };
  set("x", rounded_m(area.x));
  set("y", rounded_m(area.y));
  if (heading_deg != 0.0) set("heading_deg", rounded_deg(heading_deg));
  set("length", rounded_m(area.length));
  set("width", rounded_m(area.width));
  set("height", rounded_m(height));
  add("obstacles", std::move(box));
}

void Drawing::add_wall(const std::string& id, const Wall& wall, double thickness, double height,
                       const Location& where) {
  const double dx = wall.x2 - wall.x1, dy = wall.y2 - wall.y1;
  add_obstacle(id,
               {0.5 * (wall.x1 + wall.x2), 0.5 * (wall.y1 + wall.y2),
                std::hypot(dx, dy) + thickness, thickness},
               degrees(std::atan2(dy, dx)), height, where);
}

const char* list_of(const std::string& name) {
  for (const world::ElementSpec& group : world::vocabulary().children) {
    if (group.group && group.name != "layouts" && group.child(name)) return group.name.c_str();
  }
  return nullptr;
}

bool has_heading(const std::string& name) {
  return world::vocabulary().child(list_of(name))->child(name)->attribute("heading_deg");
}

}  // namespace elsie::layouts
