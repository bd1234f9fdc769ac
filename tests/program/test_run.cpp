#include <filesystem>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program.h"

using elsie::test::Workplace;
using nlohmann::json;

TEST_CASE("run --json prints one object and nothing else") {
  Workplace here;
  const auto run = here.elsie("run worlds/open_arena.xml --duration 5 --seed 9 --json");
  CHECK(run.exit_code == 1);  // five seconds are not enough for its goals
  CHECK(run.err.empty());
  const json result = json::parse(run.out);
  CHECK(result.at("outcome") == "time_limit");
  CHECK(result.at("seed") == 9);
  CHECK(result.at("simulated_s") == Approx(5.0));
  CHECK(result.at("steps") == 500);
  CHECK(result.at("wall_s").get<double>() > 0.0);
  CHECK(result.at("state_hash").get<std::string>().size() == 16);
  REQUIRE(result.at("robots").size() == 1);
  const json& robot = result.at("robots")[0];
  CHECK(robot.at("id") == "r1");
  CHECK(robot.at("team") == "red");
  CHECK(robot.at("distance_m").get<double>() > 0.1);
  CHECK(robot.at("collected") == 0);
  CHECK(robot.at("energy").get<double>() < 5000);
  CHECK(robot.at("pose").size() == 3);
  CHECK(robot.at("collisions") == 0);
  CHECK(result.at("events").is_array());
}

TEST_CASE("The same seed gives the same result, recorded or not; another seed another one") {
  Workplace here;
  const auto hash = [&](const std::string& options) {
    const auto run = here.elsie("run worlds/clutter_moving.xml --duration 20 --json " + options);
    return json::parse(run.out).at("state_hash").get<std::string>();
  };
  const std::string first = hash("--seed 3");
  CHECK(hash("--seed 3") == first);
  CHECK(hash("--seed 3 --record run.csv --record-rate 100 --record-times --picture run.png") ==
        first);
  CHECK(hash("--seed 4") != first);
}

TEST_CASE("run prints a short table and exits with 0 when the goals are reached") {
  Workplace here;
  const auto run = here.elsie("run worlds/pushing.xml");
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.out, Catch::StartsWith("success after "));
  CHECK_THAT(run.out, Catch::Contains("robot  team  distance m  collected  energy  collisions"));
  CHECK(run.err.empty());  // no progress bar without a terminal
  CHECK(here.elsie("run worlds/pushing.xml --quiet").out.empty());
}

TEST_CASE("run records and draws") {
  Workplace here;
  const auto run = here.elsie(
      "run worlds/ten_robots.xml --duration 3 --record run.csv --record-rate 5 --picture run.png "
      "--quiet");
  CHECK(run.exit_code == 1);
  const std::string table = here.read("run.csv");
  CHECK_THAT(table, Catch::StartsWith("time_s,robot,x_m,y_m,heading_rad"));
  CHECK(std::count(table.begin(), table.end(), '\n') == 1 + 10 * 16);
  CHECK_THAT(here.read("run.png"), Catch::StartsWith("\x89PNG"));
}

TEST_CASE("--graph draws what coordinators are made of, as it is at the end") {
  Workplace here;
  CHECK(here.elsie("run worlds/guard.xml --duration 1 --quiet --graph guard.svg").exit_code == 1);
  CHECK_THAT(here.read("guard.svg"), Catch::Contains("north_east") && Catch::Contains("#ffd966") &&
                                         Catch::Contains("r1: time_limit after 1.0 s"));
  const auto refusal = [&](const std::string& arguments) {
    const auto run = here.elsie("run " + arguments);
    CHECK(run.exit_code == 2);
    return run.err;
  };
  CHECK_THAT(refusal("worlds/open_arena.xml --graph a.svg"),
             Catch::Contains("--graph: no coordinator in this world shows a graph"));
  CHECK_THAT(refusal("worlds/guard.xml --graph r2=a.svg"), Catch::Contains("r2"));
  CHECK_THAT(refusal("worlds/guard.xml --graph a.gif"),
             Catch::Contains("--graph: a picture's name must end in .png or .svg"));
  CHECK_FALSE(std::filesystem::exists(here.file("a.svg")));
}

TEST_CASE("--graph refuses an automaton of too many states before the run") {
  Workplace here;
  std::string states;
  for (int i = 0; i < 401; ++i) {
    states += "<state name='s" + std::to_string(i) + "'><transition to='s" +
              std::to_string((i + 1) % 401) + "' after='1'/></state>";
  }
  here.write("ring.xml",
             "<world format='1'><arena length='4' width='4'/><robots><robot id='r' x='0' "
             "y='0'><behaviors><wander/></behaviors><coordinator><arbiter_states>" +
                 states +
                 "</arbiter_states></coordinator></robot></robots>"
                 "<limits time='1'/></world>");
  const auto run = here.elsie("run ring.xml --graph ring.svg");
  CHECK(run.exit_code == 2);
  CHECK(run.out.empty());
  CHECK_THAT(run.err, Catch::Contains("401 nodes") && Catch::Contains("at most 400"));
}

TEST_CASE("check prints what plugins note before a run, once for robots that are alike") {
  Workplace here;
  const std::string robot =
      "<behaviors><wander/></behaviors><coordinator><arbiter_states>"
      "<state name='top' behavior='wander' ends='success'/><state name='bottom' ends='success'/>"
      "</arbiter_states></coordinator></robot>";
  here.write("island.xml",
             "<world format='1'><arena length='4' width='4'/><robots>"
             "<robot id='a' x='-1' y='0'>" +
                 robot + "<robot id='b' x='1' y='0'>" + robot + "</robots></world>");
  const auto check = here.elsie("check island.xml");
  CHECK(check.exit_code == 0);
  CHECK(check.err ==
        "island.xml: note: a and 1 more robot, arbiter_states: the state 'bottom' is never reached "
        "from the first one\n");
  CHECK(here.elsie("check island.xml --quiet").err.empty());
}

