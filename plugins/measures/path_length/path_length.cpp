// The distance that robots drove.
#include "chosen_robots.h"

namespace {

class PathLength final : public elsie::Measure, public ChosenRobots {
 public:
  void equipped(const elsie::Observation& start) override { choose(start); }
  std::vector<elsie::Quantity> quantities() const override {
    return {{"", "m", "length of the path driven"}};
  }
  void reset(elsie::Random&) override { length_ = 0.0; }
  void observe(const elsie::Observation& now) override {
    length_ = sum(now, &elsie::ObservedRobot::distance_m);
  }
  void report(const elsie::RunEnd&, std::span<std::optional<double>> values) const override {
    values[0] = length_;
  }

 private:
  double length_ = 0.0;  // m
};

}  // namespace

ELSIE_MEASURE(PathLength, "path_length", "How far robots drove", CHOSEN_ROBOTS_PARAMETERS);
