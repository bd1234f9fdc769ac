#include <algorithm>
#include <filesystem>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "places.h"
#include "program.h"

using elsie::test::Workplace;
using nlohmann::json;

namespace {

std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

TEST_CASE("run --explain writes a trace that explain tells of, in words and in a picture") {
  Workplace here;
  const auto run = here.elsie("run worlds/clutter.xml --duration 30 --explain run.trace --quiet");
  CHECK(run.exit_code == 1);  // thirty seconds are not enough for its goals
  CHECK(run.err.empty());
  CHECK_THAT(here.read("run.trace"), Catch::StartsWith("# elsie trace 1\n# run world=\"clutter\""));
  const auto told = here.elsie("explain run.trace --picture run.png");
  CHECK(told.exit_code == 0);
  CHECK(told.err.empty());
  CHECK_THAT(told.out, Catch::StartsWith("clutter, seed 1: time_limit after 30.0 s: "));
  CHECK_THAT(told.out, Catch::Contains("robot r1, team red, fusion_vector_summation"));
  CHECK_THAT(told.out, Catch::Contains("avoid_obstacle"));
  CHECK_THAT(told.out, Catch::Contains("who decided: "));
  CHECK_THAT(here.read("run.png"), Catch::StartsWith("\x89PNG"));
}

TEST_CASE("explain tells who silenced whom") {
  Workplace here;
  here.elsie(
      "run worlds/clutter.xml --duration 5 --explain run.trace --quiet "
      "--set 'robot[r1]/coordinator=<arbiter_suppression/>'");
  const auto told = here.elsie("explain run.trace");
  CHECK_THAT(told.out, Catch::Contains("arbiter_suppression"));
  CHECK_THAT(told.out, Catch::Contains("wander  by avoid_obstacle  1 time  5.00 s  100.0 %"));
  CHECK_THAT(told.out, Catch::Contains("avoid_obstacle  share 1, weight 1: highest priority"));
}

TEST_CASE("A run is the same whether it is explained or not") {
  Workplace here;
  const auto hash = [&](const std::string& options) {
    const auto run = here.elsie("run worlds/ten_robots.xml --duration 10 --json " + options);
    return json::parse(run.out).at("state_hash").get<std::string>();
  };
  const std::string plain = hash("");
  CHECK(hash("--explain run.trace") == plain);
  CHECK(hash("--explain run.trace --explain-times --record run.csv") == plain);
}

TEST_CASE("explain --json tells everything, episodes unabridged") {
  Workplace here;
  here.elsie(
      "run worlds/ten_robots.xml --duration 30 --seed 4 --explain run.trace --explain-times "
      "--quiet");
  const auto run = here.elsie("explain run.trace --robot r5 --robot r2 --from 5 --to 25 --json");
  CHECK(run.err.empty());
  CHECK(lines(run.out) == 1);
  const json told = json::parse(run.out);
  CHECK(told.at("seed") == 4);
  CHECK(told.at("outcome") == "time_limit");
  CHECK(told.at("from_s") == 5);
  CHECK(told.at("to_s") == 25);
  CHECK(told.at("end_s") == 30);
  REQUIRE(told.at("robots").size() == 2);
  const json& robot = told.at("robots")[0];
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
}

TEST_CASE("A long list of episodes is told in as many lines as wanted, or in full") {
  Workplace here;
  // Two behaviours in turns of a tenth of a second, for a minute.
  std::string trace =
      "# elsie trace 1\n"
      "# run world=\"turns\" file=\"\" seed=\"1\" step_s=\"0.01\" period_s=\"0.01\"\n"
      "# robot id=\"r1\" team=\"red\" coordinator=\"arbiter\"\n"
      "# behavior robot=\"r1\" path=\"a\" plugin=\"a\" coordinator=\"arbiter\" priority=\"1\"\n"
      "# behavior robot=\"r1\" path=\"b\" plugin=\"b\" coordinator=\"arbiter\" priority=\"1\"\n"
      "time_s,robot,behavior,asked,left,right,activation,strength,weight,share,reason,"
      "inhibited_by,event,detail\n";
  for (int i = 0; i < 600; ++i) {
    const std::string time = std::to_string(i / 10) + "." + std::to_string(i % 10);
    trace += time + ",r1,a,1,1,1,1,1,1," + (i % 2 ? "0" : "1") + "\n" + time +
             ",r1,b,1,1,1,1,1,1," + (i % 2 ? "1" : "0") + "\n";
  }
  here.write("turns.trace", trace + "# end time_s=\"60\" outcome=\"time_limit\" reason=\"\"\n");
  const auto few = here.elsie("explain turns.trace --episodes 5");
  CHECK(few.exit_code == 0);
  CHECK(lines(few.out) < 15);
  CHECK_THAT(few.out, Catch::Contains("who decided: 599 changes, 600 episodes told in 1 "));
  CHECK_THAT(few.out, Catch::Contains("a 50.0 %, b 50.0 %, 599 changes"));
  const auto all = here.elsie("explain turns.trace --all");
  CHECK(lines(all.out) > 600);
}

TEST_CASE("A trace that a kill cut short is told as far as it goes") {
  Workplace here;
  here.elsie("run worlds/clutter.xml --duration 10 --explain run.trace --quiet");
  std::string text = here.read("run.trace");
  text.resize(text.size() / 2);
  text.resize(text.rfind(',') + 1);
  here.write("cut.trace", text);
  const auto told = here.elsie("explain cut.trace --picture cut.svg");
  CHECK(told.exit_code == 0);
  CHECK_THAT(told.out, Catch::Contains("The trace has no end: the run was killed, or is still"));
  CHECK_THAT(told.out, Catch::Contains(" is cut off and was left out; everything before it"));
  CHECK_FALSE(here.read("cut.svg").empty());
}

TEST_CASE("A killed run leaves a trace behind") {
  Workplace here;
  const auto run = here.sh(
      "elsie --one-process run worlds/clutter.xml --duration 100000 --explain run.trace --quiet & "
      "while ! [ -s run.trace ] || [ \"$(wc -l < run.trace)\" -lt 500 ]; do sleep 0.05; done; "
      "kill -KILL $!; wait $! || true; elsie explain run.trace");
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.out, Catch::Contains("The trace has no end"));
}

