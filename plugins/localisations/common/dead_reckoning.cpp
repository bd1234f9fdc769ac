#include "dead_reckoning.h"

#include <cmath>

namespace {

/// Normal noise on the rate of a wheel of this radius, for a path of rate * radius * step.
double noise_of(double rate, double radius, double step_s, double per_metre,
                elsie::Random& random) {
  if (per_metre <= 0.0) return 0.0;
  const double path_m = std::abs(rate) * radius * step_s;
  return random.normal(0.0, per_metre * std::sqrt(path_m)) / (radius * step_s);
}

/// The pose after a motion along an arc.
elsie::Pose moved(const elsie::Pose& from, const elsie::Motion& motion, double step_s) {
  const double turn = motion.turn * step_s;
  // sin(turn) / turn and (1 - cos(turn)) / turn, also for a straight line.
  const double along = std::abs(turn) < 1e-8 ? 1.0 : std::sin(turn) / turn;
  const double aside = std::abs(turn) < 1e-8 ? 0.5 * turn : (1.0 - std::cos(turn)) / turn;
  const double x = motion.forward * step_s, y = motion.lateral * step_s;
  const elsie::Vector2 to = elsie::point_of(from, {along * x - aside * y, aside * x + along * y});
  return {to.x, to.y, elsie::wrap_angle(from.heading_rad + turn)};
}

}  // namespace

void DeadReckoning::start(const OdometryErrors& errors, elsie::Random& random) {
  left_radius_error_ = right_radius_error_ = 0.0;
  if (errors.radius_spread > 0.0) {
    left_radius_error_ = random.normal(0.0, errors.radius_spread);
    right_radius_error_ = random.normal(0.0, errors.radius_spread);
  }
}

elsie::Belief DeadReckoning::update(const OdometryErrors& errors, const elsie::Belief& before,
                                    const elsie::LocalisationContext& now) const {
  elsie::WheelRates rates = now.wheels.wheel_rates(now.odometry);
  const double believed = 1.0 - errors.slip;
  const auto with_error = [&](double rate, double error) {
    return rate * (1.0 + error) * believed +
           noise_of(rate, now.wheels.radius, now.step_s, errors.wheel_noise, *now.random);
  };
  rates.left = with_error(rates.left, errors.left_radius_error + left_radius_error_);
  rates.right = with_error(rates.right, errors.right_radius_error + right_radius_error_);
  const elsie::WheelPair wheels{now.wheels.radius,
                                now.wheels.half_axle * (1.0 + errors.axle_error)};
  elsie::Motion moving = wheels.motion(rates);
  moving.lateral = now.odometry.lateral * believed;
  return {moved(before.pose, moving, now.step_s), moving};
}
