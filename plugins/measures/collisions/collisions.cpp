// The number of collisions of robots, and the time of the first one.
#include "chosen_robots.h"

namespace {

class Collisions final : public elsie::Measure, public ChosenRobots {
 public:
  void equipped(const elsie::Observation& start) override { choose(start); }
  std::vector<elsie::Quantity> quantities() const override {
    return {{"count", "", "collisions with walls, obstacles and robots"},
            {"first_s", "s", "when the first of them was"}};
  }
  void reset(elsie::Random&) override {
    count_ = 0;
    first_s_.reset();
  }
  void observe(const elsie::Observation& now) override {
    count_ = sum(now, &elsie::ObservedRobot::collisions);
    if (count_ > 0 && !first_s_) {
      first_s_ = now.time_s;
    }
  }
  void report(const elsie::RunEnd&, std::span<std::optional<double>> values) const override {
    values[0] = count_;
    values[1] = first_s_;
  }

 private:
  int count_ = 0;
  std::optional<double> first_s_;
};

}  // namespace

ELSIE_MEASURE(Collisions, "collisions", "How often robots collided, and when they first did",
              CHOSEN_ROBOTS_PARAMETERS);
