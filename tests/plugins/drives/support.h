// A robot on a drive in the physics, commanded as the simulation does it.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "elsie/api/drive.h"
#include "elsie/physics/engine.h"
#include "elsie/plugin/engine_libraries.h"
#include "elsie/plugin/parameters.h"
#include "elsie/testing/catch.h"
#include "elsie/world/parts.h"

namespace elsie::test {

/// One drive below a chassis of the usual size, on an endless floor.
class DrivenRobot {
 public:
  explicit DrivenRobot(const std::string& name, const testing::Settings& settings = {},
                       const Chassis& chassis = {})
      : engine(physics::make_engine(open_floor(), physics_of(engine_name))) {
    const testing::Plugins& plugins = testing::Plugins::found();
    const Declaration& declaration = plugins.declaration(PluginKind::drive, name);
    drive = plugins.host().create<Drive>(PluginKind::drive, name);
    plugin::apply_parameters(declaration, *drive, plugins.completed(declaration, settings), {});
    plan = world::plan_of(chassis, *drive);
    engine->add_robot(plan, {});
    wanted.resize(engine->joints(0).size());
  }

  /// Asks for the motion in every step; returns the mean motion of the body in its own frame, which
  /// for an arc is its speed along the arc.
  Motion run(const Motion& asked, double seconds) {
    distance = turned = 0.0;
    Motion sum;
    const long steps = std::lround(seconds / kStep);
    for (long i = 0; i < steps; ++i) {
      const physics::RobotState before = engine->robot(0);
      possible = drive->command(asked, {engine->joints(0), max_speed, kStep}, wanted);
      engine->set_joints(0, wanted);
      engine->step();
      const physics::RobotState now = engine->robot(0);
      distance += elsie::distance(before.pose, now.pose);
      turned += wrap_angle(now.pose.heading_rad - before.pose.heading_rad);
      sum += {now.speed, now.lateral, now.turn_rate};
      lowest = std::min(lowest, now.frame.up.z);
    }
    return sum / static_cast<double>(steps);
  }
  /// As above, once the steering has come where it is to be.
  Motion settled(const Motion& asked, double seconds = 5.0) {
    run(asked, 2.0);
    return run(asked, seconds);
  }
  Pose pose() const { return engine->robot(0).pose; }
  Motion odometry() const { return drive->odometry(engine->joints(0)); }

  static constexpr double kStep = 0.01;  // s
  static inline std::string engine_name = "ode";

  plugin::Object<Drive> drive;
  BodyPlan plan;
  std::unique_ptr<physics::Engine> engine;
  std::vector<JointSetting> wanted;
  double max_speed = 0.5;  // m/s
  // Of the last run.
  Motion possible;        // returned last by command()
  double distance = 0.0;  // m
  double turned = 0.0;    // rad
  double lowest = 1.0;    // the vertical of the body against that of the world, as a cosine

 private:
  static world::Physics physics_of(const std::string& engine) {
    world::Physics physics;
    physics.engine = engine;
    return physics;
  }
  static world::Arena open_floor() {
    world::Arena arena;
    arena.length = arena.width = 200.0;
    arena.walls = false;
    return arena;
  }
};

/// Runs the case with each engine; returns its name.
inline std::string each_engine() {
  return DrivenRobot::engine_name = GENERATE(from_range(plugin::engine_names()));
}

/// Within two per cent, or the tolerance that is given.
inline auto within(double value, double absolute = 1e-3) {
  return Approx(value).epsilon(0.02).margin(absolute);
}

}  // namespace elsie::test
