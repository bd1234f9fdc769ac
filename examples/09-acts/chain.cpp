// A chain: each robot follows the one in front of it, which it knows by its rank and by where its
// words come from.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include <elsie/api/behavior.h>

struct Rank {
  static constexpr const char* kind = "rank";
  std::int32_t rank = 0;

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("rank", rank);
  }
};

class Chain final : public elsie::Behavior {
 public:
  std::int32_t rank = 0;
  double keep = 0.35;   // m
  double speed = 0.3;   // m/s
  double distance = 0;  // m, to the one in front

  elsie::Response respond(const elsie::Perception& now) override {
    elsie::Response response;
    response.say(Rank{rank});
    response.activation = 0.0;  // unless it has somebody to follow
    distance = std::nan("");
    for (const auto& heard : now.heard<Rank>()) {
      if (heard->rank != rank - 1 || std::isnan(heard.distance_m())) continue;
      distance = heard.distance_m();
      const double bearing = heard.bearing_rad();
      const double ahead = std::clamp(distance - keep, 0.0, 1.0) * std::max(0.0, std::cos(bearing));
      response.command = {std::min(speed, 2.0 * ahead), 0.0, 3.0 * bearing};
      response.activation = 1.0;
    }
    return response;
  }
};

ELSIE_BEHAVIOR(Chain, "chain", "Follows the robot of the rank in front, at a distance",
               elsie::commands<elsie::SayCommand>(), elsie::hears<Rank>(),
               elsie::parameter("rank", &Chain::rank,
                                {.min = 0, .max = 1000, .meaning = "its own"}),
               elsie::parameter("keep", &Chain::keep,
                                {.unit = "m", .min = 0, .max = 10, .meaning = "distance"}),
               elsie::parameter("speed", &Chain::speed,
                                {.unit = "m/s", .min = 0, .max = 10, .meaning = "at most"}),
               elsie::publishes("distance", &Chain::distance,
                                {.unit = "m", .meaning = "to the one in front"}));
