// The history of a session: what it keeps, and what it drops.
#include <cmath>

#include <catch2/catch.hpp>

#include "history.h"

using namespace elsie;
using server::History;
using snapshots::BodyState;

namespace {

constexpr double kPeriod_s = 0.05;

std::vector<BodyState> at(double x) { return {BodyState::of({.origin = {x, 0.0, 0.0}})}; }

void run(History& history, double from_s, double to_s) {
  for (int step = static_cast<int>(from_s * 100); step <= static_cast<int>(to_s * 100); ++step) {
    const double time_s = 0.01 * step;
    if (step == 0 || history.is_due(time_s)) {
      history.add(time_s, static_cast<std::uint64_t>(step), at(time_s));
    }
  }
}

}  // namespace

TEST_CASE("A history has a sample each 0.05 s, and answers with the nearest") {
  History history;
  history.begin({"robot[r1] 0"}, kPeriod_s);
  run(history, 0.0, 2.0);
  CHECK(history.size() == 41);
  CHECK(history.from_s() == 0.0);
  CHECK(history.at(1.01).time_s == Approx(1.0));
  CHECK(history.at(1.04).time_s == Approx(1.05));
  CHECK(history.at(1.04).steps == 105);
  CHECK(history.at(-1.0).time_s == 0.0);
  CHECK(history.at(99.0).time_s == Approx(2.0));
  CHECK(history.at(1.0).bodies[0].origin[0] == Approx(1.0));
  history.begin({"robot[r1] 0"}, kPeriod_s);
  CHECK(history.size() == 0);
}

TEST_CASE("A history that is full drops every second sample, and goes on at that pace") {
  constexpr std::size_t kMost = 20'000;
  History history(kMost);
  history.begin({"robot[r1] 0"}, kPeriod_s);
  run(history, 0.0, 60.0);
  CHECK(history.size() < kMost / sizeof(History::Sample));
  CHECK(history.size() > 50);
  CHECK(history.from_s() == 0.0);
  for (const double time_s : {0.0, 15.0, 30.0, 45.0, 59.0}) {
    CHECK(history.at(time_s).time_s == Approx(time_s).margin(0.5));
  }
}

TEST_CASE("What was asked for before a history thins out continues with every second sample") {
  constexpr std::size_t kMost = 20'000;
  History history(kMost);
  history.begin({"robot[r1] 0"}, kPeriod_s);
  run(history, 0.0, 5.0);
  const std::size_t before = history.size();
  const double last_s = history.after(-1.0).back().time_s;
  REQUIRE(history.period_s() == kPeriod_s);
  for (int s = 5; history.period_s() == kPeriod_s; ++s) {
    run(history, s + 0.01, s + 1.0);
  }
  REQUIRE(history.period_s() == 2.0 * kPeriod_s);
  const auto all = history.after(-1.0);
  const auto rest = history.after(last_s);
  CHECK(all.size() - rest.size() == (before + 1) / 2);
  for (std::size_t i = 0; i < all.size(); ++i) {
    CHECK(all[i].time_s == Approx(0.1 * static_cast<double>(i)));
  }
}

TEST_CASE("Paths have a place for each sample in which the body exists") {
  History history;
  history.begin({"robot[r1] 0"}, kPeriod_s);
  history.add(0.0, 0, at(1.0));
  history.rename({"robot[r2] 0", "robot[r1] 0"});
  history.add(0.05, 5, {at(2.0)[0], at(3.0)[0]});
  const std::vector<std::string> names{"robot[r1] 0", "robot[r2] 0"};
  const auto paths = History::paths(names, history.after(-1.0));
  CHECK(paths[0].x == std::vector{1.0F, 3.0F});
  CHECK(std::isnan(paths[1].x[0]));
  CHECK(paths[1].x[1] == 2.0F);
}

TEST_CASE("Bodies are known by their names, whatever scene they were in") {
  History history;
  history.begin({"a", "b"}, kPeriod_s);
  history.add(0.0, 0, {at(1.0)[0], at(2.0)[0]});
  history.rename({"c", "b"});
  history.add(1.0, 100, {at(3.0)[0], at(4.0)[0]});
  const History::Sample before = history.at(0.0);
  REQUIRE(before.bodies.size() == 2);
  CHECK(before.bodies[0].present == 0.0F);
  CHECK(before.bodies[1].present == 1.0F);
  CHECK(before.bodies[1].origin[0] == 2.0F);
  CHECK(history.at(1.0).bodies[0].origin[0] == 3.0F);
}

TEST_CASE("Names that change count among the memory of a history") {
  History history(20'000);
  history.begin({"a"}, kPeriod_s);
  for (int i = 0; i < 200; ++i) {
    history.rename({std::string(1'000, 'a') + std::to_string(i)});
    history.add(kPeriod_s * i, static_cast<std::uint64_t>(i), at(1.0));
  }
  CHECK(history.size() < 20);
}
