#include "scene.h"

#include <string>
#include <utility>

#include "elsie/picture/floor_tiles.h"
#include "elsie/picture/top_view.h"
#include "elsie/world/colours.h"
#include "elsie/world/floor.h"
#include "elsie/world/parts.h"

#include "entity.h"
#include "messages.h"

namespace elsie::recording {
namespace {

using world::World;

constexpr Colour kFloor{0xf2, 0xf2, 0xf0};
constexpr Colour kInk{0x20, 0x24, 0x28};
constexpr double kSheet = 0.002;  // m, the drawn thickness of floor and marks

/// The corners of a prism: of each side of its outline the lower and the upper one.
Json corners(const Shape& prism) {
  Json points = Json::array();
  for (const Vector2& corner : prism.outline) {
    for (const double z : {-0.5 * prism.size.z, 0.5 * prism.size.z}) {
      points.push_back(position_json({corner.x, corner.y, z}));
    }
  }
  return points;
}

/// Its triangles, counter-clockwise seen from outside.
Json triangles(const Shape& prism) {
  Json indices = Json::array();
  const std::size_t n = prism.outline.size();
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    for (const std::size_t corner : {a, b, c}) indices.push_back(corner);
  };
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    add(2 * i, 2 * next, 2 * next + 1);
    add(2 * i, 2 * next + 1, 2 * i + 1);
    if (i > 0 && next > 0) {
      add(0, 2 * next, 2 * i);
      add(1, 2 * i + 1, 2 * next + 1);
    }
  }
  return indices;
}

void add_shape(Json& entity, const Shape& shape, const Frame& middle, const Colour& colour) {
  for (const auto& [piece, frame] : pieces_of(shape, middle)) {
    const bool is_prism = piece.kind == Shape::Kind::prism;
    const bool is_cylinder = piece.kind == Shape::Kind::cylinder;
    Json made{{"pose", pose_json(frame)}};
    if (is_prism) {
      made["points"] = corners(piece);
    } else {
      made["size"] = position_json(piece.size);
    }
    if (is_cylinder) made.update({{"bottom_scale", 1.0}, {"top_scale", 1.0}});
    made["color"] = colour_json(colour);
    if (is_prism) {
      made["colors"] = Json::array();
      made["indices"] = triangles(piece);
    }
    entity[is_prism                         ? "triangles"
           : is_cylinder                    ? "cylinders"
           : piece.kind == Shape::Kind::box ? "cubes"
                                            : "spheres"]
        .push_back(std::move(made));
  }
}

Json arena(std::uint64_t time_ns, const World& world) {
  const world::Arena& arena = world.arena;
  Json made = entity(time_ns, "arena", kWorldFrame);
  add_shape(made, Shape::box({arena.length, arena.width, kSheet}),
            {.origin = {0.0, 0.0, -0.5 * kSheet}}, world.floor.colour.value_or(kFloor));
  for (const world::Fixture& wall : world::walls_of(arena)) {
    add_shape(made, wall.shape, wall.frame, world::kShown.wall);
  }
  return made;
}

/// Adds a convex polygon with a colour of its own to the triangles of a list.
void add_polygon(Json& list, std::span<const Vector2> corners, double z, const Colour& colour) {
  const std::size_t first = list["points"].size();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    list["points"].push_back(position_json({corners[i].x, corners[i].y, z}));
    list["colors"].push_back(colour_json(colour));
    if (i < 2) continue;
    for (const std::size_t corner : {std::size_t{0}, i - 1, i}) {
      list["indices"].push_back(first + corner);
    }
  }
}

/// The image of the floor and its patches, each a little above those that it covers, and all below
/// the tops of chargers' marks.
Json floor_marks(std::uint64_t time_ns, const World& world) {
  constexpr int kMostTiles = 64;
  constexpr int kRound = 24;
  Json made = entity(time_ns, "floor", kWorldFrame);
  Json list{{"pose", pose_json({})},
            {"points", Json::array()},
            {"color", colour_json(kFloor)},
            {"colors", Json::array()},
            {"indices", Json::array()}};
  const std::vector<world::FloorPiece> pieces = world::patches_of(world);
  const double layer = 0.9 * kSheet / static_cast<double>(pieces.size() + 1);
  for (const picture::FloorTile& tile : picture::floor_tiles(world, kMostTiles)) {
    const Vector2 corners[] = {{tile.left, tile.bottom},
                               {tile.right, tile.bottom},
                               {tile.right, tile.top},
                               {tile.left, tile.top}};
    add_polygon(list, corners, layer, tile.colour);
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    add_polygon(list, world::outline_of(pieces[i], kRound), layer * static_cast<double>(i + 2),
                pieces[i].colour);
  }
  made["triangles"].push_back(std::move(list));
  return made;
}

/// The name of a thing, at this height above it.
Json name_json(const std::string& name, const Vector3& at) {
  return {{"pose", pose_json({.origin = at})}, {"billboard", true},          {"font_size", 0.08},
          {"scale_invariant", false},          {"color", colour_json(kInk)}, {"text", name}};
}

Json lamp(std::uint64_t time_ns, const world::Lamp& lamp) {
  Json made = entity(time_ns, "lamp/" + lamp.id, kWorldFrame);
  const Vector3 at{lamp.x, lamp.y, lamp.z};
  add_shape(made, Shape::sphere(world::kLampRadius), {.origin = at}, lamp.colour);
  made["texts"].push_back(name_json(lamp.id, at + Vector3{0.0, 0.0, 0.1}));
  return made;
}

