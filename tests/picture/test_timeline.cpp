#include <cstdlib>
#include <functional>
#include <optional>
#include <utility>

#include <catch2/catch.hpp>

#include "elsie/picture/timeline.h"

#include "support.h"

using namespace elsie;
using namespace elsie::picture;
using namespace elsie::picture::test;
using traces::Trace;
using traces::TraceMember;
using traces::TraceNote;
using traces::TraceRobot;

namespace {

// The colours of the first behaviours, in file order.
bool is_first(const Pixel& p) { return p.red == 0x00 && p.green == 0x72 && p.blue == 0xb2; }
bool is_second(const Pixel& p) { return p.red == 0xd5 && p.green == 0x5e && p.blue == 0x00; }
bool is_third(const Pixel& p) { return p.red == 0x00 && p.green == 0x9e && p.blue == 0x73; }

TraceRobot robot_with(const std::vector<std::string>& paths, const std::string& id = "r1") {
  TraceRobot robot;
  robot.id = id;
  robot.team = "red";
  robot.coordinator = "arbiter";
  for (const std::string& path : paths) {
    TraceMember member;
    member.path = path;
    if (const std::size_t slash = path.rfind('/'); slash != std::string::npos) {
      for (std::size_t i = 0; i < robot.members.size(); ++i) {
        if (robot.members[i].path == path.substr(0, slash)) {
          member.parent = static_cast<int>(i);
          member.depth = robot.members[i].depth + 1;
        }
      }
    }
    robot.members.push_back(std::move(member));
  }
  return robot;
}

TraceNote& note(TraceRobot& robot, std::size_t member, double time_s, double share) {
  TraceNote note;
  note.time_s = time_s;
  note.share = note.weight = share;
  note.asked = true;
  note.activation = 0.5;
  return robot.members[member].notes.emplace_back(note);
}

Trace trace_of(std::vector<TraceRobot> robots, double end_s = 240.0) {
  Trace trace;
  trace.world = "four resources";
  trace.step_s = trace.period_s = 0.01;
  trace.reasons = {""};
  trace.end_s = end_s;
  trace.robots = std::move(robots);
  return trace;
}

/// Three behaviours that take turns: each has the whole share from its times on.
TraceRobot in_turn(const std::vector<std::pair<double, std::size_t>>& turns) {
  TraceRobot robot = robot_with({"a", "b", "c"});
  for (const auto& [time_s, winner] : turns) {
    for (std::size_t i = 0; i < robot.members.size(); ++i) {
      note(robot, i, time_s, i == winner ? 1.0 : 0.0);
    }
  }
  return robot;
}

int count_down(const Bitmap& image, int x, const std::function<bool(const Pixel&)>& predicate) {
  int found = 0;
  for (int y = 0; y < image.height(); ++y) {
    found += predicate(image.at({static_cast<double>(x), static_cast<double>(y)})) ? 1 : 0;
  }
  return found;
}

int count(const Bitmap& image, const std::function<bool(const Pixel&)>& predicate) {
  int found = 0;
  for (int x = 0; x < image.width(); ++x) found += count_down(image, x, predicate);
  return found;
}

Bitmap drawn(const Trace& trace, const traces::TimeSpan& span = {}) {
  const Folder folder;
  save_timeline({trace, {}, span, "", {}}, folder / "a.png");
  return Bitmap(folder / "a.png");
}
Bitmap drawn(const TraceRobot& robot) { return drawn(trace_of({robot})); }

}  // namespace

TEST_CASE("Shares are stacked to scale, and the band has the colour of whoever decides") {
  const auto heights = [&](double first, double second) {
    TraceRobot robot = robot_with({"a", "b"});
    note(robot, 0, 0, first);
    note(robot, 1, 0, second);
    const Bitmap image = drawn(robot);
    return std::pair(count_down(image, 500, is_first), count_down(image, 500, is_second));
  };
  const auto [most, least] = heights(0.75, 0.25);
  const auto [least_too, most_too] = heights(0.25, 0.75);
  CHECK(most + least == Approx(least_too + most_too).margin(4));
  // The stack is 104 high, the band 28.
  CHECK(most - least_too == Approx(0.5 * 104 + 28).margin(4));
  CHECK(most_too - least == Approx(0.5 * 104 + 28).margin(4));
}

