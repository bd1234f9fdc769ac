// The time for which each behaviour decided, and its mean share in the command.
#include <algorithm>
#include <cmath>

#include "chosen_robots.h"

namespace {

class TimeShare final : public elsie::Measure, public ChosenRobots {
 public:
  std::string behavior;

  void equipped(const elsie::Observation& start) override {
    choose(start);
    tallies_.clear();
    std::string there;
    for (const std::size_t i : chosen()) {
      const elsie::ObservedRobot& robot_now = start.robots[i];
      for (std::size_t b = 0; b < robot_now.behaviors.size(); ++b) {
        const std::string path(robot_now.behaviors[b].path);
        if (!behavior.empty() && path != behavior) {
          if (there.find("'" + path + "'") == std::string::npos) {
            there += (there.empty() ? "'" : ", '") + path + "'";
          }
          continue;
        }
        const auto known = std::find_if(tallies_.begin(), tallies_.end(),
                                        [&](const Tally& tally) { return tally.path == path; });
        Tally& tally = known == tallies_.end() ? tallies_.emplace_back() : *known;
        tally.path = path;
        tally.places.push_back({i, b});
      }
    }
    if (tallies_.empty()) {
      throw std::invalid_argument(
          behavior.empty() ? "the robots have no behaviours"
                           : "there is no behaviour '" + behavior + "' on the robots" +
                                 (there.empty() ? "; they have none" : "; there are " + there));
    }
  }
  std::vector<elsie::Quantity> quantities() const override {
    std::vector<elsie::Quantity> all;
    for (const Tally& tally : tallies_) {
      const std::string of = behavior.empty() ? "." + tally.path : "";
      all.push_back({"decided" + of, "", "part of the time in which it decided"});
      all.push_back({"share" + of, "", "mean share in the command of the robot"});
    }
    return all;
  }
  void reset(elsie::Random&) override {
    time_s_ = 0.0;
    for (Tally& tally : tallies_) {
      tally.decided_s = tally.share_s = 0.0;
    }
  }
  void observe(const elsie::Observation& now) override {
    if (now.is_start) {
      return;
    }
    time_s_ += now.step_s;
    for (Tally& tally : tallies_) {
      for (const Tally::At& at : tally.places) {
        const auto& behaviors = now.robots[at.robot].behaviors;
        tally.share_s += behaviors[at.behavior].robot_share * now.step_s;
        tally.decided_s += decides(behaviors, at.behavior) ? now.step_s : 0.0;
      }
    }
  }
  void report(const elsie::RunEnd&, std::span<std::optional<double>> values) const override {
    for (std::size_t i = 0; i < tallies_.size() && time_s_ > 0.0; ++i) {
      const double whole = time_s_ * static_cast<double>(tallies_[i].places.size());
      values[2 * i] = tallies_[i].decided_s / whole;
      values[2 * i + 1] = tallies_[i].share_s / whole;
    }
  }

 private:
  struct Tally {
    struct At {
      std::size_t robot;
      std::size_t behavior;
    };
    std::string path;
    std::vector<At> places;  // of the behaviours with this path
    double decided_s = 0.0;
    double share_s = 0.0;
  };

  /// Rounded to three decimals, as in traces.
  static double rounded(double share) { return std::round(1000.0 * share); }

  /// True if its share is larger than those of all behaviours next to it.
  static bool decides(std::span<const elsie::ObservedBehavior> behaviors, std::size_t which) {
    const double share = rounded(behaviors[which].share);
    if (!(share > 0.0)) {
      return false;
    }
    for (std::size_t i = 0; i < behaviors.size(); ++i) {
      if (i != which && behaviors[i].parent == behaviors[which].parent &&
          rounded(behaviors[i].share) >= share) {
        return false;
      }
    }
    return true;
  }

  std::vector<Tally> tallies_;
  double time_s_ = 0.0;
};

}  // namespace

ELSIE_MEASURE(TimeShare, "time_share",
              "Which behaviours decided, for how long, and with which share in the command",
              elsie::parameter("behavior", &TimeShare::behavior,
                               {.meaning = "only this one, by its id or, inside others, its path: "
                                           "'explore/wander'; by default each"}),
              CHOSEN_ROBOTS_PARAMETERS);
