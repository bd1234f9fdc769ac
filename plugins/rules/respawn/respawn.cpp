// Collected resources come back after a time: where they were, or at random.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <elsie/api/rule.h>

namespace {

class Respawn final : public elsie::Rule {
 public:
  double after = 10.0;
  std::string resource;
  std::string team;
  std::string where = "same";
  double x = 0.0, y = 0.0;
  double length = 0.0, width = 0.0;
  int limit = -1;

  void configured() override {
    if (!resource.empty() && !team.empty()) {
      throw std::invalid_argument("it names both a resource, '" + resource + "', and a team, '" +
                                  team + "'; expected one of them, or none for all resources");
    }
  }
  void equipped(const elsie::Observation& start) override {
    if (!team.empty()) start.require_team(team);
    has_some_ = std::any_of(start.obstacles.begin(), start.obstacles.end(),
                            [this](const auto& each) { return is_chosen(each); });
    if (!resource.empty() && !has_some_) {
      throw std::invalid_argument("there is no resource '" + resource + "' in this world");
    }
    if (where == "random" && (std::abs(x) >= 0.5 * (start.arena_length_m + length) ||
                              std::abs(y) >= 0.5 * (start.arena_width_m + width))) {
      throw std::invalid_argument(
          "its rectangle is outside of the arena; expected one where resources can be put");
    }
  }
  std::vector<std::string> notes() const override {
    if (has_some_) return {};
    return {"the world has no resource" +
            (team.empty() ? std::string() : " of the team '" + team + "'") +
            ", so none comes back; give it one"};
  }
  void reset(elsie::Random& random) override {
    random_ = &random;
    known_.clear();
    round_ = 0;
    returned_ = 0;
  }

  void apply(const elsie::Observation& now, elsie::WorldChanges& world) override {
    see(now);
    for (Known& each : known_) {
      if (each.seen == round_) continue;
      if (each.due_s == kThere) each.due_s = now.time_s + after;
      if (limit >= 0 && returned_ >= limit) continue;
      if (now.time_s < each.due_s - 0.5 * now.step_s) continue;
      const std::string path = "resource[" + each.id + "]";
      if (find_place(path, now, world, each.pose)) {
        world.place(path, each.pose);
        each.due_s = kThere;
        ++returned_;
      } else {
        each.due_s = now.time_s + kPause;
      }
    }
  }

  int returned() const { return returned_; }

 private:
  static constexpr double kThere = std::numeric_limits<double>::infinity();
  static constexpr double kPause = 0.1;  // s, because a search for room looks at all bodies

  struct Known {
    std::string id;
    elsie::Pose pose;        // where it comes back
    std::uint64_t seen = 0;  // the round in which it was last there
    double due_s = kThere;   // when it comes back; after a failure, when that is tried again
  };

  bool is_chosen(const elsie::ObservedObstacle& each) const {
    return each.kind == elsie::ObservedObstacle::Kind::resource &&
           (resource.empty() || each.id == resource) && (team.empty() || each.team == team);
  }

  /// Notes which resources are there. They keep their order, so each is mostly the next one.
  void see(const elsie::Observation& now) {
    ++round_;
    std::size_t next = 0;
    for (const elsie::ObservedObstacle& each : now.obstacles) {
      if (!is_chosen(each)) continue;
      for (std::size_t tried = 0; tried < known_.size(); ++tried, ++next) {
        if (next >= known_.size()) next = 0;
        if (known_[next].id == each.id) break;
      }
      if (next >= known_.size() || known_[next].id != each.id) {
        next = known_.size();
        known_.push_back({std::string(each.id), each.pose});
      }
      if (where == "random") known_[next].pose = each.pose;
      known_[next].seen = round_;
      known_[next++].due_s = kThere;
    }
  }

  /// Finds a place with room, and sets the pose to it.
  bool find_place(const std::string& path, const elsie::Observation& now,
                  elsie::WorldChanges& world, elsie::Pose& pose) {
    if (where == "same") return world.has_room(path, pose);
    const double along = length > 0.0 ? length : now.arena_length_m;
    const double across = width > 0.0 ? width : now.arena_width_m;
    constexpr int kMostTries = 20;
    for (int i = 0; i < kMostTries; ++i) {
      elsie::Pose tried = pose;
      tried.x = x + along * (random_->uniform() - 0.5);
      tried.y = y + across * (random_->uniform() - 0.5);
      if (world.has_room(path, tried)) {
        pose = tried;
        return true;
      }
    }
    return false;
  }

  elsie::Random* random_ = nullptr;
  bool has_some_ = true;
  std::vector<Known> known_;
  std::uint64_t round_ = 0;
  int returned_ = 0;
};

}  // namespace

ELSIE_RULE(
    Respawn, "respawn", "Lets collected resources come back",
    elsie::parameter("after", &Respawn::after,
                     {.unit = "s", .min = 0, .meaning = "how long one stays away"}),
    elsie::parameter("resource", &Respawn::resource, {.meaning = "only this one; by default all"}),
    elsie::parameter("team", &Respawn::team, {.meaning = "only those of this team"}),
    elsie::parameter("where", &Respawn::where,
                     {.choices = {"same", "random"},
                      .meaning = "'same': where it was first; 'random': anywhere in a rectangle"}),
    elsie::parameter("x", &Respawn::x, {.unit = "m", .meaning = "middle of the rectangle, east"}),
    elsie::parameter("y", &Respawn::y, {.unit = "m", .meaning = "middle of the rectangle, north"}),
    elsie::parameter(
        "length", &Respawn::length,
        {.unit = "m", .min = 0, .meaning = "of the rectangle along x; 0: of the arena"}),
    elsie::parameter(
        "width", &Respawn::width,
        {.unit = "m", .min = 0, .meaning = "of the rectangle along y; 0: of the arena"}),
    elsie::parameter("limit", &Respawn::limit,
                     {.min = -1,
                      .meaning = "how often resources come back in all; -1: without end"}),
    elsie::publishes("returned", &Respawn::returned,
                     {.meaning = "how often resources have come back"}));
