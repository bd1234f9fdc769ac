#include <catch2/catch.hpp>

#include "elsie/base/random.h"
#include "elsie/traces/trace_account.h"

#include "trace_support.h"

using namespace elsie;
using namespace elsie::test;
using traces::account;
using traces::condensed;
using traces::Decider;
using traces::Episode;
using traces::RobotAccount;
using traces::Trace;
using traces::TraceMoment;
using traces::TraceRobot;
using traces::within;

namespace {

Episode episode(double from_s, double to_s, Decider decider, double share = 1.0) {
  return {from_s, to_s, 0, {{decider, to_s - from_s, share, 2.0, 0}}};
}

/// Two members; the first decides up to 4 s, the second up to 5 s, the first up to 10 s.
TraceRobot two() {
  TraceRobot robot = traced_robot({"a", "b"});
  note(robot, 0, 0, 0.75);
  note(robot, 1, 0, 0.25);
  note(robot, 0, 4, 0.0);
  note(robot, 1, 4, 1.0).reason = 1;
  note(robot, 0, 5, 0.75);
  note(robot, 1, 5, 0.25);
  return robot;
}

}  // namespace

TEST_CASE("A priority is what it was at first, and what the user made of it in the run") {
  TraceRobot robot = traced_robot({"a", "b", "b/a"});
  robot.id = "r1";
  robot.members[2].priority = 0.75;
  const auto changed = [&](double time_s, const char* path, const char* value) {
    const auto edit = events::Changed::of(std::string("robot[r1]/") + path, value);
    robot.events.push_back({time_s, "changed", edit.detail(), edit});
  };
  changed(0, "behavior[a]/@priority", "2");
  changed(3, "behavior[a]/@speed", "4");
  changed(4, "behavior[b]/behavior[a]/@priority", "0.5");
  robot.events.push_back({5, "collected", "robot[r1]/behavior[a]/@priority=9"});
  changed(6, "behavior[a]/@priority", "-1e3");
  changed(6, "behavior[aa]/@priority", "7");
  changed(7, "sensor[a]/@priority", "7");
  changed(8, "behavior[a]/@priority", "0");
  const auto priorities_of = [&](std::size_t member, double from_s, double to_s) {
    std::vector<std::pair<double, double>> list;
    for (const auto& from : traces::priorities(robot, robot.members[member], {from_s, to_s})) {
      list.emplace_back(from.time_s, from.priority);
    }
    return list;
  };
  using List = std::vector<std::pair<double, double>>;
  CHECK(priorities_of(0, 0, 10) == List{{0, 2}, {6, -1000}, {8, 0}});
  CHECK(priorities_of(0, 1, 7) == List{{1, 2}, {6, -1000}});
  CHECK(priorities_of(0, 8, 9) == List{{8, 0}});
  CHECK(priorities_of(1, 0, 10) == List{{0, 1}});
  CHECK(priorities_of(2, 0, 10) == List{{0, 0.75}, {4, 0.5}});
}

TEST_CASE("Who has the largest share decides; means are over time") {
  const Trace trace = trace_of(two(), 10);
  const RobotAccount found = account(trace.robots[0], within({}, trace));
  const auto& a = found.members[0];
  const auto& b = found.members[1];
  CHECK(a.decided_s == Approx(9));
  CHECK(a.periods == 2);
  CHECK(a.longest_s == Approx(5));
  CHECK(a.longest_at_s == Approx(5));
  CHECK(a.share == Approx(0.75 * 0.9));
  CHECK(a.robot_share == Approx(0.75 * 0.9));
  CHECK(a.weight == Approx(7.5 * 0.9));
  CHECK(a.least_weight == 0);
  CHECK(a.largest_weight == 7.5);
  CHECK(a.asked_s == Approx(10));
  CHECK(a.activation == Approx(1));
  CHECK(b.decided_s == Approx(1));
  CHECK(b.periods == 1);
  REQUIRE(found.coordinators.size() == 1);
  CHECK(found.coordinators[0].coordinator == "outer");
  CHECK(found.coordinators[0].switches == 2);
  CHECK(found.coordinators[0].asked_s == Approx(10));
}

TEST_CASE("Episodes follow each other without gaps, each with share, weight and reason") {
  const Trace trace = trace_of(two(), 10);
  const RobotAccount found = account(trace.robots[0], within({}, trace));
  const auto& episodes = found.coordinators[0].episodes;
  REQUIRE(episodes.size() == 3);
  CHECK(episodes[0].from_s == 0);
  CHECK(episodes[1].from_s == episodes[0].to_s);
  CHECK(episodes[2].to_s == 10);
  CHECK(episodes[1].parts.at(0).decider == 1);
  CHECK(episodes[1].parts[0].share == Approx(1));
  CHECK(episodes[1].parts[0].weight == Approx(10));
  CHECK(episodes[1].parts[0].reason == 1);
  CHECK(episodes[1].parts[0].time_s == Approx(1));
}

