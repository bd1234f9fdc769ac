#include "elsie/traces/standstill.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "elsie/simulation/measures.h"

namespace elsie::traces {
namespace {

using simulation::RobotView;
using simulation::TracedMember;

constexpr double kBetweenLooks_s = 0.5;
constexpr double kRoom_m = 0.1;      // who stays within it stands still
constexpr double kRoom_s = 2.0;      // and for slow robots the way of so many seconds
constexpr double kSettled_s = 1.0;   // from then on, wishes are added up
constexpr double kArm_m = 0.1;       // a turn of 1 rad/s is worth as much as so many m/s
constexpr double kSlow = 0.01;       // m/s; less is no wish to move
constexpr double kQuickTurn = 0.15;  // rad/s
constexpr double kOpposite = -0.5;   // cosine
constexpr double kRival = 0.3;       // the weaker wish, relative to the stronger one

double length(const Motion& motion) {
  return std::hypot(motion.forward, motion.lateral, kArm_m * motion.turn);
}

double dot(const Motion& a, const Motion& b) {
  return a.forward * b.forward + a.lateral * b.lateral + kArm_m * kArm_m * a.turn * b.turn;
}

bool has_members(const RobotView& robot, std::size_t member) {
  return member + 1 < robot.trace.size() &&
         robot.trace[member + 1].parent == static_cast<int>(member);
}

}  // namespace

const char* to_string(Hold hold) {
  switch (hold) {
    case Hold::cancel:
      return "cancel";
    case Hold::blocked:
      return "blocked";
    case Hold::turning:
      return "turning";
    case Hold::empty:
      return "empty";
    default:
      return "idle";
  }
}

void StandstillWatch::begin(const RobotView& robot, double now_s, Watched& watched) const {
  watched = {robot.description->id, robot.pose, now_s, 0, 0.0, 0.0, {}};
}

void StandstillWatch::add(const RobotView& robot, Watched& watched) {
  ++watched.decisions;
  watched.asked += std::hypot(robot.command.forward, robot.command.lateral);
  watched.turned += std::abs(robot.moving.turn);
  watched.parts.resize(robot.trace.size());
  std::vector<double> shares(robot.trace.size());
  for (std::size_t i = 0; i < robot.trace.size(); ++i) {
    const TracedMember& member = robot.trace[i];
    const TraceRow& row = member.member->trace;
    shares[i] = simulation::share_in_robot(
        row.share, member.parent < 0 ? 1.0 : shares[static_cast<std::size_t>(member.parent)]);
    if (has_members(robot, i)) continue;  // it speaks for those inside it
    const Motion part = shares[i] * row.command;
    watched.parts[i].sum = watched.parts[i].sum + part;
    watched.parts[i].size += length(part);
  }
}

Standstill StandstillWatch::judged(const RobotView& robot, const Watched& watched) {
  Standstill found{watched.id, watched.since_s};
  if (robot.empty) {
    found.why = Hold::empty;
    return found;
  }
  const double count = std::max(watched.decisions, 1);
  std::vector<std::size_t> strongest;
  for (std::size_t i = 0; i < watched.parts.size(); ++i) {
    if (watched.parts[i].size / count > kSlow) strongest.push_back(i);
  }
  std::stable_sort(strongest.begin(), strongest.end(), [&](std::size_t a, std::size_t b) {
    return watched.parts[a].size > watched.parts[b].size;
  });
  if (strongest.empty()) {
    return found;  // idle
  }
  const auto path = [&](std::size_t i) { return robot.trace[i].path; };
  const Part& first = watched.parts[strongest[0]];
  for (std::size_t i = 1; i < strongest.size(); ++i) {
    const Part& other = watched.parts[strongest[i]];
    const double lengths = length(first.sum) * length(other.sum);
    if (other.size > kRival * first.size && lengths > 0.0 &&
        dot(first.sum, other.sum) < kOpposite * lengths) {
      found.why = Hold::cancel;
      found.behaviors = {path(strongest[0]), path(strongest[i])};
      return found;
    }
  }
  found.behaviors = {path(strongest[0])};
  if (watched.turned / count > kQuickTurn) {
    found.why = Hold::turning;
  } else if (watched.asked / count > kSlow || strongest.size() == 1) {
    found.why = Hold::blocked;
  } else {  // of more than two, no pair is opposite
    found.why = Hold::cancel;
    found.behaviors.push_back(path(strongest[1]));
  }
  return found;
}

void StandstillWatch::look(const simulation::Simulation& simulation) {
  const double now_s = simulation.time_s();
  const std::size_t before = watched_.size();
  watched_.resize(simulation.robots());
  for (std::size_t i = before; i < watched_.size(); ++i) {
    begin(simulation.robot(i), now_s, watched_[i]);
  }
  const bool is_due = now_s >= looked_s_ + kBetweenLooks_s || now_s < looked_s_;
  if (is_due) {
    looked_s_ = now_s;
    found_.clear();
  }
  for (std::size_t i = 0; i < watched_.size(); ++i) {
    Watched& watched = watched_[i];
    const bool is_settled = now_s >= watched.since_s + kSettled_s;
    if (!is_due && !is_settled) continue;
    const RobotView robot = simulation.robot(i);
    const double room_m = std::min(kRoom_m, kRoom_s * robot.description->max_speed);
    if (is_due &&
        (watched.id != robot.description->id || distance(watched.at, robot.pose) > room_m)) {
      begin(robot, now_s, watched);
      continue;
    }
    if (is_settled) add(robot, watched);
    if (is_due && now_s >= watched.since_s + kLeast_s) found_.push_back(judged(robot, watched));
  }
}

}  // namespace elsie::traces
