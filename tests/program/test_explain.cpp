#include <algorithm>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program.h"

using elsie::test::Workplace;
using nlohmann::json;

namespace {

std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

TEST_CASE("explain shows who decided in a recording, in words and in a picture") {
  Workplace here;
  const auto run = here.elsie("run worlds/clutter.xml --duration 30 --record run.mcap --quiet");
  CHECK(run.exit_code == 1);  // thirty seconds are not enough for its goals
  CHECK(run.err.empty());
  const auto explained = here.elsie("explain run.mcap --picture run.png");
  CHECK(explained.exit_code == 0);
  CHECK(explained.err.empty());
  CHECK_THAT(explained.out, Catch::StartsWith("clutter, seed 1: time_limit after 30.0 s: "));
  CHECK_THAT(explained.out, Catch::Contains("robot r1, team red, fusion_vector_summation"));
  CHECK_THAT(explained.out, Catch::Contains("avoid_obstacle"));
  CHECK_THAT(explained.out, Catch::Contains("who decided: "));
  CHECK_THAT(here.read("run.png"), Catch::StartsWith("\x89PNG"));
}

TEST_CASE("explain tells who silenced whom") {
  Workplace here;
  here.elsie(
      "run worlds/clutter.xml --duration 5 --record run.mcap --quiet "
      "--set 'robot[r1]/coordinator=<arbiter_suppression/>'");
  const auto explained = here.elsie("explain run.mcap");
  CHECK_THAT(explained.out, Catch::Contains("arbiter_suppression"));
  CHECK_THAT(explained.out, Catch::Contains("wander  by avoid_obstacle  1 time  5.00 s  100.0 %"));
  CHECK_THAT(explained.out, Catch::Contains("avoid_obstacle  share 1, weight 1: highest priority"));
}

TEST_CASE("explain says how long an automaton was in each state, also in its picture") {
  Workplace here;
  here.elsie("run worlds/fetch.xml --duration 20 --record run.mcap --quiet");
  const auto explained = here.elsie("explain run.mcap --picture run.svg");
  CHECK_THAT(explained.out,
             Catch::Contains("\ngraph of arbiter_states, 0.00 to 20.00 s\n  node ") &&
                 Catch::Contains("\n    to the gate ") && Catch::Contains("\n  loading "));
  CHECK_THAT(here.read("run.svg"), Catch::Contains(">arbiter_states</text>") &&
                                       Catch::Contains(">to the gate</text>") &&
                                       Catch::Contains("#ffd966"));
  const json told = json::parse(here.elsie("explain run.mcap --json").out);
  const json& graph = told.at("robots")[0].at("graphs")[0];
  CHECK(graph.at("path") == "arbiter_states");
  double inner_s = 0.0;
  for (const char* const name : {"to the gate", "to the store"}) {
    for (const json& node : graph.at("nodes")) {
      if (node.at("label") != name) continue;
      CHECK(node.at("within") == 0);
      CHECK(node.at("running").at("times") == 1);
      inner_s += node.at("running").at("time_s").get<double>();
    }
  }
  CHECK(inner_s > 1.0);
  CHECK(graph.at("nodes")[0].at("running").at("time_s").get<double>() == Approx(inner_s));
  here.elsie("run worlds/clutter.xml --duration 2 --record without.mcap --quiet");
  CHECK_THAT(here.elsie("explain without.mcap").out, !Catch::Contains("graph of"));
  CHECK_FALSE(json::parse(here.elsie("explain without.mcap --json").out)
                  .at("robots")[0]
                  .contains("graphs"));
}

TEST_CASE("explain lists the numbers that plugins published in the time that it shows") {
  Workplace here;
  here.write("w.xml",
             "<world format='1'><robots><robot id='r1'><localisation><beacon period='1'/>"
             "</localisation><behaviors><wander/></behaviors>"
             "<coordinator><arbiter_suppression/></coordinator></robot></robots></world>");
  here.elsie("run w.xml --duration 5 --record run.mcap --quiet");
  const auto explained = here.elsie("explain run.mcap");
  CHECK_THAT(explained.out, Catch::Contains("published numbers\n  number        mean  least"));
  CHECK_THAT(explained.out, Catch::Contains("\n  beacon.fixes "));
  const json told = json::parse(here.elsie("explain run.mcap --from 3 --json").out);
  const json& number = told.at("robots")[0].at("numbers")[0];
  CHECK(number.at("path") == "beacon");
  CHECK(number.at("name") == "fixes");
  CHECK(number.at("samples") == 21);
  CHECK(number.at("least").get<double>() >= 2);
  CHECK(number.at("last") == number.at("largest"));
}

TEST_CASE("explain --json tells everything, episodes unabridged; words shorten them on request") {
  Workplace here;
  here.elsie(
      "run worlds/ten_robots.xml --duration 30 --seed 4 --record run.mcap --record-times --quiet");
  const auto run = here.elsie("explain run.mcap --robot r5 --robot r2 --from 5 --to 25 --json");
  CHECK(run.err.empty());
  CHECK(lines(run.out) == 1);
  const json explained = json::parse(run.out);
  CHECK(explained.at("seed") == 4);
  CHECK(explained.at("outcome") == "time_limit");
  CHECK(explained.at("from_s") == 5);
  CHECK(explained.at("to_s") == 25);
  CHECK(explained.at("end_s") == 30);
  REQUIRE(explained.at("robots").size() == 2);
  const json& robot = explained.at("robots")[0];
  CHECK(robot.at("id") == "r5");
  REQUIRE(robot.at("behaviors").size() == 2);
  double decided_s = 0.0, shares = 0.0;
  for (const json& behavior : robot.at("behaviors")) {
    decided_s += behavior.at("decided_s").get<double>();
    shares += behavior.at("share").get<double>();
    CHECK(behavior.at("asked_s") == 20);
    CHECK(behavior.at("took").at("answers") == 3000);
  }
  const json& coordinator = robot.at("coordinators").at(0);
  decided_s += coordinator.at("nobody_s").get<double>() + coordinator.at("several_s").get<double>();
  CHECK(decided_s == Approx(20));
  CHECK(shares == Approx(1).margin(0.001));
  const json& episodes = coordinator.at("episodes");
  REQUIRE_FALSE(episodes.empty());
  CHECK(episodes.front().at("from_s") == 5);
  CHECK(episodes.back().at("to_s") == 25);
  CHECK(coordinator.at("changes") == episodes.size() - 1);

  const auto few = here.elsie("explain run.mcap --robot r5 --episodes 2");
  CHECK_THAT(few.out, Catch::Contains(" episodes shown as "));
  CHECK(lines(here.elsie("explain run.mcap --robot r5 --all").out) > lines(few.out) + 2);
}

TEST_CASE("A recording that a kill cut short is explained as far as it goes") {
  Workplace here;
  here.elsie("run worlds/clutter.xml --duration 10 --record run.mcap --quiet");
  std::string bytes = here.read("run.mcap");
  bytes.resize(bytes.size() / 2);
  here.write("cut.mcap", bytes);
  const auto explained = here.elsie("explain cut.mcap --picture cut.svg");
  CHECK(explained.exit_code == 0);
  CHECK_THAT(explained.out,
             Catch::Contains("The recording has no end: the run was killed, or is still"));
  CHECK_THAT(explained.out, Catch::Contains("the end is missing: the file breaks off at byte "));
  CHECK_FALSE(here.read("cut.svg").empty());
  here.write("begun.mcap", bytes.substr(0, 400));
  const auto begun = here.elsie("explain begun.mcap");
  CHECK(begun.exit_code == 2);
  CHECK(begun.err ==
        "elsie: recording 'begun.mcap' breaks off before its first second was written\n");
}

TEST_CASE("explain refuses what it cannot work with in a sentence") {
  Workplace here;
  here.elsie("run worlds/clutter.xml --duration 2 --record run.mcap --record run.csv --quiet");
  here.write("mine.mcap", "my own notes\n");
  std::string bytes = here.read("run.mcap");
  bytes[bytes.find("zstd") + 60] ^= 1;
  here.write("broken.mcap", bytes);
  const auto expect = [&](const std::string& arguments, const std::string& sentence) {
    CAPTURE(arguments);
    const auto run = here.elsie(arguments);
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    CHECK_THAT(run.err, Catch::Contains(sentence));
  };
  expect("run worlds/clutter.xml --record mine.mcap", "already exists and is not a recording");
  expect("run worlds/clutter.xml --record nowhere/run.mcap", "there is no folder 'nowhere'");
  CHECK(here.read("mine.mcap") == "my own notes\n");
  expect("explain", "RECORDING");
  expect("explain nowhere.mcap", "'nowhere.mcap' cannot be read: No such file");
  for (const std::string other : {"mine.mcap", "run.csv", "worlds/clutter.xml"}) {
    expect("explain " + other, "'" + other +
                                   "' is not a recording with decisions; expected a file "
                                   "that `elsie run WORLD --record FILE.mcap` has written");
  }
  expect("explain broken.mcap", "'broken.mcap' is damaged: the chunk at byte ");
  expect("explain run.mcap --robot r2", "the recording has no robot 'r2'; did you mean 'r1'?");
  expect("explain run.mcap --from 3", "--from: the recording ends at 2 s");
  expect("explain run.mcap --from 2 --to 1", "--from must be less than --to");
  expect("explain run.mcap --from nan", "--from");
  expect("explain run.mcap --to 1,5", "--to");
  expect("explain run.mcap --episodes 0", "--episodes");
  expect("explain run.mcap --picture run.gif", "must end in .png or .svg");
  expect("explain run.mcap --picture run.mcap", "is read here, and its content would be lost");
}

TEST_CASE("explain shows the priorities that the user set in the run") {
  const Workplace here;
  here.write("blend.xml", R"(<world format="1"><robots><robot id="r1"><behaviors>
    <blend id="drive"><behaviors><wander priority="2"/></behaviors><coordinator><fusion_vector_summation/></coordinator></blend>
    <wander id="roam"/></behaviors><coordinator><fusion_vector_summation/></coordinator></robot></robots>
    <limits time="4"/></world>)");
  REQUIRE(here.elsie("run blend.xml --quiet --record t.mcap --at "
                     "'1:robot[r1]/behavior[roam]/@priority=0.25'"
                     " --at '2:robot[1]/behavior[drive]/behavior[1]/@priority=3'"
                     " --at '3:robot[*]/behavior[roam]/@priority=5'")
              .exit_code < 2);
  const std::string explained = here.elsie("explain t.mcap").out;
  CHECK_THAT(explained, Catch::Matches("[\\s\\S]*\\n *roam +1, 0.25, 5 [\\s\\S]*"));
  CHECK_THAT(explained, Catch::Matches("[\\s\\S]*\\n *wander +2, 3 [\\s\\S]*"));
}

TEST_CASE("explain shows what commanded actuators, and what was heard") {
  const Workplace here;
  REQUIRE(
      here.elsie("run examples/09-acts/told.xml --plugin examples/09-acts/tell.cpp --duration 5 "
                 "--quiet --record told.mcap")
          .exit_code < 2);
  const std::string explained = here.elsie("explain told.mcap").out;
  CHECK_THAT(explained,
             Catch::Matches("[\\s\\S]*\\nactuators\\n +radio +by tell_place +[0-9.]+ %[\\s\\S]*"));
  CHECK_THAT(explained,
             Catch::Matches("[\\s\\S]*\\nheard\\n +[a-z_]+ +from scout +by radio +[0-9]+ "
                            "times +at [\\s\\S]*"));
  const auto parsed = json::parse(here.elsie("explain told.mcap --json").out);
  bool has_actuators = false, has_heard = false;
  for (const auto& robot : parsed.at("robots")) {
    has_actuators = has_actuators || robot.contains("actuators");
    has_heard = has_heard || robot.contains("heard");
  }
  CHECK(has_actuators);
  CHECK(has_heard);
  CHECK_THAT(explained, Catch::Matches("[\\s\\S]*by tell_place +100.0 %[\\s\\S]*"));
  // Robots without actuators have nothing new to explain.
  REQUIRE(here.elsie("run worlds/clutter.xml --duration 1 --quiet --record plain.mcap").exit_code <
          2);
  CHECK(here.elsie("explain plain.mcap").out.find("actuators") == std::string::npos);
}

TEST_CASE("explain knows how long an actuator was there") {
  const Workplace here;
  REQUIRE(here.elsie("run examples/09-acts/calling.xml --plugin examples/09-acts/signal.cpp "
                     "--duration 6 --quiet --record calling.mcap "
                     "--at '1:robot[guest]/actuator[+]=<led id=\"lamp\"/>' "
                     "--at '3:robot[guest]/actuator[lamp]/@remove=true'")
              .exit_code < 2);
  const std::string explained = here.elsie("explain calling.mcap --robot guest").out;
  CHECK_THAT(explained, Catch::Matches("[\\s\\S]*lamp +by nobody +100.0 %[\\s\\S]*"));
  const auto parsed = json::parse(here.elsie("explain calling.mcap --robot guest --json").out);
  const auto& lamp = parsed.at("robots").at(0).at("actuators").at(0);
  CHECK(lamp.at("from_s").get<double>() == Approx(1.0).margin(0.11));
  CHECK(lamp.at("to_s").get<double>() == Approx(3.0).margin(0.11));
}

TEST_CASE("explain leaves out the samples at which a published number does not exist") {
  const Workplace here;
  REQUIRE(here.elsie("run examples/09-acts/foraging.xml --duration 20 --quiet --record run.mcap")
              .exit_code < 2);
  const std::string explained = here.elsie("explain run.mcap").out;
  CHECK_THAT(explained, Catch::Contains("forage.distance"));
  CHECK(explained.find("nan") == std::string::npos);
}
