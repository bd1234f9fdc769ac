// A made-up situation to put a behaviour into.
#pragma once

#include <deque>
#include <string>
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
  Situation& at(double x, double y, double heading_deg) {
    self.pose = {x, y, radians(heading_deg)};
    return *this;
  }
  Situation& after(double time_s) {
    data_.time_s = time_s;
    return *this;
  }

  Perception perception() {
    sensed_.clear();
    groups_.clear();
    sensed_.reserve(ranges_.size() + switches_.size());
    add(ranges_, range_mounts_);
    add(switches_, switch_mounts_);
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

  std::deque<RangeReading> ranges_;
  std::deque<Mounting> range_mounts_;
  std::deque<ProximityReading> switches_;
  std::deque<Mounting> switch_mounts_;
  std::vector<SensedReading> sensed_;
  std::vector<ReadingGroup> groups_;
  Perception::Data data_;
};

/// A behaviour that answers what it was told to.
class Fixed final : public Behavior {
 public:
  explicit Fixed(Response response) : response_(std::move(response)) {}
  Response respond(const Perception&) override {
    ++asked;
    return response_;
  }
  int asked = 0;

 private:
  Response response_;
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
  std::span<Member> members() { return members_; }
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

}  // namespace elsie::test
