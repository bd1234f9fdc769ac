#include "dangers.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "elsie/base/number_text.h"
#include "elsie/base/words.h"
#include "elsie/plugin/engine_libraries.h"
#include "elsie/plugin/parameters.h"
#include "elsie/world/engine_facts.h"
#include "elsie/world/footprint.h"
#include "elsie/world/parts.h"

namespace elsie::physics {
namespace {

constexpr double kFarthestWay = 0.5;  // of a body's length, in a step
constexpr double kSteepest = 5.0;     // ratio of the middle's height to half the base

using base::number_text;

std::string about(double value) { return number_text(value, 3); }

}  // namespace

std::optional<std::string> danger_of_speed(const std::string& name, double speed_m_s, double size_m,
                                           double step_s, const std::string& effect) {
  const double way = speed_m_s * step_s;
  if (way <= kFarthestWay * size_m) return std::nullopt;
  return name + " moves up to " + about(way) + " m in a step at " + number_text(speed_m_s) +
         " m/s, more than half its size of " + number_text(size_m) + " m" + effect +
         "; expected a step of at most " + about(kFarthestWay * size_m / speed_m_s) + " s";
}

std::optional<std::string> danger_of_height(const std::string& name, const world::Robot& robot,
                                            const std::string& effect) {
  double half_base = 0.0, half_track = 0.0;
  for (const Part& part : world::driven_plan(robot).parts) {
    if (part.role == PartRole::chassis) continue;
    half_base = std::max(half_base, std::abs(part.frame.origin.x));
    half_track = std::max(half_track, std::abs(part.frame.origin.y));
  }
  const world::RobotBody& body = robot.body;
  const double height = body.clearance + 0.5 * body.height;
  const double base = std::min(half_base, half_track);
  if (height <= kSteepest * base) return std::nullopt;
  const double most = 2.0 * (kSteepest * base - body.clearance);
  return name + " has its middle " + number_text(height) + " m above the floor on a base of " +
         about(2.0 * base) + " m" + effect + "; expected a " +
         (most > 0.0 ? "height of at most " + about(most) + " m" : "wider or longer chassis");
}

std::optional<std::string> danger_of_path(const world::World& world, const world::Obstacle& box,
                                          const std::string& effect) {
  if (!world.arena.walls || box.kind != world::ObstacleKind::moving || box.waypoints.empty()) {
    return std::nullopt;
  }
  const world::Footprint footprint = world::footprint_of(box);
  std::vector<Vector2> places{{box.x, box.y}};
  places.insert(places.end(), box.waypoints.begin(), box.waypoints.end());
  const double length = 0.5 * world.arena.length, width = 0.5 * world.arena.width;
  for (const Vector2& place : places) {
    if (place.x + footprint.reach(1.0, 0.0) > length ||
        footprint.reach(-1.0, 0.0) - place.x > length ||
        place.y + footprint.reach(0.0, 1.0) > width ||
        footprint.reach(0.0, -1.0) - place.y > width) {
      return box.in_words() + " reaches into a wall at (" + number_text(place.x) + ", " +
             number_text(place.y) + ")" + effect +
             "; expected a path that leaves room for a robot next to the wall";
    }
  }
  return std::nullopt;
}

void add_idle_parameters(const world::World& world, std::vector<world::Warning>& warnings) {
  const world::Physics& physics = world.physics;
  const world::ElementSpec& element = *world::vocabulary().child("physics");
  for (const auto& given : physics.parameters) {
    const std::string& name = given.first;
    std::vector<std::string> having = plugin::engine_names();
    std::erase_if(having, [&](const std::string& engine) {
      return !plugin::find_declared(world::engine_parameters(engine), name);
    });
    if (std::find(having.begin(), having.end(), physics.engine) != having.end()) continue;
    const world::AttributeSpec* const known = element.attribute(name);
    if (!known || given.second == known->default_value) continue;
    warnings.push_back({world::Warning::About::no_effect, 0, physics.location,
                        name + "=\"" + plugin::format_value(given.second) +
                            "\" has no effect, because the engine '" + physics.engine +
                            "' has no such parameter; expected an engine that has it: " +
                            base::enumerated(having, "or")});
  }
}

}  // namespace elsie::physics
