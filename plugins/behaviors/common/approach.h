// Approaching a point by turns and straights; shared by follow_the_leader and recharge.
#pragma once

#include <cmath>
#include <stdexcept>

#include <elsie/api/behavior.h>

#include "two_values.h"

/// The law, with theta the direction of the point (deg, positive to the left) and d its distance:
///
///   d >= far_distance                   |theta| > turn_above ? (-far_gain theta, far_gain theta)
///                                                            : (far_speed, far_speed)
///   stop_distance <= d < far_distance   the same with near_gain and near_speed
///   d < stop_distance                   (0, 0)
class Approach : public elsie::Behavior {
 public:
  double turn_above = 10.0;    // deg
  double far_distance = 0.5;   // m
  double far_gain = 0.10;      // rad/s for each degree
  double far_speed = 40.0;     // rad/s
  double near_gain = 0.20;     // rad/s for each degree
  double near_speed = 30.0;    // rad/s
  double stop_distance = 0.0;  // m

  void configured() override {
    if (stop_distance > far_distance) {
      throw std::invalid_argument(
          two_values("stop_distance", stop_distance, "far_distance", far_distance, "m") +
          "it comes near before it stops, so stop_distance must not be the larger one");
    }
  }

 protected:
  explicit Approach(double stop_distance_m) : stop_distance(stop_distance_m) {}

  elsie::WheelRates towards(double distance_m, double bearing_rad) const {
    if (distance_m < stop_distance) {
      return {};
    }
    const bool far = distance_m >= far_distance;
    const double theta = elsie::degrees(bearing_rad);
    if (std::abs(theta) > turn_above) {
      const double rate = (far ? far_gain : near_gain) * theta;
      return {-rate, rate};
    }
    const double speed = far ? far_speed : near_speed;
    return {speed, speed};
  }
};
