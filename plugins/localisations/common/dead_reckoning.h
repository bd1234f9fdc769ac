// A pose from the turns of the wheels, with the errors that odometry has.
//
// The motion m of the drive's joints is that of two wheels, which turn at the rates
//   left, right = wheel_rates(m).
// A robot that takes its wheels for other ones than it has believes the motion of the rates
//   left (1 + e_l), right (1 + e_r)  with the axle  a (1 + e_a),
// of which slip takes the part s. These are the systematic errors of Borenstein and Feng
// ("Measurement and correction of systematic odometry errors in mobile robots", IEEE Transactions
// on Robotics and Automation 12, 1996): unequal wheels bend the path, a wrong axle scales every
// turn. Floors add random errors: the path of each wheel gets normal noise whose variance grows
// with the path, k^2 per metre (Chong and Kleeman, "Accurate odometry and error modelling for a
// mobile robot", 1997).
#pragma once

#include <elsie/api/localisation.h>

struct OdometryErrors {
  double left_radius_error = 0.0;
  double right_radius_error = 0.0;
  double axle_error = 0.0;
  double slip = 0.0;
  double radius_spread = 0.0;
  double wheel_noise = 0.0;
};

/// The parameters of a localisation of this class that derives from OdometryErrors.
#define ODOMETRY_ERROR_PARAMETERS(Class)                                                   \
  elsie::parameter("left_radius_error", &Class::left_radius_error,                         \
                   {.above = -1,                                                           \
                    .max = 1,                                                              \
                    .meaning = "how much too large the left wheel is taken "               \
                               "for, as a fraction"}),                                     \
      elsie::parameter("right_radius_error", &Class::right_radius_error,                   \
                       {.above = -1, .max = 1, .meaning = "the same of the right wheel"}), \
      elsie::parameter("axle_error", &Class::axle_error,                                   \
                       {.above = -1,                                                       \
                        .max = 1,                                                          \
                        .meaning = "how much too long the axle is taken "                  \
                                   "for, as a fraction"}),                                 \
      elsie::parameter("slip", &Class::slip,                                               \
                       {.min = -1,                                                         \
                        .max = 1,                                                          \
                        .meaning = "the part of each wheel's path that is not "            \
                                   "believed"}),                                           \
      elsie::parameter("radius_spread", &Class::radius_spread,                             \
                       {.min = 0,                                                          \
                        .max = 0.3,                                                        \
                        .meaning = "deviation of a radius error that is drawn "            \
                                   "for each wheel at the start of a run",                 \
                        .live = false}),                                                   \
      elsie::parameter("wheel_noise", &Class::wheel_noise,                                 \
                       {.unit = "m",                                                       \
                        .min = 0,                                                          \
                        .max = 10,                                                         \
                        .meaning = "deviation of each wheel's path "                       \
                                   "after one metre"})

/// See the head of this file.
class DeadReckoning {
 public:
  /// Draws the errors of a run.
  void start(const OdometryErrors& errors, elsie::Random& random);
  /// The belief a step later.
  elsie::Belief update(const OdometryErrors& errors, const elsie::Belief& before,
                       const elsie::LocalisationContext& now) const;

 private:
  double left_radius_error_ = 0.0;  // drawn for this run
  double right_radius_error_ = 0.0;
};
