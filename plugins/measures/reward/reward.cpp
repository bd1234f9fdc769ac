// The reward of robots that learn: how much a formula over running totals grew in each control
// period. elsie/learning/reward_learner.h says how a number named "reward" becomes a reward.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <elsie/base/near_name.h>
#include <elsie/base/words.h>
#include <elsie/formula/formula.h>

#include "chosen_robots.h"
#include "published_places.h"

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
      std::fill(source.last.begin(), source.last.end(), kNone);
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
  /// What a name stands for; the time if for none of these.
  struct Source {
    double (*of_robot)(const elsie::ObservedRobot&) = nullptr;
    std::string event;
    double count = 0.0;                  // how often the event was raised
    std::vector<PublishedPlace> places;  // of the published number
    std::vector<double> last;            // there
  };

  Source find(const elsie::formula::Formula::Name& name, const elsie::Observation& start) const {
    if (name.text == kTime) return {};
    if (name.text.starts_with(kEvent) && name.text != kEvent) {
      return {nullptr, name.text.substr(kEvent.size()), 0.0, {}, {}};
    }
    std::vector<std::string> known{std::string(kTime)};
    for (const Tally& tally : kTallies) {
      if (name.text == tally.name) return {tally.of, "", 0.0, {}, {}};
      known.emplace_back(tally.name);
    }
    known.push_back(std::string(kEvent) + "NAME");
    Source found;
    for (const std::size_t i : chosen()) {
      find_published(start, i, name.text, path_of, found.places, known);
    }
    if (found.places.empty()) {
      // A reward is no total.
      const auto no_reward = [](const elsie::ObservedNumber& number) {
        std::string path = path_of(number);
        return path.substr(path.rfind('.') + 1) == kReward ? "" : path;
      };
      find_published(start, PublishedPlace::kWorld, name.text, no_reward, found.places, known);
    }
    found.last.assign(found.places.size(), kNone);
    if (!found.places.empty()) return found;
    const auto others = std::stable_partition(known.begin(), known.end(), is_name);
    const std::vector<std::string> unnamed(others, known.end());
    known.erase(others, known.end());
    throw std::invalid_argument(
        "of=\"" + of + "\", column " + std::to_string(name.column) + ": there is no total '" +
        name.text + "'" + elsie::base::near_or_all(name.text, known, "there are") +
        (unnamed.empty() ? ""
                         : "; a formula cannot name " + elsie::base::enumerated(unnamed) +
                               ": give ids of letters, digits and \"_\" there"));
  }

  /// In a formula "/" is a division, so that paths have "." in its place.
  static std::string path_of(const elsie::ObservedNumber& number) {
    std::string path(number.name);
    std::replace(path.begin(), path.end(), '/', '.');
    return path;
  }

  /// Whether a formula can name it: "home-base.away" is a difference.
  static bool is_name(const std::string& path) {
    try {
      const elsie::formula::Formula formula(path);
      return formula.names().size() == 1 && formula.names()[0].text == path;
    } catch (const std::invalid_argument&) {
      return false;
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
    for (std::size_t i = 0; i < source.places.size(); ++i) {
      const double value = source.places[i].value(now);
      double& last = source.last[i];
      if (!std::isnan(value)) last = value;
      if (std::isnan(last)) continue;
      sum += last;
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
