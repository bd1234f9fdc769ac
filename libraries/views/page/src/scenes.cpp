#include "scenes.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "elsie/files/base64.h"
#include "elsie/files/clean_text.h"
#include "elsie/picture/image_file.h"
#include "elsie/render/world_scene.h"
#include "elsie/world/colours.h"
#include "elsie/world/parts.h"

namespace elsie::page {
namespace {

using nlohmann::ordered_json;

constexpr int kFixed = -1;  // the body of what stays

double short_number(double value) { return std::round(value * 1e5) / 1e5; }

ordered_json list(const Vector3& v) {
  return {short_number(v.x), short_number(v.y), short_number(v.z)};
}
ordered_json list(const Vector2& v) { return {short_number(v.x), short_number(v.y)}; }
ordered_json list(const Colour& colour) { return {colour.red, colour.green, colour.blue}; }
ordered_json list(const std::vector<Vector2>& outline) {
  ordered_json corners = ordered_json::array();
  for (const Vector2& corner : outline) corners.push_back(list(corner));
  return corners;
}

/// Its axes as columns, then its origin.
ordered_json list(const Frame& frame) {
  ordered_json numbers = ordered_json::array();
  for (const Vector3* v : {&frame.forward, &frame.left, &frame.up, &frame.origin}) {
    for (const double number : {v->x, v->y, v->z}) numbers.push_back(short_number(number));
  }
  return numbers;
}

/// Which body moves each solid of a scene.
class Movers {
 public:
  explicit Movers(const render::Scene& scene)
      : boxes(scene.boxes.size(), kFixed),
        prisms(scene.prisms.size(), kFixed),
        cylinders(scene.cylinders.size(), kFixed),
        balls(scene.balls.size(), kFixed) {}

  void take(const render::WorldScene::Body& pieces, std::size_t body) {
    for (const render::Placed& piece : pieces) {
      auto& movers = piece.kind == Shape::Kind::box        ? boxes
                     : piece.kind == Shape::Kind::prism    ? prisms
                     : piece.kind == Shape::Kind::cylinder ? cylinders
                                                           : balls;
      movers[piece.index] = static_cast<int>(body);
    }
  }

  std::vector<int> boxes, prisms, cylinders, balls;
};

/// An image in at most so many pixels in either direction, by leaving out rows and columns.
std::string image_text(const Image& image) {
  constexpr int kMost = 1024;
  const int skip = std::max((std::max(image.width, image.height) + kMost - 1) / kMost, 1);
  Image small{image.width / skip, image.height / skip, image.channels, {}};
  for (int row = 0; row < small.height; ++row) {
    for (int column = 0; column < small.width; ++column) {
      const std::size_t pixel =
          static_cast<std::size_t>(row * skip) * static_cast<std::size_t>(image.width) +
          static_cast<std::size_t>(column * skip);
      const auto channels = static_cast<std::size_t>(image.channels);
      for (std::size_t i = 0; i < channels; ++i) {
        small.bytes.push_back(image.bytes[pixel * channels + i]);
      }
    }
  }
  return "data:image/png;base64," + files::base64(picture::png(small));
}

ordered_json robot_json(const world::World& world, const world::Robot& robot, Bodies& bodies) {
  const BodyPlan plan = world::plan_of(robot);
  const Part& chassis = plan.parts.front();
  double top = 0.0;
  for (const Part& part : world::vehicle_of(plan, 0)) {
    top = std::max(top, part.frame.origin.z + world::reach_of(part).z);
  }
  return {{"id", files::one_line(robot.id)},
          {"team", files::one_line(robot.team)},
          {"body", bodies.number(Bodies::robot(robot.id))},
          {"colour", list(world::robot_colour(world, robot))},
          {"size", list(chassis.shape.size)},
          {"middle", list(Vector2{chassis.frame.origin.x, chassis.frame.origin.y})},
          {"round", chassis.shape.is_round()},
          {"top", short_number(top)},
          {"deck", short_number(chassis.frame.origin.z + 0.5 * chassis.shape.size.z)}};
}

/// Places that goals, nests and robots' tasks name: circles on the floor.
ordered_json places_json(const world::World& world) {
  ordered_json places = ordered_json::array();
  const auto add = [&](double x, double y, double radius, const std::string& name) {
    places.push_back({{"at", list(Vector2{x, y})}, {"radius", radius}, {"name", name}});
  };
  world::for_each_goal(world.goals, [&](const world::Goal& goal) {
    if (const auto* reach = std::get_if<world::ReachGoal>(&goal); reach && reach->of.empty()) {
      add(reach->x, reach->y, reach->radius, "goal");
    } else if (const auto* push = std::get_if<world::PushGoal>(&goal)) {
      add(push->x, push->y, push->radius, "goal for " + files::one_line(push->obstacle));
    }
  });
  for (const world::Nest& nest : world.nests) {
    add(nest.x, nest.y, nest.radius, files::one_line(nest.id));
  }
  return places;
}

}  // namespace

std::string scene_text(const world::World& world, Bodies& bodies,
                       std::vector<std::string>& images) {
  render::WorldScene whole(world, render::Viewer::person);
  Movers movers(whole.scene());
  for (std::size_t i = 0; i < world.robots.size(); ++i) {
    const std::string& id = world.robots[i].id;
    const Frame frame{.origin = {0.0, 0.0, world.robots[i].z}};
    whole.place_robot(i, frame);
    movers.take(whole.robots()[i][0], bodies.number(Bodies::robot(id)));
    for (std::size_t k = 0; k + 1 < whole.robots()[i].size(); ++k) {
      whole.place_segment(i, k, frame);
      movers.take(whole.robots()[i][k + 1], bodies.number(Bodies::segment(id, k)));
    }
  }
  for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
    whole.place_box(i, Frame{.origin = {0.0, 0.0, world.obstacles[i].z}});
    movers.take(whole.boxes()[i], bodies.number(Bodies::box(world.obstacles[i].id)));
  }

