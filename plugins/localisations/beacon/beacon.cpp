// Dead reckoning that a beacon corrects: at intervals, within its range, it tells the pose.
#include <cmath>

#include "dead_reckoning.h"

namespace {

class Beacon final : public elsie::Localisation, public OdometryErrors {
 public:
  double period = 1.0;
  double position_error = 0.0;
  double heading_error_deg = 0.0;
  double x = 0.0;
  double y = 0.0;
  double range = 0.0;

  elsie::Belief start(const elsie::Belief& truth, elsie::Random& random) override {
    reckoning_.start(*this, random);
    since_s_ = 0.0;
    return truth;
  }

  elsie::Belief update(const elsie::Belief& before,
                       const elsie::LocalisationContext& now) override {
    elsie::Belief belief = reckoning_.update(*this, before, now);
    since_s_ += now.step_s;
    const elsie::Pose& truth = now.truth.pose;
    const bool hears = range <= 0.0 || std::hypot(truth.x - x, truth.y - y) <= range;
    if (hears && since_s_ >= period * (1.0 - 1e-9)) {
      since_s_ = 0.0;
      belief.pose = {
          truth.x + now.random->normal(0.0, position_error),
          truth.y + now.random->normal(0.0, position_error),
          truth.heading_rad + now.random->normal(0.0, elsie::radians(heading_error_deg))};
      ++fixes_;
    }
    return belief;
  }

  void reset(elsie::Random&) override { fixes_ = 0; }

  int fixes_ = 0;  // in this run

 private:
  DeadReckoning reckoning_;
  double since_s_ = 0.0;  // the last fix
};

}  // namespace

ELSIE_LOCALISATION(
    Beacon, "beacon", "Adds up the turns of the wheels; a beacon corrects the pose at intervals",
    elsie::parameter("period", &Beacon::period,
                     {.unit = "s", .above = 0, .meaning = "least time from one fix to the next"}),
    elsie::parameter("position_error", &Beacon::position_error,
                     {.unit = "m", .min = 0, .meaning = "deviation of a fix along each axis"}),
    elsie::parameter("heading_error_deg", &Beacon::heading_error_deg,
                     {.unit = "deg", .min = 0, .meaning = "deviation of the heading of a fix"}),
    elsie::parameter("x", &Beacon::x, {.unit = "m", .meaning = "where the beacon is, east"}),
    elsie::parameter("y", &Beacon::y, {.unit = "m", .meaning = "where the beacon is, north"}),
    elsie::parameter("range", &Beacon::range,
                     {.unit = "m", .min = 0, .meaning = "how far it is heard; 0: everywhere"}),
    elsie::publishes("fixes", &Beacon::fixes_, {.meaning = "how often the beacon was heard"}),
    ODOMETRY_ERROR_PARAMETERS(Beacon));
