// How many messages robots sent, and how many they heard.
#include "chosen_robots.h"

namespace {

class Messages final : public elsie::Measure, public ChosenRobots {
 public:
  void equipped(const elsie::Observation& start) override { choose(start); }
  std::vector<elsie::Quantity> quantities() const override {
    return {{"sent", "", "messages that their actuators sent"},
            {"heard", "", "messages that they heard from others"}};
  }
  void reset(elsie::Random&) override { talk_ = {}; }
  void observe(const elsie::Observation& now) override {
    talk_ = {};
    for (const std::size_t i : chosen()) {
      talk_.sent += now.robots[i].talk.sent;
      talk_.heard += now.robots[i].talk.heard;
    }
  }
  void report(const elsie::RunEnd&, std::span<std::optional<double>> values) const override {
    values[0] = talk_.sent;
    values[1] = talk_.heard;
  }

 private:
  elsie::Talk talk_;
};

}  // namespace

ELSIE_MEASURE(Messages, "messages", "How many messages robots sent and heard",
              CHOSEN_ROBOTS_PARAMETERS);
