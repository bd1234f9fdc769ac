// What the tests of motor schemas share: a robot that moves exactly as it is commanded.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/testing/behavior.h"
#include "elsie/testing/world.h"

#include "places.h"

namespace elsie::test {

constexpr double kLead = 0.05;  // m, by default

/// A robot without inertia, alone in the plane, that asks one behaviour.
struct Puppet {
  testing::Behavior behavior;
  testing::Situation now;
  double x = 0.0, y = 0.0, heading_rad = 0.0;
  double time_s = 0.0;

  Puppet(const std::string& name, const testing::Settings& settings,
         const testing::Elements& elements = {})
      : behavior(name, settings, elements) {}

  Puppet& at(double new_x, double new_y, double heading_deg) {
    x = new_x;
    y = new_y;
    heading_rad = radians(heading_deg);
    return *this;
  }
  /// Places the point that the schema moves.
  Puppet& lead_at(double new_x, double new_y, double heading_deg) {
    const double heading = radians(heading_deg);
    return at(new_x - kLead * std::cos(heading), new_y - kLead * std::sin(heading), heading_deg);
  }
  Vector2 lead() const { return point_of({x, y, heading_rad}, {kLead, 0.0}); }

  Response ask() {
    now.at(x, y, degrees(heading_rad)).time(time_s);
    return behavior.respond(now);
  }
  /// The velocity of that point in the world, if the robot does as it is told.
  Vector2 velocity() {
    const Motion motion = ask().command;
    const double c = std::cos(heading_rad), s = std::sin(heading_rad);
    const double left = kLead * motion.turn + motion.lateral;
    return {c * motion.forward - s * left, s * motion.forward + c * left};
  }
  /// Asks, and moves for a control period along the exact arc.
  Response step(double period_s) {
    now.period(period_s);
    const Response response = ask();
    REQUIRE(response.command.is_finite());
    const double turned = response.command.turn * period_s;
    const double chord = response.command.forward * period_s *
                         (turned == 0.0 ? 1.0 : std::sin(0.5 * turned) / (0.5 * turned));
    x += chord * std::cos(heading_rad + 0.5 * turned);
    y += chord * std::sin(heading_rad + 0.5 * turned);
    heading_rad = wrap_angle(heading_rad + turned);
    time_s += period_s;
    return response;
  }
};

inline void check_vector(const Vector2& vector, double x, double y, double within = 1e-9) {
  CHECK(vector.x == Approx(x).margin(within));
  CHECK(vector.y == Approx(y).margin(within));
}

/// Whether a shipped world reaches its goals, with edits.
inline bool succeeds(const std::string& world, std::vector<std::string> edits = {},
                     std::uint64_t seed = 1) {
  return testing::World::from_file(source_path("worlds/" + world + ".xml"),
                                   {.seed = seed, .set = std::move(edits)})
             .run()
             .outcome == simulation::Outcome::success;
}

}  // namespace elsie::test
