// The other robots that a robot of a group perceives: its team, or those whose messages it hears by
// range and bearing. Shared by disperse, aggregate and flock.
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <elsie/api/behavior.h>
#include <elsie/messages/heading.h>

/// Another robot, seen from this one.
struct Neighbour {
  double distance_m = 0.0;
  double bearing_rad = 0.0;  // from the own heading, positive to the left
  double turned_rad = 0.0;   // its heading less the own
};

/// A behaviour of a robot among others, with the parameter `from`.
class AmongMates : public elsie::Behavior {
 public:
  std::string from = "team";

  void configured() override { hears_ = from == "messages"; }
  void equipped(const elsie::Perception& example) override {
    if (hears_ && !example.self().hears_messages) {
      throw std::invalid_argument(
          "it perceives other robots by from=\"messages\", and the robot has no actuator that "
          "hears them; "
          "add <range_and_bearing>, or leave 'from' out");
    }
  }

 protected:
  /// Calls each(Neighbour) for every robot that is perceived now.
  template <class Each>
  void for_each_mate(const elsie::Perception& now, Each each) const {
    const double own = now.self().pose.heading_rad;
    if (!hears_) {
      for (const elsie::TeamMate& mate : now.team().mates) {
        each(Neighbour{mate.distance_m, mate.bearing_rad, mate.pose.heading_rad - own});
      }
      return;
    }
    for (const auto& said : now.heard<elsie::HeadingMessage>()) {
      // A radio does not tell from where.
      if (!std::isfinite(said.distance_m()) || !std::isfinite(said.bearing_rad())) continue;
      each(Neighbour{std::max(0.0, said.distance_m()), said.bearing_rad(),
                     static_cast<double>(said->heading_rad) - own});
    }
  }

 private:
  bool hears_ = false;
};

inline auto from_of_mates() {
  return elsie::parameter(
      "from", &AmongMates::from,
      {.choices = {"team", "messages"},
       .meaning = "how it perceives other robots: by the poses of its team, or by the messages "
                  "`heading` that it hears by range and bearing"});
}
