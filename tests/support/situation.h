// A made-up situation to put a behaviour into.
#pragma once

#include <algorithm>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "elsie/api/coordinator.h"
#include "elsie/api/perception.h"
#include "elsie/api/random.h"

namespace elsie::test {

/// What a robot perceives, put together by hand:
///
///   Situation now;
///   now.beam(15, 0.2).beam(-15, 1.0);
///   behavior.respond(now.perception());
class Situation {
 public:
  Situation& beam(double azimuth_deg, double distance_m, double max_range_m = 1.0) {
    ranges_.push_back({distance_m, max_range_m, distance_m < max_range_m});
    range_mounts_.push_back({{}, radians(azimuth_deg), 0.0});
    return *this;
  }
  Situation& proximity(double azimuth_deg, bool detected) {
    switches_.push_back({detected, 0.5});
    switch_mounts_.push_back({{}, radians(azimuth_deg), 0.0});
    return *this;
  }
  /// A camera straight ahead that sees a blob with its middle at this column, of 100.
  Situation& blob(double column, double horizontal_fov_deg = 30.0) {
    VisionReading& view = camera(horizontal_fov_deg).views_.back();
    view.found = true;
    view.column = column;
    view.row = 50.0;
    view.area_px = 100.0;
    return *this;
  }
  /// A camera straight ahead that finds nothing.
  Situation& camera(double horizontal_fov_deg = 30.0) {
    views_.emplace_back().horizontal_fov_rad = radians(horizontal_fov_deg);
    view_mounts_.emplace_back();
    return *this;
  }
  /// Any reading of a camera.
  Situation& view(const VisionReading& reading, double azimuth_deg = 0.0) {
    views_.push_back(reading);
    view_mounts_.push_back({{}, radians(azimuth_deg), 0.0});
    return *this;
  }
  Situation& at(double x, double y, double heading_deg) {
    self.pose = {x, y, radians(heading_deg)};
    return *this;
  }
  /// Another robot of the team within coverage, seen from where this one stands now.
  Situation& mate(const char* id, double x, double y, bool is_leader = false,
                  double heading_deg = 0.0, int team_index = 0) {
    const Pose pose{x, y, radians(heading_deg)};
    mates_.push_back(
        {id, pose, distance(self.pose, pose), bearing(self.pose, x, y), is_leader, team_index});
    return *this;
  }
  Situation& event(const char* name) {
    events_.push_back({name});
    return *this;
  }
  Situation& after(double time_s) {
    data_.time_s = time_s;
    return *this;
  }

  Perception perception() {
    sensed_.clear();
    groups_.clear();
    sensed_.reserve(ranges_.size() + switches_.size() + views_.size());
    add(ranges_, range_mounts_);
    add(switches_, switch_mounts_);
    add(views_, view_mounts_);
    team.mates = mates_;
    data_.events = events_;
    data_.groups = groups_;
    data_.self = &self;
    data_.team = &team;
    return {data_, random};
  }

  OwnState self;
  TeamState team;
  Random random{1};

 private:
  template <class Reading>
  void add(const std::deque<Reading>& readings, const std::deque<Mounting>& mountings) {
    if (readings.empty()) {
      return;
    }
    const std::size_t first = sensed_.size();
    for (std::size_t i = 0; i < readings.size(); ++i) {
      sensed_.push_back({&readings[i], &mountings[i], "sensor"});
    }
    groups_.push_back({ReadingKind::of<Reading>(), std::span(sensed_).subspan(first)});
  }

  std::deque<VisionReading> views_;
  std::deque<Mounting> view_mounts_;
  std::deque<RangeReading> ranges_;
  std::deque<Mounting> range_mounts_;
  std::deque<ProximityReading> switches_;
  std::deque<Mounting> switch_mounts_;
  std::vector<TeamMate> mates_;
  std::vector<Event> events_;
  std::vector<SensedReading> sensed_;
  std::vector<ReadingGroup> groups_;
  Perception::Data data_;
};

/// A behaviour that answers what it was told to.
class Fixed final : public Behavior {
 public:
  explicit Fixed(Response answer) : response(std::move(answer)) {}
  Response respond(const Perception&) override {
    ++asked;
    return response;
  }
  void rate(const Response& given, std::span<const MotorCommand> candidates,
            std::span<double> desirability) const override {
    if (!rating) {
      Behavior::rate(given, candidates, desirability);
      return;
    }
    std::transform(candidates.begin(), candidates.end(), desirability.begin(), rating);
  }
  CommandSets command_sets(const Response& given) const override {
    return sets ? *sets : Behavior::command_sets(given);
  }

  Response response;
  std::function<double(const MotorCommand&)> rating;
  std::optional<CommandSets> sets;
  int asked = 0;
};

/// Behaviours with fixed answers, as a coordinator gets them.
class Team final : private Member::Runner {
 public:
  Team& member(const char* name, double priority, Response response) {
    behaviors_.emplace_back(std::move(response));
    Member::Runner& runner = *this;
    members_.emplace_back(name, priority, runner);
    return *this;
  }
  /// What the member added last wishes, beyond its command.
  Team& rating(std::function<double(const MotorCommand&)> rating) {
    behaviors_.back().rating = std::move(rating);
    return *this;
  }
  Team& sets(CommandSets sets) {
    behaviors_.back().sets = std::move(sets);
    return *this;
  }
  /// From one step to the next; answers may change in between.
  Team& next_step() {
    for (Member& member : members_) {
      member.begin_step();
    }
    return *this;
  }
  Response& answer(std::size_t i) { return behaviors_[i].response; }

  std::span<Member> members() { return members_; }
  const TraceRow& trace(std::size_t i) const { return members_[i].trace; }
  std::string reason(std::size_t i) const { return members_[i].trace.reason; }
  int asked(std::size_t i) const { return behaviors_[i].asked; }

 private:
  const Response& run(Member& member) override {
    const auto i = static_cast<std::size_t>(&member - members_.data());
    responses_.resize(members_.size());
    return responses_[i] = behaviors_[i].respond(situation_.perception());
  }

  void rate(Member& member, std::span<const MotorCommand> candidates,
            std::span<double> desirability) override {
    behaviors_[static_cast<std::size_t>(&member - members_.data())].rate(member.respond(),
                                                                         candidates, desirability);
  }
  CommandSets command_sets(Member& member) override {
    return behaviors_[static_cast<std::size_t>(&member - members_.data())].command_sets(
        member.respond());
  }

  std::deque<Fixed> behaviors_;
  std::vector<Member> members_;
  std::deque<Response> responses_;
  Situation situation_;
};

/// An answer of a behaviour that is active so far.
inline Response active(double activation, MotorCommand command) {
  Response response(command);
  response.activation = activation;
  return response;
}

}  // namespace elsie::test
