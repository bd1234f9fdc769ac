// Flocking (Reynolds 1987): separation, alignment and cohesion, each a pull on a robot that drives
// on otherwise.
#include <algorithm>
#include <cmath>
#include <limits>

#include "heading_for.h"
#include "inactive.h"
#include "mates.h"

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

class Flock final : public AmongMates {
 public:
  double separation = 2.0;
  double separation_radius = 0.25;
  double alignment = 1.0;
  double alignment_radius = 1.0;
  double cohesion = 1.0;
  double cohesion_radius = 1.0;
  double speed = 0.2;
  double gain = 3.0;

  void reset(elsie::Random&) override {
    bearing_rad_ = order_ = kNone;
    mates_ = 0;
  }

  elsie::Response respond(const elsie::Perception& now) override {
    elsie::Vector2 apart, headings, middle;
    int aligned = 0, near = 0;
    mates_ = 0;
    for_each_mate(now, [&](const Neighbour& mate) {
      const double ahead = std::cos(mate.bearing_rad), left = std::sin(mate.bearing_rad);
      const double push = std::max(0.0, 1.0 - mate.distance_m / separation_radius);
      apart.x -= push * ahead;
      apart.y -= push * left;
      if (mate.distance_m < alignment_radius) {
        headings.x += std::cos(mate.turned_rad);
        headings.y += std::sin(mate.turned_rad);
        ++aligned;
      }
      if (mate.distance_m < cohesion_radius) {
        middle.x += mate.distance_m / cohesion_radius * ahead;
        middle.y += mate.distance_m / cohesion_radius * left;
        ++near;
      }
      ++mates_;
    });
    order_ = aligned > 0 ? std::hypot(1.0 + headings.x, headings.y) / (1.0 + aligned) : kNone;
    bearing_rad_ = kNone;
    if (mates_ == 0) return inactive({speed, 0.0, 0.0});
    const double turns = alignment / std::max(1, aligned), pulls = cohesion / std::max(1, near);
    const double ahead = 1.0 + separation * apart.x + turns * headings.x + pulls * middle.x;
    const double left = separation * apart.y + turns * headings.y + pulls * middle.y;
    bearing_rad_ = std::atan2(left, ahead);
    return heading_for(bearing_rad_, speed, gain);
  }

  void sketch(elsie::Sketch& sketch) const override {
    if (std::isnan(bearing_rad_)) return;
    sketch.arrow(elsie::SketchRole::target, {},
                 {0.2 * std::cos(bearing_rad_), 0.2 * std::sin(bearing_rad_), 0.0});
  }

  double bearing_rad_ = kNone;  // into which it wants to drive
  double order_ = kNone;
  int mates_ = 0;
};

elsie::ParameterFacts radius(const char* meaning) {
  return {.unit = "m", .above = 0, .max = 1e4, .meaning = meaning};
}
elsie::ParameterFacts weight(const char* meaning) {
  return {.min = 0, .max = 1000, .meaning = meaning};
}

}  // namespace

ELSIE_BEHAVIOR(
    Flock, "flock", "Drives in a flock: apart from others, with them, and to their middle",
    elsie::hears<elsie::HeadingMessage>(), from_of_mates(),
    elsie::parameter("separation", &Flock::separation, weight("weight of driving apart")),
    elsie::parameter("separation_radius", &Flock::separation_radius,
                     radius("robots nearer than this push it away, the nearer the more")),
    elsie::parameter("alignment", &Flock::alignment,
                     weight("weight of driving the same way as the others")),
    elsie::parameter("alignment_radius", &Flock::alignment_radius,
                     radius("of robots nearer than this the headings count")),
    elsie::parameter("cohesion", &Flock::cohesion,
                     weight("weight of driving to the middle of the others")),
    elsie::parameter("cohesion_radius", &Flock::cohesion_radius,
                     radius("of robots nearer than this the middle counts")),
    elsie::parameter("speed", &Flock::speed,
                     {.unit = "m/s", .min = 0, .max = 50, .meaning = "how fast, straight on"}),
    elsie::parameter(
        "gain", &Flock::gain,
        {.unit = "1/s", .min = 0, .max = 100, .meaning = "turn rate for each radian off"}),
    elsie::publishes("bearing", &Flock::bearing_rad_,
                     {.unit = "rad",
                      .meaning = "of where it wants to drive, to the left; none: it is alone"}),
    elsie::publishes("order", &Flock::order_,
                     {.meaning = "length of the mean heading vector, with its own, of those within "
                                 "alignment_radius; none: there are none"}),
    elsie::publishes("mates", &Flock::mates_, {.meaning = "robots that it perceives"}));
