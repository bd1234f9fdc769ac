// @name@: what it measures, in a sentence.
#include <elsie/api/measure.h>

class @Class@ final : public elsie::Measure {
 public:
  // Parameters of the world file. Their defaults are set only here.
  std::string robot;

  // Called before the first run: throws if there is no such robot.
  void equipped(const elsie::Observation& start) override { start.robot(robot); }

  // What it reports. A value with an empty name has the measure's name.
  std::vector<elsie::Quantity> quantities() const override {
    return {{"", "m", "largest distance from where the robot started"},
            {"at_s", "s", "when it was there"}};
  }

  void reset(elsie::Random&) override {
    start_.reset();
    farthest_ = 0.0;
    at_s_ = 0.0;
  }

  // The world at the start, then after every step.
  void observe(const elsie::Observation& now) override {
    const elsie::Pose& pose = now.robot(robot).pose;
    start_ = start_.value_or(pose);
    const double distance = elsie::distance(*start_, pose);
    if (distance > farthest_) {
      farthest_ = distance;
      at_s_ = now.time_s;
    }
  }

  // In the order of quantities(). A value that is not set is missing.
  void report(const elsie::RunEnd&, std::span<std::optional<double>> values) const override {
    if (start_) {
      values[0] = farthest_;
      values[1] = at_s_;
    }
  }

 private:
  std::optional<elsie::Pose> start_;
  double farthest_ = 0.0;  // m
  double at_s_ = 0.0;
};

ELSIE_MEASURE(@Class@, "@name@", "How far a robot went from where it started",
              elsie::parameter("robot", &@Class@::robot,
                               {.meaning = "id of the robot", .required = true}));