TEST_CASE("An episode tells why it began, and the reason of its longest stretch") {
  TraceRobot robot = traced_robot({"a", "b"});
  note(robot, 0, 0, 1.0).reason = 1;
  note(robot, 1, 0, 0.0);
  note(robot, 0, 1, 1.0).reason = 2;
  note(robot, 0, 5, 0.0);
  note(robot, 1, 5, 1.0).reason = 1;
  const Trace trace = trace_of(robot, 10);
  const RobotAccount found = account(trace.robots[0], within({}, trace));
  const auto& episodes = found.coordinators[0].episodes;
  REQUIRE(episodes.size() == 2);
  CHECK(episodes[0].parts.at(0).first_reason == 1);
  CHECK(episodes[0].parts[0].reason == 2);
  CHECK(episodes[1].parts.at(0).first_reason == 1);
  CHECK(episodes[1].parts[0].reason == 1);
}

TEST_CASE("A span takes a part of the run; it begins with the first decision at the earliest") {
  TraceRobot robot = two();
  for (auto& member : robot.members) {
    member.notes.front().time_s = 1;
  }
  const Trace trace = trace_of(std::move(robot), 10);
  CHECK(within({}, trace).from_s == 1);
  CHECK(within({}, trace).to_s == 10);
  const auto span = within({4.5, 6}, trace);
  const RobotAccount found = account(trace.robots[0], span);
  CHECK(found.members[0].decided_s == Approx(1));
  CHECK(found.members[1].decided_s == Approx(0.5));
  CHECK(found.coordinators[0].episodes.front().from_s == 4.5);
  CHECK(found.coordinators[0].episodes.back().to_s == 6);
  const auto nothing = within({20, 30}, trace);
  CHECK(nothing.from_s == nothing.to_s);
  CHECK(account(trace.robots[0], nothing).coordinators[0].episodes.empty());
}

TEST_CASE("Equal shares are decided together, no share by nobody") {
  TraceRobot robot = traced_robot({"a", "b", "c"});
  for (const auto& [time_s, shares] : std::vector<std::pair<double, std::vector<double>>>{
           {0, {0.4, 0.4, 0.2}}, {1, {0, 0, 0}}, {3, {0.3, 0.3, 0.4}}}) {
    for (std::size_t i = 0; i < 3; ++i) {
      note(robot, i, time_s, shares[i]);
    }
  }
  const Trace trace = trace_of(std::move(robot), 4);
  const RobotAccount found = account(trace.robots[0], within({}, trace));
  CHECK(found.coordinators[0].together_s == Approx(1));
  CHECK(found.coordinators[0].nobody_s == Approx(2));
  CHECK(found.members[2].decided_s == Approx(1));
  const auto& episodes = found.coordinators[0].episodes;
  REQUIRE(episodes.size() == 3);
  CHECK(episodes[0].parts[0].decider == traces::kTogether);
  CHECK(episodes[1].parts[0].decider == traces::kNobody);
}

TEST_CASE(
    "Inside a behaviour, shares count only while it is asked, and times its own in the robot") {
  TraceRobot robot = traced_robot({"a", "b", "b/c", "b/d"});
  note(robot, 0, 0, 1.0);
  note(robot, 1, 0, 0.0).asked = false;
  note(robot, 2, 0, 0.0).asked = false;
  note(robot, 3, 0, 0.0).asked = false;
  note(robot, 0, 6, 0.5);
  note(robot, 1, 6, 0.5);
  note(robot, 2, 6, 0.8);
  note(robot, 3, 6, 0.2);
  const Trace trace = trace_of(std::move(robot), 10);
  const RobotAccount found = account(trace.robots[0], within({}, trace));
  REQUIRE(found.coordinators.size() == 2);
  const auto& inner = found.coordinators[1];
  CHECK(inner.parent == 1);
  CHECK(inner.coordinator == "inner");
  CHECK(inner.asked_s == Approx(4));
  CHECK(inner.switches == 0);  // from not being asked to being asked is none
  REQUIRE(inner.episodes.size() == 2);
  CHECK(inner.episodes[0].parts[0].decider == traces::kIdle);
  CHECK(inner.episodes[1].parts[0].decider == 2);
  CHECK(found.members[2].share == Approx(0.8));
  CHECK(found.members[2].robot_share == Approx(0.8 * 0.5 * 0.4));
  CHECK(found.members[1].robot_share == Approx(0.5 * 0.4));
  CHECK(found.members[2].decided_s == Approx(4));
}

TEST_CASE("Who silenced whom is counted and timed") {
  TraceRobot robot = traced_robot({"a", "b", "c"});
  note(robot, 0, 0, 1.0);
  note(robot, 1, 0, 0.0);
  note(robot, 2, 0, 0.0).inhibited_by = 0;
  note(robot, 2, 1, 0.0);
  note(robot, 2, 2, 0.0).inhibited_by = 0;
  note(robot, 2, 3, 0.0).inhibited_by = 1;
  note(robot, 2, 7, 0.0).inhibited_by = 0;
  note(robot, 1, 8, 0.0);  // changes nothing about the third
  const Trace trace = trace_of(std::move(robot), 9);
  const auto found = account(trace.robots[0], within({}, trace));
  const auto& inhibited = found.members[2].inhibited;
  REQUIRE(inhibited.size() == 2);
  CHECK(inhibited[0].by == 0);  // both 4 s: the one that came first
  CHECK(inhibited[0].times == 3);
  CHECK(inhibited[0].time_s == Approx(4));
  CHECK(inhibited[1].by == 1);
  CHECK(inhibited[1].times == 1);
  CHECK(inhibited[1].time_s == Approx(4));
  CHECK(found.members[0].inhibited.empty());
}

