#include "extreme_worlds.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <vector>

#include "elsie/base/random.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/error.h"
#include "elsie/world/reader.h"
#include "elsie/world/vocabulary.h"
#include "elsie/world/warnings.h"

namespace elsie::test {

namespace {

std::string text(double value) {
  char written[40];
  std::snprintf(written, sizeof(written), "%.17g", value);
  return written;
}

class Draw {
 public:
  explicit Draw(std::uint64_t number) : random_(number, "extreme world") {}

  std::string world() {
    const double side = std::exp(random_.uniform(std::log(1.0), std::log(50.0)));
    std::string out = "<world format=\"1\"><arena length=\"" + text(side) + "\" width=\"" +
                      text(side) + "\"" + attributes({"arena"}, {"wall_height", "wall_thickness"}) +
                      (chance(0.2) ? " walls=\"false\"" : "") + "/>\n<physics";
    out +=
        chance(0.2) ? always({"physics"}, {"kp", "kd"}) : attributes({"physics"}, {"erp", "cfm"});
    out += attributes({"physics"}, {"step", "gravity", "friction", "wheel_slip", "bounce"}) +
           "/>\n<obstacles>";
    for (int i = number(3); i > 0; --i) {
      out += "<dynamic_box" + place(side) +
             attributes({"obstacles", "dynamic_box"}, {"mass", "length", "width", "height"}) +
             "/>\n";
    }
    if (chance(0.3)) {
      out += "<moving_box" + place(side) +
             attributes({"obstacles", "moving_box"}, {"speed", "length", "width", "height"}) +
             "><waypoint" + place(side) + "/></moving_box>\n";
    }
    out += "</obstacles>\n<robots>";
    for (int i = 1 + number(3); i > 0; --i) {
      out += robot(i, side);
    }
    return out + "</robots><limits time=\"5\"/></world>";
  }

 private:
  bool chance(double share) { return random_.chance(share); }
  /// A random number from 0 up to, but excluding, this one.
  int number(int below) { return static_cast<int>(random_.uniform(0.0, below)); }

  std::string place(double side) {
    return " x=\"" + text(random_.uniform(-0.45, 0.45) * side) + "\" y=\"" +
           text(random_.uniform(-0.45, 0.45) * side) + "\"";
  }

  std::string robot(int index, double side) {
    const std::string speed = text(random_.uniform(1.0, 40.0));
    return "<robot id=\"r" + std::to_string(index) + "\"" + place(side) +
           attributes({"robots", "robot"}, {"max_speed"}) + "><body" +
           attributes({"robots", "robot", "body"},
                      {"length", "width", "height", "clearance", "wheel_radius", "wheel_width",
                       "mass", "wheel_mass", "wheel_torque"}) +
           "/><sensors><beam_range x=\"0\" y=\"0\" z=\"0\"/></sensors><behaviors>" +
           (chance(0.5) ? "<wander speed=\"" + speed + "\"/>"
                        : "<go_to_point x=\"" + text(random_.uniform(-2.0, 2.0) * side) +
                              "\" y=\"0\" speed=\"" + speed + "\"/>") +
           "</behaviors><coordinator><arbiter_suppression/></coordinator></robot>\n";
  }

  /// Some of these attributes, each with a value at an end of its range or in between.
  std::string attributes(const std::vector<std::string>& element,
                         const std::vector<std::string>& names) {
    std::string out;
    for (const std::string& name : names) {
      if (chance(0.3)) {
        out += always(element, {name});
      }
    }
    return out;
  }

  std::string always(const std::vector<std::string>& element,
                     const std::vector<std::string>& names) {
    const world::ElementSpec* spec = &world::vocabulary();
    for (const std::string& name : element) {
      spec = spec->child(name);
    }
    std::string out;
    for (const std::string& name : names) {
      const ParameterFacts& facts = spec->attribute(name)->facts;
      const double low = std::max(facts.min, facts.above), high = facts.max;
      // If the range is open, or begins at 0, its small end.
      const double small = low > 0.0 ? low : 1e-9 * high;
      double value = 0.0;
      switch (number(4)) {
        case 0:
          value = std::isfinite(facts.min) ? low : small;
          break;
        case 1:
          value = high;
          break;
        default:
          value = low < 0.0 ? random_.uniform(low, high)
                            : std::exp(random_.uniform(std::log(small), std::log(high)));
      }
      out += " " + name + "=\"" + text(value) + "\"";
    }
    return out;
  }