TEST_CASE("Who decided for a single hundredth of a second in four minutes is seen") {
  const auto greens = [&](const TraceRobot& robot) { return count(drawn(robot), is_third); };
  const int never = greens(in_turn({{0, 0}, {120, 1}}));
  // For every position of the instant in a column: a mark of 0.3 of the band's height, at least 1
  // pixel wide.
  for (const double at : {0.0, 17.313, 120.0, 120.005, 199.99, 239.99}) {
    CAPTURE(at);
    std::vector<std::pair<double, std::size_t>> turns{{at, 2}, {at + 0.01, 0}};
    if (at > 0.0) turns.insert(turns.begin(), {0.0, 0});
    CHECK(greens(in_turn(turns)) >= never + 7);
  }
}

TEST_CASE("Turns quicker than a pixel show all who took them") {
  std::vector<std::pair<double, std::size_t>> turns;
  for (int i = 0; i < 24000; ++i) {
    turns.emplace_back(0.01 * i, i % 2);
  }
  const Trace trace = trace_of({in_turn(turns)});
  const Bitmap image = drawn(trace);
  for (const int x : {300, 500, 700, 900}) {
    CHECK(count_down(image, x, is_first) == Approx(52 + 14).margin(8));
    CHECK(count_down(image, x, is_second) >= 52 + 14 - 4);
  }
}

TEST_CASE("Where a behaviour is silenced by another, its lane is hatched") {
  const auto dark = [&](int inhibited_by) {
    TraceRobot robot = in_turn({{0, 0}});
    robot.members[1].notes[0].inhibited_by = inhibited_by;
    return count(drawn(robot), [](const Pixel& p) { return p.red < 190; });
  };
  CHECK(dark(0) > dark(-1) + 1000);
}

TEST_CASE("Events are marked, and named in the legend") {
  TraceRobot robot = in_turn({{0, 0}});
  const auto dark = [&] { return count(drawn(robot), [](const Pixel& p) { return p.dark(); }); };
  const int without = dark();
  robot.events = {{30, "collected", "apple"}, {30, "collision", ""}, {300, "later", ""}};
  CHECK(dark() > without + 100);
}

TEST_CASE("Each kind of event has a row of its own, up to eight of them") {
  const auto height = [&](int kinds) {
    TraceRobot robot = in_turn({{0, 0}});
    for (int i = 0; i < 3 * kinds; ++i) {
      robot.events.push_back({1.0 * i, "kind " + std::to_string(i % kinds), ""});
    }
    return drawn(robot).height();
  };
  const int one = height(1);
  CHECK(height(0) < one);
  CHECK(height(3) == Approx(one + 2 * 15).margin(1));
  CHECK(height(8) == Approx(one + 7 * 15).margin(1));
  CHECK(height(9) < height(8));  // one row for all, and more names in the legend
}

TEST_CASE("Rare events are seen among hundreds of frequent ones") {
  // One frequent kind, from the first to the last second, and a rare one.
  const auto picture = [&](double rare_at, std::size_t robots) {
    TraceRobot robot = in_turn({{0, 0}});
    for (int i = 0; i < 570; ++i) {
      robot.events.push_back({240.0 * i / 570, "flicker", ""});
      if (240.0 * i / 570 <= rare_at && rare_at < 240.0 * (i + 1) / 570) {
        robot.events.push_back({rare_at, "collected", ""});
      }
    }
    return drawn(trace_of(std::vector<TraceRobot>(robots, robot)));
  };
  for (const std::size_t robots : {1U, 4U}) {  // a row for each kind, and one row for all
    CAPTURE(robots);
    const Bitmap early = picture(61.3, robots), late = picture(180.2, robots);
    REQUIRE(early.height() == late.height());
    // The events are above the band of deciders.
    int band = 0;
    while (!is_first(early.at({300.0, static_cast<double>(band)}))) ++band;
    int marked = 0, crossed = 0;
    for (int x = 0; x < early.width(); ++x) {
      int differ = 0;
      for (int y = 0; y < band; ++y) {
        const Vector2 at{static_cast<double>(x), static_cast<double>(y)};
        differ += early.at(at).red != late.at(at).red ? 1 : 0;
      }
      marked += differ;
      // Its line crosses areas that otherwise have one colour.
      crossed += std::abs(count_down(early, x, is_first) - count_down(late, x, is_first)) > 30;
    }
    CHECK(marked > 100);  // two symbols with outlines
    CHECK(crossed >= 2);  // two lines
    CHECK(crossed <= 6);  // and none for the frequent events
  }
}