TEST_CASE("--set changes any attribute by its path") {
  Workplace here;
  const auto distance = [&](const std::string& options) {
    const auto run = here.elsie("run worlds/open_arena.xml --duration 3 --json " + options);
    return json::parse(run.out).at("robots")[0].at("distance_m").get<double>();
  };
  CHECK(distance("--set 'robot[r1]/@max_speed=0.05'") < 0.4 * distance(""));
  CHECK(distance("--set 'robot[r1]/behavior[wander]/@speed=0' "
                 "--set 'robot[r1]/behavior[avoid_obstacle]/@priority=0'") < 0.001);
  const auto run = here.elsie("run worlds/pushing.xml --json --set limits/@time=0.5");
  CHECK(json::parse(run.out).at("simulated_s") == Approx(0.5));
}

TEST_CASE("Several threads change nothing in a run; 0 are refused") {
  Workplace here;
  const auto hash = [&](const std::string& options) {
    const auto run = here.elsie("run worlds/scattered/swarm.xml --duration 2 --json " + options);
    CHECK(json::parse(run.out).at("robots").size() > 64);  // few are not divided
    return json::parse(run.out).at("state_hash").get<std::string>();
  };
  CHECK(hash("--threads 3") == hash(""));
  const auto none = here.elsie("run worlds/ten_robots.xml --threads 0 --record none.csv");
  CHECK(none.exit_code == 2);
  CHECK(none.err.find("--threads: '0' is not a whole number from 1 to 256") != std::string::npos);
  CHECK(!std::filesystem::exists(here.file("none.csv")));
}

TEST_CASE("Before the run, while a network trains, an interrupt ends the program with a word") {
  Workplace here;
  for (const std::string command : {"run", "check"}) {
    // Shells have background processes ignore Ctrl-C. Once the program handles the signal, it soon
    // trains.
    const auto run =
        here.sh("env --default-signal=INT elsie " + command +
                " worlds/learned_priorities.xml --set "
                "'robot[r1]/coordinator/@presentations=2000000000' & pid=$!\n"
                "while kill -0 $pid; do\n"
                "  if grep -q '^SigCgt:.*[2367abef]$' /proc/$pid/status; then break; fi\n"
                "  sleep 0.02\n"
                "done 2> none\n"
                "sleep 0.5; kill -INT $pid; wait $pid");
    CHECK(run.exit_code == 4);
    CHECK(run.out.empty());
    // The plugin that trains the network, once it does.
    CHECK_THAT(run.err, Catch::StartsWith("elsie: ") && Catch::Contains("interrupted"));
    CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
  }
}

TEST_CASE("An interrupted run ends in order and keeps what was recorded") {
  Workplace here;
  const auto run = here.sh(
      "elsie run worlds/clutter.xml --set limits/@time=100000 --set 'robot[r1]/@battery=1e9' "
      "--record run.csv --quiet & pid=$!\n"
      "while ! [ -s run.csv ]; do :; done\n"
      "kill -TERM $pid; kill -HUP $pid\n"  // at once: one request
      "wait $pid");
  CHECK(run.exit_code == 4);
  CHECK_THAT(run.err, Catch::Contains("interrupted after"));
  const std::string table = here.read("run.csv");
  CHECK(table.back() == '\n');
}

TEST_CASE("A file that is named by a link is written to the link's target") {
  Workplace here;
  REQUIRE(here.sh("mkdir far && for name in run.png run.mcap run.csv; do "
                  "ln -s far/$name $name; done")
              .exit_code == 0);
  for (const std::string duration : {"1", "2"}) {  // the file is new, then it exists
    const std::string world = "run worlds/open_arena.xml --quiet --duration " + duration;
    CHECK(here.elsie(world + " --picture run.png --record run.mcap --record run.csv").err.empty());
    for (const std::string name : {"run.png", "run.mcap", "run.csv"}) {
      CAPTURE(name);
      CHECK(std::filesystem::is_symlink(here.file(name)));
      REQUIRE(std::filesystem::is_regular_file(here.file("far/" + name)));
      CHECK_FALSE(std::filesystem::is_symlink(here.file("far/" + name)));
    }
  }
  CHECK_THAT(here.elsie("replay run.mcap").out, Catch::Contains("after 2.0 s"));
  CHECK(here.read("far/run.png").starts_with("\x89PNG"));
}

TEST_CASE("Shipped worlds and experiments open by their short names from any folder") {
  Workplace here;
  CHECK(here.sh("cd / && elsie run worlds/contexts.xml --quiet").exit_code == 0);
  const auto check = here.sh("cd / && elsie check worlds/maze.xml experiments/top_speed.xml");
  CHECK(check.exit_code == 0);
  CHECK_THAT(check.out, Catch::StartsWith("worlds/maze.xml: in order"));
  here.sh("mkdir empty && cd empty && elsie batch experiments/top_speed.xml --quiet");
  CHECK(here.sh("ls empty/top_speed.sqlite").exit_code == 0);
  const auto wrong = here.sh("cd / && elsie run worlds/maize.xml");
  CHECK(wrong.exit_code == 2);
  CHECK_THAT(wrong.err, Catch::Contains("did you mean 'worlds/maze.xml'?"));
}
