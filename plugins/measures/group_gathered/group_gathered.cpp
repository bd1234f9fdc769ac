// The time at which a team had gathered around its leader, and its extent at the end.
#include <algorithm>
#include <limits>
#include <stdexcept>

#include <elsie/api/measure.h>

namespace {

class GroupGathered final : public elsie::Measure {
 public:
  std::string team;
  double distance = 0.5;

  void equipped(const elsie::Observation& start) override {
    if (!team.empty()) {
      start.require_team(team);
    }
    group_.clear();
    for (std::size_t i = 0; i < start.robots.size(); ++i) {
      if (team.empty() || start.robots[i].team == team) {
        group_.push_back(i);
      }
    }
    if (group_.size() < 2) {
      throw std::invalid_argument(
          "a group is at least two robots, but " +
          (team.empty() ? std::string("the world") : "the team '" + team + "'") + " has " +
          std::to_string(group_.size()));
    }
  }
  std::vector<elsie::Quantity> quantities() const override {
    return {{"time_s", "s", "when all robots were first near"},
            {"farthest_m", "m", "at the end, from the robot that is farthest off"},
            {"near", "", "robots that are near at the end, leaders left out"}};
  }
  void reset(elsie::Random&) override {
    gathered_s_.reset();
    farthest_.reset();
    near_.reset();
  }
  void observe(const elsie::Observation& now) override {
    const auto leaders = static_cast<std::size_t>(std::count_if(
        group_.begin(), group_.end(), [&](std::size_t i) { return now.robots[i].is_leader; }));
    // Leaders without followers are an ordinary group.
    const bool led = leaders > 0 && leaders < group_.size();
    double farthest = 0.0;
    int near = 0;
    bool all_near = true;
    for (const std::size_t i : group_) {
      if (led && now.robots[i].is_leader) {
        continue;  // the group gathers around it
      }
      const double off = to_its_nearest(i, now, led);
      farthest = std::max(farthest, off);
      near += off <= distance ? 1 : 0;
      all_near = all_near && off <= distance;
    }
    farthest_ = farthest;
    near_ = near;
    if (all_near && !gathered_s_) {
      gathered_s_ = now.time_s;
    }
  }
  void report(const elsie::RunEnd&, std::span<std::optional<double>> values) const override {
    values[0] = gathered_s_;
    values[1] = farthest_;
    values[2] = near_;
  }

 private:
  /// The distance from a robot to the nearest leader, or to its nearest mate in a group without
  /// one.
  double to_its_nearest(std::size_t robot, const elsie::Observation& now, bool led) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::size_t i : group_) {
      if (i != robot && (!led || now.robots[i].is_leader)) {
        nearest = std::min(nearest, elsie::distance(now.robots[robot].pose, now.robots[i].pose));
      }
    }
    return nearest;
  }

  std::vector<std::size_t> group_;
  std::optional<double> gathered_s_;
  std::optional<double> farthest_;
  std::optional<double> near_;
};

}  // namespace

ELSIE_MEASURE(
    GroupGathered, "group_gathered",
    "When a team had gathered around its leader, and how far apart it is at the end",
    elsie::parameter("team", &GroupGathered::team,
                     {.meaning = "team of the robots; by default all robots are one group"}),
    elsie::parameter("distance", &GroupGathered::distance,
                     {.unit = "m",
                      .above = 0,
                      .meaning = "distance that counts as near: from a leader or, in a group "
                                 "without one or of leaders only, from another robot"}));