TEST_CASE("Frequent events hide nothing of each other") {
  const auto dark = [&](int events) {
    TraceRobot robot = in_turn({{0, 0}});
    for (int i = 0; i < events; ++i) {
      robot.events.push_back({240.0 * i / events, "flicker", ""});
    }
    return count(drawn(robot), [](const Pixel& p) { return p.dark(); });
  };
  CHECK(dark(500) > dark(100) + 1000);  // 500 symbols leave no gap
}

TEST_CASE("The priority that the user gave a behaviour stands beside its lane") {
  const Folder folder;
  const auto with = [&](double priority) {
    TraceRobot robot = in_turn({{0, 0}});
    robot.members[1].priority = priority;
    const Trace trace = trace_of({robot});
    save_timeline({trace, {}, {}, "", {}}, folder / "a.png");
    return bytes_of(folder / "a.png");
  };
  const Trace plain = trace_of({in_turn({{0, 0}})});
  save_timeline({plain, {}, {}, "", {}}, folder / "b.png");
  CHECK((with(1) == bytes_of(folder / "b.png")));
  CHECK_FALSE((with(2) == with(1)));
  CHECK_FALSE((with(0.25) == with(0.5)));
}

TEST_CASE("A priority that is changed in the run is drawn where it changes") {
  const auto changed = [&](const std::string& attribute) {
    TraceRobot robot = in_turn({{0, 0}});
    const events::Changed edit{"robot[r1]/behavior[b]", attribute, "2"};
    robot.events = {{120, "changed", edit.detail(), edit}};
    return drawn(robot);
  };
  const Bitmap with = changed("priority");
  const Bitmap without = changed("speed");
  REQUIRE(with.height() == without.height());
  int least = with.width(), most = 0, differ = 0;
  for (int x = 0; x < with.width(); ++x) {
    for (int y = 0; y < with.height(); ++y) {
      const Vector2 at{static_cast<double>(x), static_cast<double>(y)};
      if (with.at(at).red != without.at(at).red) {
        least = std::min(least, x), most = std::max(most, x), ++differ;
      }
    }
  }
  // A line through the lane in the middle of the time, and a number right of it.
  CHECK(differ > 30);
  CHECK(most - least < 30);
  CHECK(least == Approx(0.5 * with.width()).margin(0.1 * with.width()));
}

TEST_CASE("A number that a plugin publishes has a panel; where there is none, nothing is drawn") {
  const auto with = [](auto value) {
    TraceRobot robot = in_turn({{0, 0}});
    robot.numbers = {{"a", "load", "N", {}}};
    for (int second = 0; second < 240; ++second) {
      // The last sample, at the end of the run, is not on the grid of the others.
      const double time_s = second < 239 ? second : 238.1;
      robot.numbers[0].samples.push_back(
          {time_s, value(second).value_or(std::numeric_limits<double>::quiet_NaN())});
    }
    return drawn(robot);
  };
  const auto rises_at = [&](int rise) {
    return with(
        [&](int second) { return std::optional(second >= rise && second < 200 ? 5.0 : 1.0); });
  };
  const auto differ = [](const Bitmap& a, const Bitmap& b) {  // from where to where, of the width
    REQUIRE(a.height() == b.height());
    int least = a.width(), most = 0;
    for (int x = 0; x < a.width(); ++x) {
      for (int y = 0; y < a.height(); ++y) {
        const Vector2 at{static_cast<double>(x), static_cast<double>(y)};
        if (a.at(at).red == b.at(at).red) continue;
        least = std::min(least, x), most = std::max(most, x);
      }
    }
    return std::pair(1.0 * least / a.width(), 1.0 * most / a.width());
  };
  const Bitmap early = rises_at(60), late = rises_at(120);
  CHECK(early.height() > drawn(in_turn({{0, 0}})).height() + 40);
  const auto [quarter, half] = differ(early, late);
  CHECK(quarter == Approx(0.32).margin(0.08));
  CHECK(half == Approx(0.53).margin(0.06));
  const Bitmap gap = with([](int second) {
    return second >= 80 && second < 160 ? std::nullopt : std::optional(second < 80 ? 1.0 : 5.0);
  });
  const Bitmap held = with([](int second) { return std::optional(second < 160 ? 1.0 : 5.0); });
  const auto [third, two_thirds] = differ(gap, held);
  CHECK(third == Approx(0.39).margin(0.06));
  CHECK(two_thirds == Approx(0.67).margin(0.06));
}