TEST_CASE("explain and --explain refuse what they cannot work with in a sentence") {
  Workplace here;
  here.elsie("run worlds/clutter.xml --duration 2 --explain run.trace --quiet");
  here.write("mine.trace", "my own notes\n");
  here.write("broken.trace", here.read("run.trace") + "0,r1\n");
  const auto expect = [&](const std::string& arguments, const std::string& sentence) {
    CAPTURE(arguments);
    const auto run = here.elsie(arguments);
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    CHECK_THAT(run.err, Catch::Contains(sentence));
  };
  expect("run worlds/clutter.xml --explain run.csv", "a trace's name must end in .trace");
  expect("run worlds/clutter.xml --explain worlds/clutter.xml", "must end in .trace");
  expect("run worlds/clutter.xml --explain mine.trace", "is there already and is no trace");
  expect("run worlds/clutter.xml --explain nowhere/run.trace", "there is no folder 'nowhere'");
  expect("run worlds/clutter.xml --explain-times", "--explain");
  CHECK(here.read("mine.trace") == "my own notes\n");
  expect("explain", "TRACE");
  expect("explain nowhere.trace", "'nowhere.trace' cannot be read: No such file");
  expect("explain mine.trace", "'mine.trace' is no trace");
  expect("explain worlds/clutter.xml", "is no trace");
  expect("explain broken.trace", "something follows after the end of the trace");
  expect("explain run.trace --robot r2", "the trace has no robot 'r2'; did you mean 'r1'?");
  expect("explain run.trace --from 3", "--from: the trace ends at 2 s");
  expect("explain run.trace --from 2 --to 1", "--from must be less than --to");
  expect("explain run.trace --from nan", "--from");
  expect("explain run.trace --to 1,5", "--to");
  expect("explain run.trace --episodes 0", "--episodes");
  expect("explain run.trace --picture run.gif", "must end in .png or .svg");
  expect("explain run.trace --picture run.trace", "must end in .png or .svg");
}

TEST_CASE("explain tells what the user made of a priority in the run") {
  const Workplace here;
  here.write("blend.xml", R"(<world format="1"><robots><robot id="r1"><behaviors>
    <blend id="drive"><behaviors><wander priority="2"/></behaviors><coordinator><fusion_vector_summation/></coordinator></blend>
    <wander id="roam"/></behaviors><coordinator><fusion_vector_summation/></coordinator></robot></robots>
    <limits time="4"/></world>)");
  REQUIRE(here.elsie("run blend.xml --quiet --explain t.trace --at "
                     "'1:robot[r1]/behavior[roam]/@priority=0.25'"
                     " --at '2:robot[1]/behavior[drive]/behavior[1]/@priority=3'"
                     " --at '3:robot[*]/behavior[roam]/@priority=5'")
              .exit_code < 2);
  const std::string told = here.elsie("explain t.trace").out;
  CHECK_THAT(told, Catch::Matches("[\\s\\S]*\\n *roam +1, 0.25, 5 [\\s\\S]*"));
  CHECK_THAT(told, Catch::Matches("[\\s\\S]*\\n *wander +2, 3 [\\s\\S]*"));
}

TEST_CASE("A full disk ends the run with a sentence") {
  if (!std::filesystem::exists("/dev/full")) {
    return;
  }
  Workplace here;
  const auto run = here.elsie("run worlds/clutter.xml --duration 5 --explain /dev/full");
  CHECK(run.exit_code == 4);
  CHECK_THAT(run.err, Catch::Contains("'/dev/full' could not be written: No space left"));
}

TEST_CASE("A crash ends the trace at the last step that was whole") {
  Workplace here;
  here.write("world.xml",
             "<world format=\"1\"><robots><robot id=\"r1\" team=\"red\">\n"
             "<behaviors><segfaulting/></behaviors>\n"
             "<coordinator><arbiter_suppression/></coordinator>\n"
             "</robot></robots></world>\n");
  const auto run =
      here.elsie("run world.xml --plugin-path " + elsie::test::build_path("tests/program/plugins") +
                 " --explain crash.trace --record crash.csv");
  CHECK(run.exit_code == 3);
  const auto told = here.elsie("explain crash.trace");
  CAPTURE(told.out, told.err);
  CHECK(told.exit_code == 0);
  CHECK_THAT(told.out, Catch::Contains("stopped after 0.5 s: the program was brought down in the "
                                       "step after it"));
  CHECK_THAT(here.read("crash.csv"), Catch::Contains("\n0.5,r1,"));
}