TEST_CASE("A walk sees every moment in which nothing changes, in order and without gaps") {
  const Trace trace = trace_of(two(), 10);
  std::vector<double> borders;
  double last = 1.0;
  traces::walk(trace.robots[0], {1, 8}, [&](const TraceMoment& moment) {
    CHECK(moment.from_s == last);
    last = moment.to_s;
    borders.push_back(moment.from_s);
    CHECK(moment.notes.size() == 2);
  });
  CHECK(borders == std::vector<double>{1, 4, 5});
  CHECK(last == 8);
}

TEST_CASE("Episodes that are few enough are shown as they are") {
  const std::vector<Episode> all{episode(0, 5, 0), episode(5, 5.01, 1), episode(5.01, 9, 0)};
  CHECK(condensed(all, 3).size() == 3);
  CHECK(condensed({}, 5).empty());
}

TEST_CASE("A short episode between two of one decider is joined with both") {
  const std::vector<Episode> shown =
      condensed({episode(0, 5, 0), episode(5, 5.5, 1), episode(5.5, 9, 0), episode(9, 20, 1)}, 2);
  REQUIRE(shown.size() == 2);
  CHECK(shown[0].from_s == 0);
  CHECK(shown[0].to_s == 9);
  CHECK(shown[0].switches == 2);
  REQUIRE(shown[0].parts.size() == 2);
  CHECK(shown[0].parts[0].decider == 0);
  CHECK(shown[0].parts[0].time_s == Approx(8.5));
  CHECK(shown[0].parts[1].time_s == Approx(0.5));
  CHECK(shown[1].parts.size() == 1);
}

TEST_CASE("A short episode between two deciders goes to the longer one") {
  const auto shown = condensed({episode(0, 5, 0), episode(5, 5.1, 2), episode(5.1, 20, 1)}, 2);
  REQUIRE(shown.size() == 2);
  CHECK(shown[0].to_s == 5);
  CHECK(shown[0].parts.size() == 1);
  CHECK(shown[1].parts[0].decider == 1);
  CHECK(shown[1].parts[1].decider == 2);
  const auto other = condensed({episode(0, 15, 0), episode(15, 15.1, 2), episode(15.1, 20, 1)}, 2);
  REQUIRE(other.size() == 2);
  CHECK(other[0].to_s == 15.1);
}

TEST_CASE("Quick turns become one episode of several deciders; long ones beside it stay pure") {
  std::vector<Episode> all{episode(0, 20, 0)};
  for (int i = 0; i < 60; ++i) {
    all.push_back(episode(20 + 0.1 * i, 20 + 0.1 * (i + 1), i % 2 == 0 ? 1 : 0));
  }
  all.push_back(episode(26, 40, 1));
  const auto shown = condensed(all, 5);
  REQUIRE(shown.size() == 3);
  CHECK(shown[0].parts.size() == 1);
  CHECK(shown[1].from_s == 20);
  CHECK(shown[1].to_s == Approx(26));
  CHECK(shown[1].switches == 59);
  CHECK(shown[1].parts.size() == 2);
  CHECK(shown[1].parts[0].time_s == Approx(3));
  CHECK(shown[2].parts.size() == 1);
}

TEST_CASE("However wild a run was, few enough episodes are shown, and no time is lost") {
  Random random(3, "episodes");
  for (int run = 0; run < 200; ++run) {
    std::vector<Episode> all;
    double now = 0.0;
    Decider last = -9;
    const int count = 1 + static_cast<int>(random.uniform(0, 300));
    for (int i = 0; i < count; ++i) {
      Decider decider = last;
      while (decider == last) {
        decider = static_cast<Decider>(random.uniform(-3, 3));
      }
      last = decider;
      const double length = random.chance(0.3) ? random.uniform(0.01, 20) : 0.01;
      all.push_back(episode(now, now + length, decider));
      now += length;
    }
    const auto most = static_cast<std::size_t>(random.uniform(1, 30));
    const auto shown = condensed(all, most);
    REQUIRE_FALSE(shown.empty());
    CHECK(shown.size() <= most);
    CHECK(shown.front().from_s == 0);
    CHECK(shown.back().to_s == now);
    int switches = 0;
    for (std::size_t i = 0; i < shown.size(); ++i) {
      switches += shown[i].switches;
      double parts = 0.0;
      for (const auto& part : shown[i].parts) {
        parts += part.time_s;
        CHECK(part.time_s <= shown[i].parts[0].time_s);
      }
      CHECK(parts == Approx(shown[i].length_s()));
      CHECK((i == 0 || shown[i].from_s == shown[i - 1].to_s));
    }
    CHECK(switches + static_cast<int>(shown.size()) == count);
  }
}
