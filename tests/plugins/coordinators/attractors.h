// Two posts and a place, as attractors and repellers of a heading.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "support.h"

namespace elsie::test {

inline constexpr double kAttractorPi = std::numbers::pi;
inline constexpr double kAttractorHorizon = 0.33;  // s, the default

/// A wish to drive in this direction.
inline Motion attractor_wish(double direction_rad, double speed = 0.2) {
  return {speed, 0.0, wrap_angle(direction_rad) / kAttractorHorizon};
}

inline ElementValue attractor_repeller(const char* of, double width_deg = 30.0) {
  return {"repeller", {{"of", std::string(of)}, {"width_deg", width_deg}}};
}
inline ElementValue attractor_competition(const char* by, const char* of, double gamma) {
  return {"competition", {{"by", std::string(by)}, {"of", std::string(of)}, {"gamma", gamma}}};
}

/// Two posts at -psi and psi, and a place straight ahead, in the frame of the world. After the
/// weights have grown to one, the field at any heading is how fast the robot turns there.
class AttractorPosts {
 public:
  AttractorPosts(double psi, double sigma_deg, double attraction, double repulsion)
      : robot_("fusion_attractor_dynamics",
               team_.member("left", 1, Motion{})
                   .member("right", 1, Motion{})
                   .member("place", 1, Motion{}),
               {{"attraction", attraction}, {"repulsion", repulsion}},
               {attractor_repeller("left", sigma_deg), attractor_repeller("right", sigma_deg)}),
        psi_(psi) {
    robot_.now.period(0.1);
    for (int step = 0; step < 100; ++step) {
      at(0.0);
    }
    robot_.now.period(1e-3);
  }

  double at(double heading) {
    team_.answer(0).command = attractor_wish(psi_ - heading);
    team_.answer(1).command = attractor_wish(-psi_ - heading);
    team_.answer(2).command = attractor_wish(-heading);
    return robot_.decide().turn;
  }

  /// The headings at which the field falls through zero, ahead of the robot.
  std::vector<double> attractors() {
    std::vector<double> found;
    constexpr double kStep = 0.01;
    for (double heading = -1.5 + 0.3 * kStep; heading < 1.5; heading += kStep) {
      double low = heading, high = heading + kStep;
      if (!(at(low) > 0.0 && at(high) <= 0.0)) {
        continue;
      }
      for (int halving = 0; halving < 30; ++halving) {
        const double middle = 0.5 * (low + high);
        (at(middle) > 0.0 ? low : high) = middle;
      }
      found.push_back(low);
    }
    return found;
  }

 private:
  Team team_;
  Coordinated robot_;
  double psi_;
};

}  // namespace elsie::test