TEST_CASE("A part of the run fills the whole width") {
  const Trace trace = trace_of({in_turn({{0, 0}, {100, 1}, {200, 2}})});
  const Bitmap all = drawn(trace);
  const Bitmap part = drawn(trace, {110, 190});
  CHECK(count_down(all, 300, is_first) > 100);
  for (const int x : {200, 500, 900}) {
    CHECK(count_down(part, x, is_first) < 15);
    CHECK(count_down(part, x, is_second) > 100);
  }
}

TEST_CASE("Behaviours inside others have lanes of their own") {
  TraceRobot flat = robot_with({"a", "b"});
  TraceRobot deep = robot_with({"a", "b", "b/c", "b/c/d"});
  for (TraceRobot* robot : {&flat, &deep}) {
    for (std::size_t i = 0; i < robot->members.size(); ++i) {
      note(*robot, i, 0, 0.5);
    }
  }
  const int height = drawn(trace_of({flat})).height();
  CHECK(drawn(trace_of({deep})).height() == Approx(height + 2 * 35).margin(1));
}

TEST_CASE("Several robots stand one below the other; many of them in short") {
  const Folder folder;
  std::vector<TraceRobot> robots{in_turn({{0, 0}})};
  const int one = drawn(trace_of(robots)).height();
  robots.push_back(in_turn({{0, 1}}));
  const int two = drawn(trace_of(robots)).height();
  CHECK(two > one + 200);
  const Trace both = trace_of(robots);
  save_timeline({both, {1}, {}, "", {}}, folder / "b.png");
  CHECK(Bitmap(folder / "b.png").height() == one);
  robots.resize(10, in_turn({{0, 2}}));
  CHECK(drawn(trace_of(robots)).height() < 10 * 200);
  robots.resize(200, in_turn({{0, 2}}));
  const Trace crowd = trace_of(robots);
  CHECK_THROWS_WITH(save_timeline({crowd, {}, {}, "", {}}, folder / "c.png"),
                    Catch::StartsWith("A timeline of 200 robots would be ") &&
                        Catch::Contains("choose some of the robots"));
  CHECK_NOTHROW(save_timeline({crowd, {0, 199}, {}, "", {}}, folder / "d.png"));
}

TEST_CASE("Timelines of nothing, of odd numbers and of odd names can be drawn") {
  const Folder folder;
  const auto draws = [&](const Trace& trace) {
    for (const std::string file : {"a.png", "a.svg"}) {
      CHECK_NOTHROW(save_timeline({trace, {}, {}, "", {"a line"}}, folder / file));
    }
    CHECK(std::system(("xmllint --noout '" + (folder / "a.svg").string() + "'").c_str()) == 0);
  };
  draws(trace_of({}));
  draws(trace_of({}, 0.0));
  draws(trace_of({robot_with({})}));
  draws(trace_of({robot_with({"a", "b"})}));
  draws(trace_of({robot_with({"a", "b"})}, 0.0));
  TraceRobot odd = robot_with({"a", "b", "c", std::string(300, 'x'), "e", "f", "g", "h", "i"});
  for (std::size_t i = 0; i < odd.members.size(); ++i) {
    note(odd, i, 0.5, 0.2).weight = i == 0 ? -1e9 : 1e12;
    note(odd, i, 1, i == 0 ? -3.0 : 7.0).asked = i % 2 == 0;
  }
  for (int i = 0; i < 1000; ++i) {
    odd.events.push_back({0.001 * i, "event " + std::to_string(i % 13) + " <&>", "\xff"});
  }
  draws(trace_of({odd}, 2.0));
  draws(trace_of({odd}, 1e9));
}

