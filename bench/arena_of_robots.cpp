#include "arena_of_robots.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace elsie::bench {
namespace {

constexpr double kBase = 10.0;    // rad/s
constexpr double kWeight = 12.0;  // rad/s

/// The weights of a beam for the left and right wheel.
WheelRates weights(double azimuth_deg) {
  const double ahead = std::max(0.0, std::cos(radians(azimuth_deg)));
  const double own = 0.5 * kWeight * ahead;
  const double other = -1.5 * kWeight * ahead;
  return azimuth_deg > 0 ? WheelRates{own, other} : WheelRates{other, own};
}

}  // namespace

WheelRates steer(const double* ranges_m) {
  static const auto matrix = [] {
    std::array<WheelRates, kBeamAzimuths_deg.size()> all;
    std::transform(kBeamAzimuths_deg.begin(), kBeamAzimuths_deg.end(), all.begin(), weights);
    return all;
  }();
  static const double most = world::Robot().max_speed / world::RobotBody().wheel_radius;
  WheelRates rates{kBase, kBase};
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    rates += (1.0 - ranges_m[i] / kBeamRange_m) * matrix[i];
  }
  const double largest = std::max(std::abs(rates.left), std::abs(rates.right));
  return largest > most ? (most / largest) * rates : rates;
}

std::vector<Pose> poses_of(const world::World& arena) {
  std::vector<Pose> poses;
  for (const world::Robot& robot : arena.robots) {
    poses.push_back({robot.x, robot.y, radians(robot.heading_deg)});
  }
  return poses;
}

world::World arena_of_robots(int robots) {
  world::World world;
  world.name = "benchmark";
  world.limits.time = 1e6;
  world.teams = {{"red", {}}, {"blue", {}}};
  // Twenty boxes in 10 m x 10 m, in tiles of this size as many as needed.
  constexpr int kRobotsInTile = 100;
  constexpr double kTile = 10.0;  // m
  const int tiles =
      static_cast<int>(std::ceil(std::sqrt(std::max(1.0, robots / double{kRobotsInTile}))));
  const double size = kTile * tiles;
  world.arena.length = world.arena.width = size;
  for (int i = 0; i < 20 * tiles * tiles; ++i) {
    const int tile = i / 20, place = i % 20;
    world::Obstacle box;
    box.id = "b" + std::to_string(i);
    box.x = -3.6 + 1.8 * (place % 5) + kTile * (tile % tiles - 0.5 * (tiles - 1));
    box.y = -2.7 + 1.8 * (place / 5) + kTile * (tile / tiles - 0.5 * (tiles - 1));
    box.heading_deg = 17.0 * i;
    box.length = 0.3;
    box.width = 0.2;
    world.obstacles.push_back(box);
  }
  const int side = static_cast<int>(std::ceil(std::sqrt(robots)));
  for (int i = 0; i < robots; ++i) {
    world::Robot robot;
    robot.id = "r" + std::to_string(i);
    robot.team = "red";
    robot.x = (size - 1.0) * ((i % side + 0.5) / side - 0.5);
    robot.y = (size - 1.0) * ((i / side + 0.5) / side - 0.5);
    robot.heading_deg = (37 * i) % 360;
    robot.battery = 1e9;
    robot.coverage = 0.0;
    for (const double azimuth : kBeamAzimuths_deg) {
      world::MountedUse beam;
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
