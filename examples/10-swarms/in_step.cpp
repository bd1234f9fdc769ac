// Ends the run when all robots have flashed together several times in succession.
#include <string>
#include <vector>

#include <elsie/api/rule.h>

class InStep final : public elsie::Rule {
 public:
  double window = 0.1;  // s
  int rounds = 5;

  void reset(elsie::Random&) override {
    seen_.clear();
    together_ = 0;
  }

  void apply(const elsie::Observation& now, elsie::WorldChanges& world) override {
    for (const elsie::ObservedEvent& event : now.events) {
      if (event.name == "flash") seen_.push_back(now.time_s);
    }
    if (seen_.empty() || now.time_s - seen_.front() < window) return;
    together_ = seen_.size() == now.robots.size() ? together_ + 1 : 0;
    seen_.clear();
    if (together_ == rounds) world.succeed("all flash together");
  }

  int together_ = 0;

 private:
  std::vector<double> seen_;  // times of the flashes within the window, s
};

ELSIE_RULE(InStep, "in_step", "Ends the run when all robots flash together",
           elsie::parameter("window", &InStep::window,
                            {.unit = "s", .above = 0, .meaning = "from the first to the last"}),
           elsie::parameter("rounds", &InStep::rounds,
                            {.min = 1, .meaning = "how often in succession"}),
           elsie::publishes("together", &InStep::together_,
                            {.meaning = "rounds in which all flashed together"}));
