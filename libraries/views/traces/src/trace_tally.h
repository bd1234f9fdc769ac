// Sums over a trace, moment by moment.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "elsie/simulation/measures.h"
#include "elsie/traces/trace.h"
#include "elsie/traces/trace_account.h"

namespace elsie::traces {

inline std::size_t place(int index) { return static_cast<std::size_t>(index); }

/// True if the coordinator inside `parent` was at work.
inline bool at_work(int parent, const TraceMoment& moment) {
  return parent < 0 || (moment.notes[place(parent)] && moment.notes[place(parent)]->asked);
}

/// Sums over the moments of one coordinator.
class CoordinatorTally {
 public:
  CoordinatorTally(const TraceRobot& robot, int parent, std::string coordinator) : robot_(robot) {
    account_.parent = parent;
    account_.coordinator = std::move(coordinator);
  }

  void add(const TraceMoment& moment, std::vector<MemberAccount>& members) {
    const double length = moment.to_s - moment.from_s;
    const Decider now = decider(robot_, account_.parent, moment);
    if (now != kIdle) {
      account_.asked_s += length;
    }
    if (now == kNobody) {
      account_.nobody_s += length;
    }
    if (now == kTogether) {
      account_.together_s += length;
    }
    if (account_.episodes.empty() || account_.episodes.back().parts[0].decider != now) {
      begin(now, moment, members);
    }
    Episode& episode = account_.episodes.back();
    Episode::Part& part = episode.parts[0];
    episode.to_s = moment.to_s;
    part.time_s += length;
    if (now >= 0) {
      const TraceNote& note = *moment.notes[place(now)];
      part.share += note.share * length;
      part.weight += note.weight * length;
      count_reason(note.reason, length);
      MemberAccount& member = members[place(now)];
      member.decided_s += length;
      if (part.time_s > member.longest_s) {
        member.longest_s = part.time_s;
        member.longest_at_s = episode.from_s;
      }
    }
  }

  CoordinatorAccount finish() {
    finish_episode();
    return std::move(account_);
  }

 private:
  void begin(Decider now, const TraceMoment& moment, std::vector<MemberAccount>& members) {
    if (!account_.episodes.empty() && now != kIdle &&
        account_.episodes.back().parts[0].decider != kIdle) {
      ++account_.switches;
    }
    finish_episode();
    Episode& episode = account_.episodes.emplace_back();
    episode.from_s = moment.from_s;
    episode.to_s = moment.to_s;
    Episode::Part& part = episode.parts.emplace_back();
    part.decider = now;
    if (now >= 0) {
      part.first_reason = moment.notes[place(now)]->reason;
      ++members[place(now)].periods;
    }
  }

  void count_reason(std::uint32_t reason, double length) {
    const auto known = std::find_if(reasons_.begin(), reasons_.end(),
                                    [&](const auto& entry) { return entry.first == reason; });
    known == reasons_.end() ? reasons_.emplace_back(reason, length)
                            : * known = {reason, known->second + length};
  }

  void finish_episode() {
    if (account_.episodes.empty()) {
      return;
    }
    Episode::Part& part = account_.episodes.back().parts[0];
    if (part.time_s > 0.0) {
      part.share /= part.time_s;
      part.weight /= part.time_s;
    }
    const auto longest =
        std::max_element(reasons_.begin(), reasons_.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    if (longest != reasons_.end()) {
      part.reason = longest->first;
    }
    reasons_.clear();
  }

  const TraceRobot& robot_;
  CoordinatorAccount account_;
  std::vector<std::pair<std::uint32_t, double>> reasons_;  // of the last episode, with their times
};

/// Sums over the moments of the members.
class MemberTally {
 public:
  explicit MemberTally(const TraceRobot& robot)
      : robot_(robot),
        accounts(robot.members.size()),
        work_s_(robot.members.size(), 0.0),
        silenced_by_(robot.members.size(), -1) {}