  Random random_;
};

/// Checks every body after every step against its own, wide limits.
class Witness final : public simulation::Observer {
 public:
  Witness(const world::World& world, Extreme& extreme) : world_(world), extreme_(extreme) {
    double fastest = 0.0, highest = 0.0;
    for (const world::Robot& robot : world.robots) {
      // Turning on the spot moves parts far from the axle faster than the wheels.
      const world::RobotBody& body = robot.body;
      const double axle = body.half_axle();
      const double reach = std::max({axle, 0.5 * std::hypot(body.length, body.width),
                                     std::hypot(body.wheel_radius, axle + 0.5 * body.wheel_width)});
      fastest = std::max(fastest, robot.max_speed * reach / axle);
      highest = std::max(highest, body.top());
    }
    for (const world::Obstacle& box : world.obstacles) {
      if (box.kind == world::ObstacleKind::moving) {
        fastest = std::max(fastest, box.speed);
      }
      highest = std::max(highest, box.height);
    }
    limit_ =
        10.0 + 8.0 * fastest + 2.0 * std::sqrt(2.0 * std::abs(world.physics.gravity) * highest);
  }

  void started(const simulation::Simulation& run) override { look(run); }
  void stepped(const simulation::Simulation& run) override { look(run); }

 private:
  void look(const simulation::Simulation& run) {
    for (std::size_t i = 0; i < run.robots(); ++i) {
      const Frame frame = run.sensor_frame(i, 0);
      const world::RobotBody& body = world_.robots[i].body;
      judge("robot", i, frame.point({0.0, 0.0, body.clearance + 0.5 * body.height}), true,
            run.time_s());
    }
    for (std::size_t i = 0; i < world_.obstacles.size(); ++i) {
      const bool is_free = world_.obstacles[i].kind == world::ObstacleKind::dynamic;
      if (const auto pose = run.obstacle(i); pose && is_free) {
        judge("box", i, {pose->x, pose->y, 0.0}, false, run.time_s());
      }
    }
  }

  void judge(const char* what, std::size_t index, const Vector3& now, bool with_height,
             double time_s) {
    const double h = world_.physics.step;
    const auto [last, first] = last_.emplace(std::pair(std::string(what), index), now);
    const Vector3 way = now - last->second;
    last->second = now;
    const double speed = std::sqrt(dot(way, way)) / h;
    std::string seen;
    if (!std::isfinite(now.x + now.y + now.z)) {
      seen = "is nowhere";
    } else if (!first && speed > limit_) {
      seen = "moves at " + text(speed) + " m/s";
    } else if (with_height && now.z < -1e-3) {
      seen = "is at z = " + text(now.z) + " m";
    } else if (world_.arena.walls && (std::abs(now.x) > 0.5 * world_.arena.length + 1e-3 ||
                                      std::abs(now.y) > 0.5 * world_.arena.width + 1e-3)) {
      seen = "is outside at (" + text(now.x) + ", " + text(now.y) + ")";
    }
    if (!seen.empty() && extreme_.seen.empty()) {
      extreme_.seen =
          what + (" " + std::to_string(index)) + " " + seen + " at " + text(time_s) + " s";
    }
  }

  const world::World& world_;
  Extreme& extreme_;
  double limit_;
  std::map<std::pair<std::string, std::size_t>, Vector3> last_;
};

}  // namespace

Extreme run_extreme_world(std::uint64_t number, const plugin::Host& host) {
  Extreme extreme;
  std::optional<world::World> world;
  for (std::uint64_t attempt = 0; !world; ++attempt) {
    extreme.text = Draw(number + (attempt << 32)).world();
    try {
      world = world::parse_world(extreme.text, "extreme.xml", host);
    } catch (const world::WorldError&) {
      // The reader refuses it.
    }
  }
  extreme.warned = !world::warnings(*world).empty();
  world->limits.time = std::min(5.0, 1000.0 * world->physics.step);
  simulation::Simulation run(*world, host, {.seed = number});
  Witness witness(run.world(), extreme);
  simulation::Observer* const observers[] = {&witness};
  try {
    const simulation::RunResult result = run.run(observers);
    extreme.gave_up = result.solver.gave_up > 0;
  } catch (const simulation::PhysicsFault& fault) {
    extreme.fault = fault.what();
  }
  extreme.simulated_s = run.time_s();
  return extreme;
}

}  // namespace elsie::test