TEST_CASE("The same timeline gives the same bytes; the height can be given") {
  const Folder folder;
  const Trace trace = trace_of({in_turn({{0, 0}, {100, 1}, {200, 2}})});
  for (const std::string suffix : {".png", ".svg"}) {
    save_timeline({trace, {}, {}, "", {}}, folder / ("a" + suffix));
    save_timeline({trace, {}, {}, "", {}}, folder / ("b" + suffix));
    const bool same = bytes_of(folder / ("a" + suffix)) == bytes_of(folder / ("b" + suffix));
    CHECK(same);
  }
  for (const int height : {200, 700, 3000}) {
    save_timeline({trace, {}, {}, "", {}}, folder / "c.png", {1600, height});
    CHECK(Bitmap(folder / "c.png").height() == height);
    CHECK(Bitmap(folder / "c.png").width() == 1600);
  }
}

TEST_CASE("A timeline that cannot be drawn says why, and leaves no file") {
  const Folder folder;
  const Trace trace = trace_of({in_turn({{0, 0}})});
  CHECK_THROWS_AS(save_timeline({trace, {}, {}, "", {}}, folder / "a.gif"), std::invalid_argument);
  CHECK_THROWS_AS(save_timeline({trace, {}, {}, "", {}}, folder / "a.png", {10, 0}),
                  std::invalid_argument);
  CHECK_THROWS_WITH(save_timeline({trace, {1}, {}, "", {}}, folder / "a.png"),
                    "A timeline of robot 1 cannot be drawn: the trace has 1 robots.");
  CHECK_THROWS_AS(save_timeline({trace, {}, {}, "", {}}, "/nowhere/a.png"), std::runtime_error);
  CHECK(folder.files() == 0);
}

TEST_CASE("The nodes of a graph have a row each, in the colour of what they were") {
  TraceRobot robot = in_turn({{0, 0}});
  traces::TraceGraph graph{
      "arbiter_states", "arbiter_states", {{{"first"}, {"second"}, {"never"}}, {}}};
  constexpr NodeState kDark = NodeState::dark;
  graph.lights = {{0.0, {NodeState::running, kDark, kDark}},
                  {120.0, {kDark, NodeState::running, kDark}}};
  robot.graphs.push_back(graph);
  const auto is_running = [](const Pixel& p) {
    return p.red == 0xff && p.green == 0xd9 && p.blue == 0x66;
  };
  const Bitmap image = drawn(robot);
  // Two rows, of which one is lit at each time; the legend is to the left.
  CHECK(count_down(image, 500, is_running) == Approx(13).margin(2));
  CHECK(count_down(image, 800, is_running) == Approx(13).margin(2));
  const Folder folder;
  save_timeline({trace_of({robot}), {}, {}, "", {}}, folder / "a.svg");
  const std::string svg = folder.read("a.svg");
  CHECK(svg.find(">first</text>") != std::string::npos);
  CHECK(svg.find(">never</text>") == std::string::npos);
  CHECK(svg.find(">running</text>") != std::string::npos);
  CHECK(svg.find(">success</text>") == std::string::npos);
}

TEST_CASE("Of a graph with many nodes, those that were running the longest are shown") {
  TraceRobot robot = in_turn({{0, 0}});
  traces::TraceGraph graph{"arbiter_tree", "arbiter_tree", {}};
  for (int i = 0; i < 50; ++i) {
    graph.graph.nodes.push_back({"node " + std::to_string(i)});
    std::vector<NodeState> lights(50);
    lights[static_cast<std::size_t>(i)] = NodeState::running;
    graph.lights.push_back({0.09 * i * i, std::move(lights)});  // each longer than the last
  }
  robot.graphs.push_back(graph);
  const Folder folder;
  save_timeline({trace_of({robot}), {}, {}, "", {}}, folder / "a.svg");
  const std::string svg = folder.read("a.svg");
  CHECK(svg.find("arbiter_tree: 30 of 50 nodes, those that were running the longest") !=
        std::string::npos);
  CHECK(svg.find(">node 49</text>") != std::string::npos);
  CHECK(svg.find(">node 3</text>") == std::string::npos);
}
