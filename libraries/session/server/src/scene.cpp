#include "scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <variant>

#include "elsie/files/clean_text.h"
#include "elsie/world/colours.h"
#include "elsie/world/floor.h"
#include "elsie/world/parts.h"

namespace elsie::server {
namespace {

Json json(const Vector3& vector) { return {vector.x, vector.y, vector.z}; }

Json json(const Frame& frame) {
  return {json(frame.origin), json(frame.forward), json(frame.left), json(frame.up)};
}

Json json(const Shape& shape, const Frame& frame, const Colour& colour, int body) {
  Json made{{"shape", Shape::kKinds.at(static_cast<std::size_t>(shape.kind))},
            {"axis", Shape::kAxes.at(static_cast<std::size_t>(shape.axis))},
            {"size", json(shape.size)},
            {"frame", json(frame)},
            {"colour", {colour.red, colour.green, colour.blue}},
            {"body", body}};
  for (const Vector2& corner : shape.outline) {
    made["outline"].push_back(Json::array({corner.x, corner.y}));
  }
  return made;
}

/// The floor without its patches; the window reads the file of the image itself.
Json floor_json(const world::World& world) {
  Json floor = Json::object();
  if (const auto& colour = world.floor.colour) {
    floor["colour"] = {colour->red, colour->green, colour->blue};
  }
  if (world.floor.pixels) {
    const Vector2 size = world::image_size(world);
    floor["image"] = world.floor.image_file;
    floor["image_size"] = {size.x, size.y};
  }
  return floor;
}

const char* name_of(PartRole role) {
  return role == PartRole::chassis ? "chassis" : role == PartRole::wheel ? "wheel" : "caster";
}

const char* group_of(const world::Obstacle& box) {
  return box.kind == world::ObstacleKind::resource ? "resource" : "obstacle";
}

std::string path(const char* group, const std::string& id) {
  return std::string(group) + "[" + id + "]";
}

/// A patch as a flat disc, or as flat prisms. All have the patch's own frame, which an edit of its
/// place moves.
void list_patch(const world::Patch& patch, const char* group, Json& shapes) {
  constexpr int kRound = 32;
  const Frame frame = Frame::turned({patch.x, patch.y, 0.0}, radians(patch.heading_deg), 0.0);
  for (const world::FloorPiece& piece : world::pieces_of(patch)) {
    Shape flat = Shape::pillar(patch.radius, 0.0);
    if (patch.shape != world::PatchShape::disc) {
      std::vector<Vector2> outline = world::outline_of(piece, kRound);
      for (Vector2& corner : outline) {
        const Vector3 away = Vector3{corner.x, corner.y, 0.0} - frame.origin;
        corner = {dot(away, frame.forward), dot(away, frame.left)};
      }
      flat = Shape::prism(std::move(outline), 0.0);
    }
    shapes.push_back(json(flat, frame, piece.colour, -1));
    shapes.back()["path"] = path(group, patch.id);
  }
}

/// The places of goals. Those in the frame of a robot have its body.
Json goals_json(const simulation::Simulation& simulation) {
  std::map<std::string, int, std::less<>> bodies;
  int body = 0;
  for (const world::Robot& robot : simulation.world().robots) {
    bodies[robot.id] = body;
    body += static_cast<int>(world::plan_of(robot).vehicles());
  }
  Json goals = Json::array();
  const auto add = [&](double x, double y, double radius, int of, const std::string& whose) {
    goals.push_back(
        {{"at", {x, y}}, {"radius", radius}, {"body", of}, {"whose", files::one_line(whose)}});
  };
  world::for_each_goal(simulation.world().goals, [&](const world::Goal& goal) {
    if (const auto* reach = std::get_if<world::ReachGoal>(&goal)) {
      const auto of = bodies.find(reach->of);
      add(reach->x, reach->y, reach->radius, of == bodies.end() ? -1 : of->second,
          reach->robot.empty() ? reach->team : reach->robot);
    } else if (const auto* push = std::get_if<world::PushGoal>(&goal)) {
      add(push->x, push->y, push->radius, -1, push->obstacle);
    }
  });
  return goals;
}

/// Where the sensors of a robot are mounted, and where they look.
void list_sensors(const simulation::Simulation& simulation, std::size_t robot, int body,
                  Json& sensors) {
  for (std::size_t i = 0; i < simulation.sensors(robot); ++i) {
    const simulation::SensorView sensor = simulation.sensor(robot, i);
    const Mounting& at = *sensor.mounting;
    sensors.push_back({{"path", path("robot", simulation.world().robots[robot].id) + '/' +
                                    path("sensor", std::string(sensor.id))},
                       {"body", body + at.segment},
                       {"frame", json(Frame::turned(at.position, at.azimuth_rad, at.pitch_rad))}});
  }
}

bool has_actuators(const world::World& world) {
  return std::any_of(world.robots.begin(), world.robots.end(),
                     [](const world::Robot& robot) { return !robot.actuators.empty(); });
}

}  // namespace

Json scene_json(const simulation::Simulation& simulation) {
  const world::World& world = simulation.world();
  Json bodies = Json::array(), shapes = Json::array(), sensors = Json::array();
  int body = -1;
  for (const world::Nest& nest : world.nests) list_patch(world::patch_of(nest), "nest", shapes);
  for (const world::Patch& patch : world.patches) list_patch(patch, "patch", shapes);
  for (const world::Lamp& lamp : world.lamps) {
    shapes.push_back(json(Shape::sphere(world::kLampRadius), {.origin = {lamp.x, lamp.y, lamp.z}},
                          lamp.colour, body));
    shapes.back()["path"] = path("lamp", lamp.id);
  }
  for (const world::Fixture& wall : world::walls_of(world.arena)) {
    shapes.push_back(json(wall.shape, wall.frame, world::kShown.wall, body));
    shapes.back()["role"] = "wall";
  }
  for (const world::Charger& charger : world.chargers) {
    const world::Fixture fixture = world::fixture_of(charger);
    shapes.push_back(json(fixture.shape, fixture.frame, world::kChargerColour, body));
    shapes.back()["path"] = path("charger", charger.id);
  }
  for (std::size_t i = 0; i < world.robots.size(); ++i) {
    const world::Robot& robot = world.robots[i];
    const BodyPlan plan = world::plan_of(robot);
    const Colour colour = world::robot_colour(world, robot);
    for (std::size_t vehicle = 0; vehicle < plan.vehicles(); ++vehicle) {
      ++body;
      bodies.push_back({{"path", path("robot", robot.id)}, {"vehicle", vehicle}});
      if (vehicle == 0) {
        bodies.back()["coverage"] = robot.coverage;
        list_sensors(simulation, i, body, sensors);
      }
      for (const Part& part : world::vehicle_of(plan, vehicle)) {
        shapes.push_back(json(part.shape, part.frame,
                              part.role == PartRole::chassis ? colour : world::kShown.tyre, body));
        shapes.back()["role"] = name_of(part.role);
      }
    }
  }
  for (const world::Obstacle& box : world.obstacles) {
    const Shape shape = world::fixture_of(box).shape;
    bodies.push_back({{"path", path(group_of(box), box.id)}});
    shapes.push_back(json(shape, {.origin = {0.0, 0.0, 0.5 * shape.size.z}},
                          world::box_colour(world, box, world::kShown), ++body));
  }
  return {{"arena", {world.arena.length, world.arena.width}},
          {"floor", floor_json(world)},
          {"has_fields", !world.fields.empty()},
          {"has_actuators", has_actuators(world)},
          {"goals", goals_json(simulation)},
          {"sensors", std::move(sensors)},
          {"bodies", std::move(bodies)},
          {"shapes", std::move(shapes)}};
}

Json lights_json(const simulation::Simulation& simulation) {
  Json lights = Json::array();
  for (std::size_t i = 0; i < simulation.robots(); ++i) {
    for (std::size_t k = 0; k < simulation.actuators(i); ++k) {
      const simulation::ActuatorView actuator = simulation.actuator(i, k);
      if (!actuator.shine) continue;
      lights.push_back(json(Shape::sphere(world::kLampRadius), {.origin = actuator.frame.origin},
                            *actuator.shine, -1));
      lights.back()["path"] = path("robot", simulation.robot(i).description->id);
    }
  }
  return lights;
}

std::vector<std::string> body_names(const world::World& world) {
  std::vector<std::string> names;
  for (const world::Robot& robot : world.robots) {
    for (std::size_t i = 0; i < world::plan_of(robot).vehicles(); ++i) {
      names.push_back(path("robot", robot.id) + " " + std::to_string(i));
    }
  }
  for (const world::Obstacle& box : world.obstacles) {
    names.push_back(path(group_of(box), box.id));
  }
  return names;
}

void place_bodies(const simulation::Simulation& simulation,
                  std::vector<snapshots::BodyState>& bodies) {
  bodies.clear();
  for (std::size_t i = 0; i < simulation.robots(); ++i) {
    const Pose& pose = simulation.robot(i).pose;
    bodies.push_back(
        snapshots::BodyState::of(Frame::turned({pose.x, pose.y, 0.0}, pose.heading_rad, 0.0)));
    for (std::size_t k = 0; k < simulation.segments(i); ++k) {
      bodies.push_back(snapshots::BodyState::of(simulation.segment(i, k).frame));
    }
  }
  const std::vector<world::Obstacle>& obstacles = simulation.world().obstacles;
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const auto pose = simulation.obstacle(i);
    bodies.push_back({});
    if (pose) {
      bodies.back() = snapshots::BodyState::of(
          Frame::turned({pose->x, pose->y, obstacles[i].z}, pose->heading_rad, 0.0));
    }
    bodies.back().present = pose ? 1.0F : 0.0F;
  }
}

}  // namespace elsie::server
