// One robot tells where to go, the others go there.
#include <algorithm>
#include <cmath>
#include <optional>

#include <elsie/api/behavior.h>

// What they say: both behaviours know it.
struct Place {
  static constexpr const char* kind = "place";
  double x = 0.0;  // m
  double y = 0.0;  // m

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("x", x, "m");
    visitor("y", y, "m");
  }
};

class TellPlace final : public elsie::Behavior {
 public:
  double x = 0.0;
  double y = 0.0;

  elsie::Response respond(const elsie::Perception&) override {
    elsie::Response response;
    response.say(Place{x, y});
    return response;
  }
};

ELSIE_BEHAVIOR(TellPlace, "tell_place", "Tells by radio where to go", elsie::only_acts(),
               elsie::commands<elsie::SayCommand>(),
               elsie::parameter("x", &TellPlace::x, {.unit = "m", .meaning = "of the place, east"}),
               elsie::parameter("y", &TellPlace::y,
                                {.unit = "m", .meaning = "of the place, north"}));

class GoWhereTold final : public elsie::Behavior {
 public:
  double speed = 0.25;  // m/s

  void reset(elsie::Random&) override { told_.reset(); }

  elsie::Response respond(const elsie::Perception& now) override {
    for (const auto& heard : now.heard<Place>()) told_ = *heard;
    elsie::Response response;
    if (!told_) {
      response.activation = 0.0;
      return response;
    }
    const elsie::Pose& here = now.self().pose;
    const double bearing = elsie::bearing(here, told_->x, told_->y);
    const double way = std::hypot(told_->x - here.x, told_->y - here.y);
    response.command = {std::min(speed, way) * std::max(0.0, std::cos(bearing)), 0.0,
                        2.0 * bearing};
    return response;
  }

 private:
  std::optional<Place> told_;
};

ELSIE_BEHAVIOR(GoWhereTold, "go_where_told", "Goes to the place that it was told last",
               elsie::hears<Place>(),
               elsie::parameter("speed", &GoWhereTold::speed,
                                {.unit = "m/s", .min = 0, .max = 10, .meaning = "at most"}));
