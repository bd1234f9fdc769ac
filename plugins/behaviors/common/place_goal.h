// Going to a place (x, y) and stopping there; shared by go_to_point, bug, vfh_plus and
// dynamic_window.
#pragma once

#include <cmath>

#include "arrival.h"
#include "heading_for.h"

/// Stops within the tolerance of the place, and says once that it has arrived: the event `arrived`.
class PlaceGoal : public elsie::Behavior, public elsie::Remembers {
 public:
  double x = 0.0;
  double y = 0.0;
  double tolerance = 0.05;

  elsie::Response respond(const elsie::Perception& now) override {
    const elsie::Pose& pose = now.self().pose;
    const double away = std::hypot(x - pose.x, y - pose.y);
    const bool is_there = away <= tolerance;
    elsie::Response response;
    if (is_there) {
      rest();
      response.activation = 0.0;
    } else {
      response = approach(now, away, elsie::bearing(pose, x, y));
    }
    arrival_.tell(is_there, "arrived", response);
    return response;
  }

  void reset(elsie::Random&) override { arrival_.reset(); }
  void remember(elsie::Memory& memory) override { arrival_.remember(memory); }

 protected:
  /// The answer on the way: the place is `away_m` off, at a bearing of `off_rad`.
  virtual elsie::Response approach(const elsie::Perception& now, double away_m, double off_rad) = 0;
  /// Called in each step at the place: there is no way any more, and nothing of it to be shown.
  virtual void rest() {}

 private:
  Arrival arrival_;
};
