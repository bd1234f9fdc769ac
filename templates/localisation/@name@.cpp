// @name@: what a robot believes of its own place, in a sentence.
#include <cmath>

#include <elsie/api/localisation.h>

class @Class@ final : public elsie::Localisation {
 public:
  // Parameters of the world file. Their defaults are set only here.
  double error = 0.05;  // m

  // The belief after a step. now.truth is where the robot is: add the error that you study.
  // now.odometry is what its wheels tell.
  elsie::Belief update(const elsie::Belief& /*before*/, const elsie::LocalisationContext& now) override {
    // The error grows and shrinks by chance, and is forgotten in a second.
    const double kept = 1.0 - now.step_s;
    const double step = error * std::sqrt(2.0 * now.step_s);
    off_.x = kept * off_.x + now.random->normal(0.0, step);
    off_.y = kept * off_.y + now.random->normal(0.0, step);
    elsie::Belief belief = now.truth;
    belief.pose.x += off_.x;
    belief.pose.y += off_.y;
    return belief;
  }

  // Before each run.
  void reset(elsie::Random&) override { off_ = {}; }

 private:
  elsie::Vector2 off_;  // m
};

ELSIE_LOCALISATION(@Class@, "@name@", "Believes a place that is off by chance",
                   elsie::parameter("error", &@Class@::error,
                                    {.unit = "m", .min = 0, .max = 10,
                                     .meaning = "deviation along each axis"}));