  void add(const TraceMoment& moment) {
    const double length = moment.to_s - moment.from_s;
    time_s_ += length;
    for (std::size_t i = 0; i < accounts.size(); ++i) {
      const TraceNote* note = moment.notes[i];
      const bool counts = note && at_work(robot_.members[i].parent, moment);
      const int silenced_by = counts ? note->inhibited_by : -1;
      if (silenced_by >= 0) {
        Inhibition& entry = inhibition(accounts[i], silenced_by);
        entry.time_s += length;
        entry.times += silenced_by != silenced_by_[i] ? 1 : 0;
      }
      silenced_by_[i] = silenced_by;
      if (counts) {
        add(*note, moment.shares[i], length, i);
      }
    }
  }

  void finish() {
    for (std::size_t i = 0; i < accounts.size(); ++i) {
      MemberAccount& member = accounts[i];
      const auto mean = [](double& sum, double over) { sum = over > 0.0 ? sum / over : 0.0; };
      mean(member.share, work_s_[i]);
      mean(member.weight, work_s_[i]);
      mean(member.robot_share, time_s_);
      mean(member.activation, member.asked_s);
      mean(member.strength, member.asked_s);
      std::stable_sort(
          member.inhibited.begin(), member.inhibited.end(),
          [](const Inhibition& a, const Inhibition& b) { return a.time_s > b.time_s; });
    }
  }

 private:
  void add(const TraceNote& note, double robot_share, double length, std::size_t i) {
    MemberAccount& member = accounts[i];
    const bool first = work_s_[i] == 0.0;
    work_s_[i] += length;
    member.share += note.share * length;
    member.robot_share += robot_share * length;
    member.weight += note.weight * length;
    member.least_weight = first ? note.weight : std::min(member.least_weight, note.weight);
    member.largest_weight = first ? note.weight : std::max(member.largest_weight, note.weight);
    if (note.asked) {
      member.asked_s += length;
      member.activation += note.activation * length;
      member.strength += note.strength * length;
    }
  }

  static Inhibition& inhibition(MemberAccount& member, int by) {
    const auto known = std::find_if(member.inhibited.begin(), member.inhibited.end(),
                                    [&](const Inhibition& entry) { return entry.by == by; });
    return known != member.inhibited.end() ? *known : member.inhibited.emplace_back(Inhibition{by});
  }

  const TraceRobot& robot_;

 public:
  std::vector<MemberAccount> accounts;

 private:
  double time_s_ = 0.0;
  std::vector<double> work_s_;    // time during which the coordinator of each was at work
  std::vector<int> silenced_by_;  // at the moment before
};

/// Sums over the moments of a robot. The robot must keep its address.
class RobotTally {
 public:
  explicit RobotTally(const TraceRobot& robot) : members_(robot) {
    coordinators_.emplace_back(robot, -1, robot.coordinator);
    for (std::size_t i = 0; i < robot.members.size(); ++i) {
      const auto inside = std::find_if(
          robot.members.begin(), robot.members.end(),
          [&](const TraceMember& member) { return member.parent == static_cast<int>(i); });
      if (inside != robot.members.end()) {
        coordinators_.emplace_back(robot, static_cast<int>(i), inside->coordinator);
      }
    }
  }

  void add(const TraceMoment& moment) {
    members_.add(moment);
    for (CoordinatorTally& coordinator : coordinators_) {
      coordinator.add(moment, members_.accounts);
    }
  }

  RobotAccount finish(const TimeSpan& span) {
    members_.finish();
    RobotAccount account{span, std::move(members_.accounts), {}};
    for (CoordinatorTally& coordinator : coordinators_) {
      account.coordinators.push_back(coordinator.finish());
    }
    return account;
  }

 private:
  MemberTally members_;
  std::vector<CoordinatorTally> coordinators_;
};

/// Each member's share in the robot's command, from the notes about all of them.
inline void find_shares(const TraceRobot& robot, std::span<const TraceNote* const> notes,
                        std::vector<double>& shares) {
  for (std::size_t i = 0; i < notes.size(); ++i) {
    const int parent = robot.members[i].parent;
    shares[i] = simulation::share_in_robot(notes[i] ? notes[i]->share : 0.0,
                                           parent < 0 ? 1.0 : shares[place(parent)]);
  }
}

}  // namespace elsie::traces
