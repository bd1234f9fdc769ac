#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "text.h"
#include "top_view_parts.h"

namespace elsie::picture {
namespace {

Rect box_symbol(const Vector2& at) { return {at.x - 8, at.y - 6, 16, 12}; }

// Boxes of this kind that were not removed.
template <class Predicate>
bool any_box(const Scene& scene, world::ObstacleKind kind, Predicate predicate) {
  for (std::size_t i = 0; i < scene.world.obstacles.size(); ++i) {
    const world::Obstacle& box = scene.world.obstacles[i];
    if (box.kind == kind && scene.boxes[i] && predicate(box, *scene.boxes[i])) return true;
  }
  return false;
}

/// What the boxes of a kind are called: some may have another shape.
std::string noun_of(const Scene& scene, world::ObstacleKind kind) {
  return any_box(
             scene, kind,
             [](const world::Obstacle& box, const Pose&) { return box.shape != ObstacleShape{}; })
             ? "obstacle"
             : "box";
}

bool has_obstacle(const Scene& scene, world::ObstacleKind kind) {
  return any_box(scene, kind, [](const world::Obstacle&, const Pose&) { return true; });
}

template <class Predicate>
bool any_robot(const Scene& scene, Predicate predicate) {
  return std::any_of(scene.robots.begin(), scene.robots.end(),
                     [&](const DrawnRobot& robot) { return predicate(robot.track); });
}

// "path, from its start", "path from 20 s to 40 s", "path of the last 30 s".
std::string path_in_words(const PathChoice& choice) {
  if (choice.fade_s > 0.0) {
    return "path of the last " + number_text(choice.fade_s) + " s" +
           (std::isfinite(choice.to_s) ? " before " + number_text(choice.to_s) + " s" : "");
  }
  const std::string end = number_text(choice.to_s) + " s";
  if (std::isfinite(choice.to_s)) {
    return choice.from_s > 0.0 ? "path from " + number_text(choice.from_s) + " s to " + end
                               : "path up to " + end;
  }
  if (choice.from_s > 0.0) return "path from " + number_text(choice.from_s) + " s on";
  return "path, from its start";
}

void add_robots(const Scene& scene, std::vector<LegendEntry>& entries) {
  const bool crowd = scene.is_crowd();
  std::vector<std::string> teams;
  for (const DrawnRobot& robot : scene.robots) {
    if (std::find(teams.begin(), teams.end(), robot.team_id) != teams.end()) continue;
    teams.push_back(robot.team_id);
    const std::string name =
        robot.team_id.empty() ? "robot" : "robot, team " + clean_text(robot.team_id, 24);
    entries.push_back({name, 32, [colour = robot.team, crowd](Canvas& canvas, const Vector2& at) {
                         crowd ? draw_crowd_symbol(canvas, at, colour)
                               : draw_robot_symbol(canvas, {at.x - 4, at.y}, 0.0, colour);
                       }});
  }
  if (any_robot(scene, [](const RobotTrack& track) { return track.path.size() > 1; })) {
    const auto drawn =
        std::find_if(scene.robots.begin(), scene.robots.end(),
                     [](const DrawnRobot& robot) { return robot.track.path.size() > 1; });
    const Ink colour = drawn->team;
    const bool begins = !(scene.paths.fade_s > 0.0);
    std::string text = path_in_words(scene.paths);
    const bool marks = scene.mark_every_s > 0.0;
    if (marks) text += ", a mark every " + number_text(scene.mark_every_s) + " s";
    entries.push_back({text, 34, [colour, marks, begins, crowd](Canvas& canvas, const Vector2& at) {
                         if (crowd) {
                           draw_crowd_path_symbol(canvas, at, colour);
                           return;
                         }
                         canvas.line({at.x - 13, at.y}, {at.x + 13, at.y});
                         canvas.stroke(colour, {.width = 2});
                         if (begins) {
                           canvas.rectangle({at.x - 16.5, at.y - 3.5, 7, 7}).fill_keep(kPaper);
                           canvas.stroke(colour, {.width = 1.8});
                         }
                         if (!marks) return;
                         canvas.circle({at.x + 4, at.y}, 3).fill_keep(kPaper);
                         canvas.stroke(colour, {.width = 1.5});
                       }});
  }
  add_sketches(scene, entries);
  if (any_robot(scene, [](const RobotTrack& track) { return track.believed.has_value(); })) {
    entries.push_back({"where a robot believes it is", 34,
                       [colour = scene.robots.front().team](Canvas& canvas, const Vector2& at) {
                         canvas.line({at.x - 15, at.y}, {at.x - 4, at.y});
                         canvas.stroke(colour, {.width = 1.6, .dash = {0.1, 4}, .round = true});
                         canvas.circle({at.x + 6, at.y}, 7.5);
                         canvas.stroke(colour, {.width = 1.4, .dash = {3, 2}});
                       }});
  }
  if (any_robot(scene, [](const RobotTrack& track) { return !track.touches.empty(); })) {
    entries.push_back({"touch", 20, [crowd](Canvas& canvas, const Vector2& at) {
                         crowd ? draw_crowd_touch_symbol(canvas, at) : draw_touch(canvas, at);
                       }});
  }
}

void add_boxes(const Scene& scene, std::vector<LegendEntry>& entries) {
  if (has_obstacle(scene, world::ObstacleKind::fixed)) {
    entries.push_back({"static " + noun_of(scene, world::ObstacleKind::fixed), 20,
                       [](Canvas& canvas, const Vector2& at) {
                         canvas.rectangle(box_symbol(at)).fill_keep(kFixedBox);
                         canvas.stroke(kFixedEdge, {.width = 1});
                       }});
  }
  if (has_obstacle(scene, world::ObstacleKind::dynamic)) {
    const bool moved = any_box(scene, world::ObstacleKind::dynamic,
                               [](const world::Obstacle& box, const Pose& now) {
                                 return std::hypot(now.x - box.x, now.y - box.y) > 0.01;
                               });
    entries.push_back({"dynamic " + noun_of(scene, world::ObstacleKind::dynamic) +
                           (moved ? ", dashed where it started" : ""),
                       32, [moved](Canvas& canvas, const Vector2& at) {
                         if (moved) {
                           canvas.rectangle(box_symbol({at.x - 5, at.y}));
                           canvas.stroke(kDynamicEdge, {.width = 1, .dash = {3, 2}});
                         }
                         const Rect now = box_symbol({at.x + 7, at.y});
                         canvas.rectangle(now);
                         fill_hatched(canvas, now, kDynamicBox, kDynamicEdge);
                         canvas.rectangle(now).stroke(kDynamicEdge, {.width = 1.2});
                       }});
  }
  if (has_obstacle(scene, world::ObstacleKind::moving)) {
    const bool ways =
        any_box(scene, world::ObstacleKind::moving,
                [](const world::Obstacle& box, const Pose&) { return !box.waypoints.empty(); });
    entries.push_back(
        {"moving " + noun_of(scene, world::ObstacleKind::moving) + (ways ? " and its way" : ""), 34,
         [ways](Canvas& canvas, const Vector2& at) {
           if (ways) {
             canvas.line({at.x, at.y}, {at.x + 16, at.y});
             canvas.stroke(kMovingEdge, {.width = 1.6, .dash = {0.1, 4}, .round = true});
           }
           const Rect box = box_symbol({at.x - 7, at.y});
           canvas.rectangle(box).fill_keep(kMovingBox);
           canvas.stroke(kMovingEdge, {.width = 1.2});
         }});
  }
  const world::Obstacle* resource = nullptr;
  bool there = false, collected = false, delivered = false;
  for (std::size_t i = 0; i < scene.world.obstacles.size(); ++i) {
    if (scene.world.obstacles[i].kind != world::ObstacleKind::resource) continue;
    resource = &scene.world.obstacles[i];
    (scene.boxes[i] ? there : resource->to_nest ? delivered : collected) = true;
  }
  if (!resource) return;
  const Ink colour = resource_ink(scene.world, *resource);
  if (there) {
    entries.push_back({"resource", 20, [colour](Canvas& canvas, const Vector2& at) {
                         canvas.rectangle({at.x - 7, at.y - 7, 14, 14}).fill(colour);
                         draw_resource_mark(canvas, at, 4.5, kPaper);
                       }});
  }
  if (collected || delivered) {
    const char* const gone = !delivered   ? "collected"
                             : !collected ? "delivered"
                                          : "collected or delivered";
    entries.push_back({gone, 20, [colour](Canvas& canvas, const Vector2& at) {
                         canvas.rectangle({at.x - 7, at.y - 7, 14, 14}).fill_keep(kPaper);
                         canvas.stroke(colour, {.width = 1.3, .dash = {3, 2}});
                       }});
  }
}

void add_nests(const Scene& scene, std::vector<LegendEntry>& entries) {
  std::vector<std::string> teams;
  for (const world::Nest& nest : scene.world.nests) {
    if (std::find(teams.begin(), teams.end(), nest.team) != teams.end()) continue;
    teams.push_back(nest.team);
    const std::string whose = nest.team.empty() ? "" : ", team " + clean_text(nest.team, 24);
    entries.push_back({"nest" + whose, 20,
                       [ground = ink(nest.colour), edge = nest_edge(scene.world, nest)](
                           Canvas& canvas, const Vector2& at) {
                         canvas.circle(at, 8).fill_keep(ground);
                         canvas.stroke(edge, {.width = kNestEdge});
                       }});
  }
}

void add_marks(const Scene& scene, std::vector<LegendEntry>& entries) {
  add_nests(scene, entries);
  if (!scene.world.chargers.empty()) {
    const Ink colour = team_ink(scene.world, scene.world.chargers.front().team);
    entries.push_back({"charger", 20, [colour](Canvas& canvas, const Vector2& at) {
                         canvas.circle(at, 9).fill_keep(mix(kPaper, colour, 0.18));
                         canvas.stroke(colour, {.width = 1.4});
                         draw_bolt(canvas, at, 7, colour);
                       }});
  }
  if (!scene.world.lamps.empty()) {
    const Ink light = ink(scene.world.lamps.front().colour);
    entries.push_back(
        {"lamp", 24, [light](Canvas& canvas, const Vector2& at) { draw_sun(canvas, at, light); }});
  }
  const auto shining =
      std::find_if(scene.robots.begin(), scene.robots.end(),
                   [](const DrawnRobot& robot) { return !robot.track.lights.empty(); });
  if (shining != scene.robots.end()) {
    const Ink light = ink(shining->track.lights.front().colour);
    entries.push_back({"lit lamp of a robot", 24, [light](Canvas& canvas, const Vector2& at) {
                         draw_sun(canvas, at, light);
                       }});
  }
  for (const FloorField& field : scene.fields) {
    const double solid = field.solid();
    if (!(solid > 0.0)) continue;
    entries.push_back({clean_text(field.id, 24) + ", up to " + number_text(solid) + " per m2", 34,
                       [colour = ink(field.colour)](Canvas& canvas, const Vector2& at) {
                         for (int i = 0; i < 8; ++i) {
                           canvas.rectangle({at.x - 16 + 4 * i, at.y - 6, 4, 12})
                               .fill(colour.with_alpha(0.85 * (i + 1) / 8));
                         }
                       }});
  }
  bool places = false;
  world::for_each_goal(scene.world.goals, [&](const world::Goal& goal) {
    places |= std::holds_alternative<world::ReachGoal>(goal) ||
              std::holds_alternative<world::PushGoal>(goal);
  });
  if (places) {
    entries.push_back({"goal", 20, [](Canvas& canvas, const Vector2& at) {
                         canvas.circle(at, 9).fill_keep(kGoal.with_alpha(0.08));
                         canvas.stroke(kGoal, {.width = 1.6, .dash = {4, 3}});
                       }});
  }
}

}  // namespace

std::vector<LegendEntry> legend_of(const Scene& scene) {
  std::vector<LegendEntry> entries;
  if (scene.bare) return entries;
  add_robots(scene, entries);
  add_boxes(scene, entries);
  add_marks(scene, entries);
  return entries;
}

}  // namespace elsie::picture
