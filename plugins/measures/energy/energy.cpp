// The energy that robots took from their batteries, and the energy that is left.
#include "chosen_robots.h"

namespace {

class Energy final : public elsie::Measure, public ChosenRobots {
 public:
  void equipped(const elsie::Observation& start) override {
    choose(start);
    at_start_ = sum(start, &elsie::ObservedRobot::energy);
  }
  std::vector<elsie::Quantity> quantities() const override {
    return {{"used", "units", "taken from the batteries"},
            {"left", "units", "in the batteries at the end"}};
  }
  void reset(elsie::Random&) override {
    used_ = 0.0;
    left_ = at_start_;
  }
  void observe(const elsie::Observation& now) override {
    used_ = sum(now, &elsie::ObservedRobot::energy_used);
    left_ = sum(now, &elsie::ObservedRobot::energy);
  }
  void report(const elsie::RunEnd&, std::span<std::optional<double>> values) const override {
    values[0] = used_;
    values[1] = left_;
  }

 private:
  double at_start_ = 0.0;
  double used_ = 0.0;
  double left_ = 0.0;
};

}  // namespace

ELSIE_MEASURE(Energy, "energy", "Energy that robots took from their batteries, and that is left",
              CHOSEN_ROBOTS_PARAMETERS);
