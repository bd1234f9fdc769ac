// Homing, a basis behaviour of groups (Mataric 1994, 1995): to the nest of the team or, without
// one, to a place.
#include <cmath>
#include <limits>

#include "arrival.h"
#include "going.h"
#include "inactive.h"

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

class Home final : public elsie::Behavior, public Going, public elsie::Remembers {
 public:
  double x = 0.0;
  double y = 0.0;
  double radius = 0.4;
  double stop_within = 0.5;

  void reset(elsie::Random&) override {
    is_home_ = false;
    arrival_.reset();
    away_m_ = kNone;
  }
  void remember(elsie::Memory& memory) override {
    memory("is_home", is_home_);
    arrival_.remember(memory);
  }

  elsie::Response respond(const elsie::Perception& now) override {
    const auto& nest = now.team().nest;
    const elsie::NestView home = nest ? *nest : elsie::NestView{{x, y}, radius};
    const elsie::Pose& here = now.self().pose;
    away_m_ = std::hypot(home.place.x - here.x, home.place.y - here.y);
    const bool is_home = away_m_ <= home.radius_m;
    // It drives in beyond the rim, so that those behind it find room, and stays until it has left.
    arrival_.step(away_m_ <= stop_within * home.radius_m, is_home);
    elsie::Response response;
    if (arrival_.is_there()) {
      response = inactive();
      response.status = elsie::Status::success;
    } else {
      response = towards(here, home.place.x, home.place.y, away_m_);
    }
    if (is_home_ != is_home) {
      is_home_ = is_home;
      response.events.push_back({is_home ? "at_home" : "left_home"});
    }
    return response;
  }

  double away_m_ = kNone;

 private:
  bool is_home_ = false;
  Arrival arrival_;
};

}  // namespace

ELSIE_BEHAVIOR(
    Home, "home", "Drives to the nest of its team or, without one, to a place, and stops there",
    elsie::parameter("x", &Home::x, {.unit = "m", .meaning = "home without a nest, east"}),
    elsie::parameter("y", &Home::y, {.unit = "m", .meaning = "home without a nest, north"}),
    elsie::parameter("radius", &Home::radius,
                     {.unit = "m", .above = 0, .meaning = "of home without a nest"}),
    elsie::parameter("stop_within", &Home::stop_within,
                     {.above = 0,
                      .max = 1,
                      .meaning = "it stops so near to the middle, as a fraction of the radius"}),
    speed_of_going(), gain_of_going(), slow_down_of_going(),
    elsie::raises("at_home", "it has come home"),
    elsie::raises("left_home", "it is no longer at home"),
    elsie::publishes("away", &Home::away_m_, {.unit = "m", .meaning = "to the middle of home"}));