Json charger(std::uint64_t time_ns, const world::Charger& charger) {
  Json made = entity(time_ns, "charger/" + charger.id, kWorldFrame);
  world::Fixture fixture = world::fixture_of(charger);
  if (fixture.shape.size.z == 0.0) {
    fixture.shape.size.z = kSheet;
    fixture.frame.origin.z = 0.5 * kSheet;
  }
  add_shape(made, fixture.shape, fixture.frame, world::kChargerColour);
  return made;
}

Json box(std::uint64_t time_ns, const World& world, const world::Obstacle& box) {
  const bool moves = may_move(box);
  Json made = entity(time_ns, box_frame(box.id), moves ? box_frame(box.id) : kWorldFrame);
  const world::Fixture fixture = world::fixture_of(box);
  add_shape(made, fixture.shape,
            moves ? Frame{.origin = {0.0, 0.0, 0.5 * fixture.shape.size.z}} : fixture.frame,
            world::box_colour(world, box, world::kShown));
  const Pose start = picture::start_of(box);
  const Json place{start.x, start.y, start.heading_rad};
  made["metadata"].push_back({{"key", kStart}, {"value", text_of(place)}});
  return made;
}

/// "wagon" of the part "wagon/chassis".
std::string vehicle_name(const BodyPlan& plan, std::size_t vehicle) {
  for (const Part& part : plan.parts) {
    if (part.vehicle == vehicle) return part.name.substr(0, part.name.rfind('/'));
  }
  return {};
}

void add_robot(Json& entities, std::uint64_t time_ns, const World& world,
               const world::Robot& robot) {
  const Colour colour = world::robot_colour(world, robot);
  const BodyPlan plan = world::plan_of(robot);
  std::vector<Json> vehicles{entity(time_ns, robot_frame(robot.id), robot_frame(robot.id))};
  for (std::size_t i = 1; i < plan.vehicles(); ++i) {
    const std::string frame = segment_frame(robot.id, vehicle_name(plan, i));
    vehicles.push_back(entity(time_ns, frame, frame));
  }
  for (const Part& part : plan.parts) {
    add_shape(vehicles[part.vehicle], part.shape, part.frame,
              part.role == PartRole::chassis ? colour : world::kShown.tyre);
  }
  vehicles[0]["texts"].push_back(name_json(robot.id, {0.0, 0.0, robot.body.top() + 0.08}));
  for (Json& vehicle : vehicles) entities.push_back(std::move(vehicle));
}

}  // namespace

bool may_move(const world::Obstacle& box) {
  return box.is_dynamic() || box.kind == world::ObstacleKind::moving;
}

Json scene_message(std::uint64_t time_ns, const simulation::Simulation& simulation,
                   std::span<const std::size_t> robots) {
  const World& world = simulation.world();
  Json entities = Json::array();
  entities.push_back(arena(time_ns, world));
  if (world.floor.pixels || !world.patches.empty() || !world.nests.empty()) {
    entities.push_back(floor_marks(time_ns, world));
  }
  for (const world::Lamp& each : world.lamps) {
    entities.push_back(lamp(time_ns, each));
  }
  for (const world::Charger& each : world.chargers) {
    entities.push_back(charger(time_ns, each));
  }
  for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
    if (simulation.obstacle(i)) {
      entities.push_back(box(time_ns, world, world.obstacles[i]));
    }
  }
  for (const std::size_t place : robots) {
    add_robot(entities, time_ns, world, world.robots[place]);
  }
  constexpr int kAll = 1;  // foxglove.SceneEntityDeletionType
  Json deletions = Json::array();
  deletions.push_back({{"timestamp", time_json(time_ns)}, {"type", kAll}, {"id", ""}});
  return {{"deletions", std::move(deletions)}, {"entities", std::move(entities)}};
}

Json transforms_message(std::uint64_t time_ns, const simulation::Simulation& simulation,
                        std::span<const std::size_t> robots) {
  const World& world = simulation.world();
  Json transforms = Json::array();
  for (const std::size_t i : robots) {
    const world::Robot& robot = world.robots[i];
    const Pose& pose = simulation.robot(i).pose;
    transforms.push_back(
        transform_json(time_ns, robot_frame(robot.id), frame_of(pose), pose.heading_rad));
    if (simulation.segments(i) == 0) continue;
    const BodyPlan plan = world::plan_of(robot);
    for (std::size_t k = 0; k < simulation.segments(i); ++k) {
      const simulation::SegmentView segment = simulation.segment(i, k);
      transforms.push_back(transform_json(time_ns,
                                          segment_frame(robot.id, vehicle_name(plan, k + 1)),
                                          segment.frame, segment.pose.heading_rad));
    }
  }
  for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
    const world::Obstacle& box = world.obstacles[i];
    if (!may_move(box)) {
      continue;
    }
    if (const auto pose = simulation.obstacle(i)) {
      transforms.push_back(
          transform_json(time_ns, box_frame(box.id), frame_of(*pose, box.z), pose->heading_rad));
    }
  }
  return {{"transforms", std::move(transforms)}};
}

}  // namespace elsie::recording
