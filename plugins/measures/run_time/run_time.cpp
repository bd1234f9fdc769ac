// The simulated time that the run took.
#include <elsie/api/measure.h>

namespace {

class RunTime final : public elsie::Measure {
 public:
  std::vector<elsie::Quantity> quantities() const override {
    return {{"", "s", "simulated time until the run ended"}};
  }
  void observe(const elsie::Observation&) override {}
  void report(const elsie::RunEnd& end, std::span<std::optional<double>> values) const override {
    if (!only_success || end.outcome == elsie::RunEnd::Outcome::success) {
      values[0] = end.time_s;
    }
  }

  bool only_success = false;
};

}  // namespace

ELSIE_MEASURE(
    RunTime, "run_time", "How long the run took, in simulated time",
    elsie::parameter("only_success", &RunTime::only_success,
                     {.meaning = "whether only runs that reach their goals have a value"}));
