// The number of resources that robots collected, and the time of the last one.
#include "chosen_robots.h"

namespace {

class Collected final : public elsie::Measure, public ChosenRobots {
 public:
  void equipped(const elsie::Observation& start) override { choose(start); }
  std::vector<elsie::Quantity> quantities() const override {
    return {{"count", "", "resources collected"}, {"last_s", "s", "when the last of them was"}};
  }
  void reset(elsie::Random&) override {
    count_ = 0;
    last_s_.reset();
  }
  void observe(const elsie::Observation& now) override {
    const int count = sum(now, &elsie::ObservedRobot::collected);
    if (count > count_) {
      last_s_ = now.time_s;
    }
    count_ = count;
  }
  void report(const elsie::RunEnd&, std::span<std::optional<double>> values) const override {
    values[0] = count_;
    values[1] = last_s_;
  }

 private:
  int count_ = 0;
  std::optional<double> last_s_;
};

}  // namespace

ELSIE_MEASURE(Collected, "collected",
              "How many resources robots collected, and when they had the last of them",
              CHOSEN_ROBOTS_PARAMETERS);
