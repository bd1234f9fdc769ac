// The smoothness of wheel commands: their total variation per second (Skogestad 2003), and the root
// mean square of their second derivative, the jerk of a wheel (Hogan and Sternad 2009).
#include <cmath>

#include "chosen_robots.h"

namespace {

class CommandSmoothness final : public elsie::Measure, public ChosenRobots {
 public:
  void equipped(const elsie::Observation& start) override {
    choose(start);
    last_.resize(chosen().size());
  }
  std::vector<elsie::Quantity> quantities() const override {
    return {{"variation", "rad/s2", "change of a wheel's command, a second"},
            {"jerk", "rad/s3", "root mean square of a wheel's jerk"}};
  }
  void reset(elsie::Random&) override {
    last_.assign(last_.size(), {});
    variation_ = jerk_ = time_s_ = 0.0;
    decisions_ = 0;
  }
  void observe(const elsie::Observation& now) override {
    if (now.is_start) {
      return;
    }
    time_s_ += now.step_s;
    if (!now.decided) {
      return;
    }
    ++decisions_;
    const double square = now.period_s * now.period_s;
    for (std::size_t i = 0; i < last_.size(); ++i) {
      const elsie::ObservedRobot& observed = now.robots[chosen()[i]];
      const elsie::WheelRates command = observed.wheels.wheel_rates(observed.command);
      const elsie::WheelRates change = command - last_[i].command;
      const elsie::WheelRates jerk = (change - last_[i].change) / square;
      variation_ += 0.5 * (std::abs(change.left) + std::abs(change.right));
      jerk_ += 0.5 * (jerk.left * jerk.left + jerk.right * jerk.right);
      last_[i] = {command, change};
    }
  }
  void report(const elsie::RunEnd&, std::span<std::optional<double>> values) const override {
    if (decisions_ > 0) {
      const auto robots = static_cast<double>(last_.size());
      values[0] = variation_ / (robots * time_s_);
      values[1] = std::sqrt(jerk_ / (robots * static_cast<double>(decisions_)));
    }
  }

 private:
  /// From the last decision; robots start at rest.
  struct Last {
    elsie::WheelRates command;
    elsie::WheelRates change;
  };

  std::vector<Last> last_;
  double variation_ = 0.0;  // rad/s, over all robots, mean of the wheels
  double jerk_ = 0.0;       // squares, likewise
  double time_s_ = 0.0;
  std::uint64_t decisions_ = 0;
};

}  // namespace

ELSIE_MEASURE(CommandSmoothness, "command_smoothness",
              "How smooth the wheel commands are: how much they change, and how suddenly",
              CHOSEN_ROBOTS_PARAMETERS);
