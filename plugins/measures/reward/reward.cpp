// The reward of robots that learn: how much a formula over running totals grew in each control
// period. So a potential that shapes the reward (Ng, Harada and Russell, "Policy invariance under
// reward transformations", ICML 1999) is a term like any other. elsie/learning/reward_learner.h
// says how a number named "reward" becomes a reward.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <elsie/base/near_name.h>
#include <elsie/formula/formula.h>

#include "chosen_robots.h"

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::string_view kEvent = "event.", kTime = "time", kReward = "reward";

/// A total that every robot has.
struct Tally {
  const char* name;
  double (*of)(const elsie::ObservedRobot&);
};
constexpr Tally kTallies[] = {
    {"collected", [](const elsie::ObservedRobot& robot) { return double(robot.collected); }},
    {"collisions", [](const elsie::ObservedRobot& robot) { return double(robot.collisions); }},
    {"distance", [](const elsie::ObservedRobot& robot) { return robot.distance_m; }},
    {"energy_used", [](const elsie::ObservedRobot& robot) { return robot.energy_used; }},
    {"energy", [](const elsie::ObservedRobot& robot) { return robot.energy; }}};

class Reward final : public elsie::Measure, public ChosenRobots {
 public:
  std::string of;

  void configured() override {
    try {
      formula_.emplace(of);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("of=\"" + of + "\", " + error.what());
    }
  }
  void equipped(const elsie::Observation& start) override {
    choose(start);
    sources_.clear();
    for (const auto& name : formula_->names()) sources_.push_back(find(name, start));
    values_.resize(sources_.size());
  }
  std::vector<elsie::Quantity> quantities() const override {
    return {{"total", "", "all rewards together"}, {"mean", "1/s", "rewards in a second"}};
  }
  void reset(elsie::Random&) override {
    for (Source& source : sources_) {
      source.count = 0.0;
      for (Place& place : source.places) place.last = kNone;
    }
    first_.reset();
    now_ = begun_ = time_s_ = 0.0;
  }
  void observe(const elsie::Observation& now) override {
    if (now.decided) begun_ = now_;
    for (std::size_t i = 0; i < sources_.size(); ++i) values_[i] = value_of(sources_[i], now);
    if (const auto value = formula_->value(values_)) {
      now_ = *value;
      // The first value is where it begins, whenever that is there.
      if (!first_) first_ = begun_ = now_;
    }
    if (!now.is_start) time_s_ += now.step_s;
  }
  void report(const elsie::RunEnd&, std::span<std::optional<double>> values) const override {
    if (!first_) return;
    values[0] = now_ - *first_;
    if (time_s_ > 0.0) values[1] = *values[0] / time_s_;
  }

  /// Of the present control period.
  double reward() const { return now_ - begun_; }

 private:
  static constexpr auto kWorld = std::numeric_limits<std::size_t>::max();  // no robot
  struct Place {
    std::size_t robot;
    std::size_t number;  // that it publishes
    double last;
  };
  /// What a name stands for; the time if for none of these.
  struct Source {
    double (*of_robot)(const elsie::ObservedRobot&) = nullptr;
    std::string event;
    double count = 0.0;         // how often the event was raised
    std::vector<Place> places;  // of the published number
  };

  Source find(const elsie::formula::Formula::Name& name, const elsie::Observation& start) const {
    if (name.text == kTime) return {};
    if (name.text.starts_with(kEvent) && name.text != kEvent) {
      return {nullptr, name.text.substr(kEvent.size()), 0.0, {}};
    }
    std::vector<std::string> known{std::string(kTime)};
    for (const Tally& tally : kTallies) {
      if (name.text == tally.name) return {tally.of, "", 0.0, {}};
      known.emplace_back(tally.name);
    }
    known.push_back(std::string(kEvent) + "NAME");
    Source found;
    for (const std::size_t i : chosen()) {
      add_places(name.text, start.robots[i].published, i, found, known);
    }
    if (found.places.empty()) add_places(name.text, start.published, kWorld, found, known);
    if (!found.places.empty()) return found;
    throw std::invalid_argument("of=\"" + of + "\", column " + std::to_string(name.column) +
                                ": there is no total '" + name.text + "'" +
                                elsie::base::near_or_all(name.text, known, "there are"));
  }

  /// Adds the place of a number, if it is among these, and else their names. In a formula "/" is a
  /// division, so that paths have "." in its place. A reward is no total.
  static void add_places(const std::string& name, std::span<const elsie::ObservedNumber> published,
                         std::size_t robot_index, Source& found, std::vector<std::string>& known) {
    for (std::size_t k = 0; k < published.size(); ++k) {
      std::string path(published[k].name);
      std::replace(path.begin(), path.end(), '/', '.');
      if (robot_index == kWorld && path.substr(path.rfind('.') + 1) == kReward) continue;
      if (path == name) {
        found.places.push_back({robot_index, k, kNone});
      } else if (std::find(known.begin(), known.end(), path) == known.end()) {
        known.push_back(std::move(path));
      }
    }
  }

  double value_of(Source& source, const elsie::Observation& now) const {
    double sum = 0.0;
    if (source.of_robot) {
      for (const std::size_t i : chosen()) sum += source.of_robot(now.robots[i]);
      return sum;
    }
    if (!source.event.empty()) {
      for (const elsie::ObservedEvent& event : now.events) {
        const bool counts = event.name == source.event &&
                            std::any_of(chosen().begin(), chosen().end(), [&](std::size_t i) {
                              return now.robots[i].id == event.robot;
                            });
        if (counts) source.count += 1.0;
      }
      return source.count;
    }
    if (source.places.empty()) return now.time_s;
    bool is_there = false;
    for (Place& place : source.places) {
      const auto* const numbers =
          place.robot == kWorld ? now.numbers : now.robots[place.robot].numbers;
      const double value = numbers->now()[place.number];
      if (!std::isnan(value)) place.last = value;
      if (std::isnan(place.last)) continue;
      sum += place.last;
      is_there = true;
    }
    return is_there ? sum : kNone;
  }

  std::optional<elsie::formula::Formula> formula_;
  std::vector<Source> sources_;  // of its names
  std::vector<double> values_;
  std::optional<double> first_;  // value of the formula; none: it had none yet
  double now_ = 0.0;             // its last value
  double begun_ = 0.0;           // the one with which the present control period began
  double time_s_ = 0.0;
};

}  // namespace

ELSIE_MEASURE(Reward, "reward",
              "The reward of robots that learn: how much a formula grew in each control period",
              elsie::parameter("of", &Reward::of,
                               {.meaning = "a formula over running totals, such as "
                                           "'collected - 0.1 * collisions'",
                                .required = true}),
              CHOSEN_ROBOTS_PARAMETERS,
              elsie::publishes("reward", &Reward::reward,
                               {.meaning = "of the present control period; complete at its end"}));
