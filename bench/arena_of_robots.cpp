#include "arena_of_robots.h"

#include <cmath>
#include <string>

namespace elsie::bench {

world::World arena_of_robots(int robots) {
  world::World world;
  world.name = "benchmark";
  world.limits.time = 1e6;
  world.teams = {{"red", {}}, {"blue", {}}};
  for (int i = 0; i < 20; ++i) {
    world::Box box;
    box.id = "b" + std::to_string(i);
    box.x = -3.6 + 1.8 * (i % 5);
    box.y = -2.7 + 1.8 * (i / 5);
    box.heading_deg = 17.0 * i;
    box.length = 0.3;
    box.width = 0.2;
    world.boxes.push_back(box);
  }
  const int side = static_cast<int>(std::ceil(std::sqrt(robots)));
  for (int i = 0; i < robots; ++i) {
    world::Robot robot;
    robot.id = "r" + std::to_string(i);
    robot.team = "red";
    robot.x = -4.5 + 9.0 * (i % side + 0.5) / side;
    robot.y = -4.5 + 9.0 * (i / side + 0.5) / side;
    robot.heading_deg = (37 * i) % 360;
    robot.battery = 1e9;
    robot.coverage = 0.0;
    for (const double azimuth : kBeamAzimuths_deg) {
      world::SensorUse beam;
      beam.plugin = "beam_range";
      beam.id = "beam" + std::to_string(robot.sensors.size());
      beam.yaw_deg = azimuth;
      robot.sensors.push_back(beam);
    }
    world::BehaviorUse avoid;
    avoid.plugin = avoid.id = "braitenberg";
    robot.behaviors.push_back(avoid);
    robot.coordinator.emplace();
    robot.coordinator->plugin = robot.coordinator->id = "arbiter_suppression";
    world.robots.push_back(robot);
  }
  return world;
}

}  // namespace elsie::bench
