// A world and its picture from above.
#pragma once

#include <string>

#include "elsie/picture/top_view.h"
#include "elsie/world/description.h"

#include "support.h"

namespace elsie::picture::test {

/// A world with its picture.
struct Stage {
  Folder folder;
  world::World world;
  TopView view{world};

  Stage() { world.teams = {{"red", Colour{220, 30, 20}}, {"blue", Colour{20, 60, 200}}}; }

  world::Robot& add_robot(const std::string& id, const std::string& team, Pose pose) {
    world::Robot robot;
    robot.id = id;
    robot.team = team;
    robot.x = pose.x;
    robot.y = pose.y;
    robot.heading_deg = degrees(pose.heading_rad);
    world.robots.push_back(robot);
    return world.robots.back();
  }
  world::Obstacle& add_obstacle(world::ObstacleKind kind, double x, double y, double edge) {
    world::Obstacle box;
    box.kind = kind;
    box.x = x;
    box.y = y;
    box.length = box.width = edge;
    world.obstacles.push_back(box);
    return world.obstacles.back();
  }
  Bitmap image(const Size& size = {}) {
    save_top_view(view, folder / "view.png", size);
    return Bitmap(folder / "view.png");
  }
  Vector2 place(double x, double y, const Size& size = {}) {
    return top_view_map(view, size).pixel({x, y});
  }
};

}  // namespace elsie::picture::test