  const render::Scene& scene = whole.scene();
  ordered_json json{{"arena", {world.arena.length, world.arena.width}},
                    {"walls", world.arena.walls ? world.arena.wall_height : 0.0}};
  if (world.floor.colour) json["floor"] = list(*world.floor.colour);
  if (scene.image.pixels) {
    const std::string png = image_text(*scene.image.pixels);
    const auto known = std::find(images.begin(), images.end(), png);
    json["image"] = {{"size", list(scene.image.size)}, {"png", known - images.begin()}};
    if (known == images.end()) images.push_back(png);
  }
  const auto add = [&](const char* name, const auto& solids, const std::vector<int>& of,
                       const auto& size_of, const auto& frame_of) {
    ordered_json all = ordered_json::array();
    for (std::size_t i = 0; i < solids.size(); ++i) {
      all.push_back({{"body", of[i]},
                     {"frame", list(frame_of(solids[i]))},
                     {"size", size_of(solids[i])},
                     {"colour", list(solids[i].colour)}});
    }
    json[name] = std::move(all);
  };
  const auto own = [](const auto& solid) { return solid.frame; };
  add(
      "boxes", scene.boxes, movers.boxes, [](const auto& box) { return list(box.size); }, own);
  add(
      "prisms", scene.prisms, movers.prisms,
      [](const auto& prism) {
        return ordered_json{short_number(prism.height), list(prism.outline)};
      },
      own);
  add(
      "cylinders", scene.cylinders, movers.cylinders,
      [](const auto& each) {
        return list(Vector2{each.radius, each.length});
      },
      own);
  add(
      "balls", scene.balls, movers.balls,
      [](const auto& ball) { return short_number(ball.radius); },
      [](const auto& ball) { return Frame{.origin = ball.middle}; });
  json["patches"] = ordered_json::array();
  for (const render::FlatPatch& patch : scene.patches) {
    json["patches"].push_back({{"outline", list(patch.outline)}, {"colour", list(patch.colour)}});
  }
  json["marks"] = ordered_json::array();
  for (const render::Mark& mark : scene.marks) {
    json["marks"].push_back({{"at", list(mark.at)},
                             {"radius", short_number(mark.radius)},
                             {"colour", list(mark.colour)}});
  }
  json["robots"] = ordered_json::array();
  for (const world::Robot& robot : world.robots) {
    json["robots"].push_back(robot_json(world, robot, bodies));
  }
  json["places"] = places_json(world);
  return json.dump();
}

}  // namespace elsie::page
