// elsie run --at: changing a world while it runs.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program.h"

using elsie::test::Workplace;
using nlohmann::json;

namespace {

const std::string kRun = "run worlds/open_arena.xml --duration 4 --json";

std::vector<std::string> changes_in(const json& result) {
  std::vector<std::string> changes;
  for (const json& event : result.at("events")) {
    if (event.at("name") == "changed") {
      changes.push_back(event.at("time_s").dump() + " " + event.at("robot").get<std::string>() +
                        " " + event.at("detail").get<std::string>());
    }
  }
  return changes;
}

}  // namespace

TEST_CASE("--at changes the world in the run, and the result lists the changes") {
  Workplace here;
  const auto run = here.elsie(kRun +
                              " --at '2:robot[r1]/@max_speed=0.1' --at '1:robot[r1]/@x=-1'"
                              " --at '1:robot[r1]/@y=-1.5' --at '0:sensor[*]/@error=0.1'");
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 1);
  CHECK(run.err.empty());
  const json result = json::parse(run.out);
  const std::vector<std::string> changes = changes_in(result);
  REQUIRE(changes.size() > 4);
  CHECK(changes_in(json::parse(here.elsie(kRun + " --at '1:robots/robot/@max_speed=0.1'").out)) ==
        std::vector<std::string>{"1.0 r1 robot[r1]/@max_speed=0.1"});
  CHECK(changes.front().starts_with("0.0 r1 robot[r1]/sensor["));
  CHECK(std::vector(changes.end() - 3, changes.end()) ==
        std::vector<std::string>{"1.0 r1 robot[r1]/@x=-1", "1.0 r1 robot[r1]/@y=-1.5",
                                 "2.0 r1 robot[r1]/@max_speed=0.1"});
  // No faster than that in the last two of four seconds.
  const double driven = result.at("robots")[0].at("distance_m");
  CHECK(driven < json::parse(here.elsie(kRun).out).at("robots")[0].at("distance_m"));
}

TEST_CASE("Runs with the same changes are the same, whether they are recorded or not") {
  Workplace here;
  const std::string changed = kRun + " --seed 4 --at '1.5:behavior[wander]/@speed=18'";
  const auto hash = [&](const std::string& arguments) {
    return json::parse(here.elsie(arguments).out).at("state_hash").get<std::string>();
  };
  const std::string first = hash(changed);
  CHECK(hash(changed + " --record run.mcap --record run.csv") == first);
  CHECK(hash(kRun + " --seed 4") != first);
  const auto explained = json::parse(here.elsie("explain run.mcap --json").out);
  const json& event = explained.at("robots").at(0).at("events").at(0);
  CHECK(event.at("name") == "changed");
  CHECK(event.at("detail") == "robot[r1]/behavior[wander]/@speed=18");
  CHECK(event.at("time_s") == 1.5);
  CHECK_THAT(here.elsie("explain run.mcap").out, Catch::Contains("changed"));
}

TEST_CASE("A change that cannot be made is reported before the run, with exit code 2") {
  Workplace here;
  const std::string before =
      "time_s,robot,x_m,y_m,heading_rad,forward_m_s,lateral_m_s,turn_rad_s,distance_m,energy,"
      "asked_forward_m_s,asked_lateral_m_s,asked_turn_rad_s,"
      "command_forward_m_s,command_lateral_m_s,command_turn_rad_s,what was there before\n";
  here.write("run.csv", before);
  const auto expect = [&](const std::string& change, const std::string& sentence) {
    CAPTURE(change);
    const auto run = here.elsie(kRun + " --record run.csv --at '" + change + "'");
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    CHECK(run.err == "elsie: --at" + sentence + "\n");
    CHECK(here.read("run.csv") == before);
  };
  const std::string form = "; expected TIME:EDIT, as in '5:robot[r1]/@max_speed=0.2'";
  expect("robot[r1]/@max_speed=0.2",
         " robot[r1]/@max_speed=0.2: there is no ':' after a time" + form);
  expect("1,5:robot[r1]/@max_speed=0.2",
         " 1,5:robot[r1]/@max_speed=0.2: '1,5' is not a time in seconds" + form);
  expect("1:robot[r1]/@max_speed", " 1:robot[r1]/@max_speed: there is no '=' after a path" + form);
  expect("4:robot[r1]/@max_speed=0.2",
         ": robot[r1]/@max_speed=0.2: its time is 4 s, but the run begins at 0 and ends after 4 s "
         "at the latest; expected a time in between, before the last step begins");
  expect("1:robot[r9]/@x=1", ": at 1 s, robot[r9]/@x=1: there is no robot[r9]; there are: r1");
  expect("1:robot[r1]/@energy=6000",
         ": at 1 s, robot[r1]/@energy=6000: the battery of the robot 'r1' holds 5000 units; "
         "expected no more than that");
}

TEST_CASE("A move to a place that is then occupied ends the run with exit code 2") {
  Workplace here;
  const auto run = here.elsie(kRun + " --record run.csv --at '1:robot[r1]/@x=1.99'");
  CHECK(run.exit_code == 2);
  CHECK(run.out.empty());
  CHECK_THAT(run.err, Catch::StartsWith("elsie: --at: at 1 s, robot[r1]/@x=1.99: the robot 'r1' "
                                        "reaches ") &&
                          Catch::Contains(" m into the east wall; expected a free place in the "
                                          "arena\nthe run ended there; what was recorded until "
                                          "then is kept\n"));
  const std::string table = here.read("run.csv");
  CHECK(std::count(table.begin(), table.end(), '\n') == 1 + 11);
}

TEST_CASE("elsie lists what may change while a world runs") {
  Workplace here;
  CHECK_THAT(here.elsie("run --help").out, Catch::Contains("--at TIME:EDIT"));
  const std::string world = here.elsie("describe world").out;
  CHECK_THAT(world, Catch::Contains("no wheel rolls faster than this; may change while the world "
                                    "runs"));
  CHECK_THAT(world, !Catch::Contains("its battery when full; may change"));
  CHECK_THAT(here.elsie("describe fusion_neural_network").out,
             Catch::Contains("an edit in a run creates the plugin again"));
  CHECK_THAT(here.elsie("describe wander").out,
             !Catch::Contains("an edit in a run creates the plugin again"));
  const json network = json::parse(here.elsie("describe fusion_neural_network --json").out);
  for (const json& parameter : network.at("parameters")) {
    CHECK(parameter.value("live", true) == (parameter.at("name") == "weights"));
  }
}

TEST_CASE("Wrong edits of a file are reported where they stand, by check, run and batch") {
  Workplace here;
  const auto world = [](const std::string& changes) {
    return "<world format=\"1\"><limits time=\"2\"/><robots><robot id=\"r1\"/></robots>\n" +
           changes + "</world>\n";
  };
  here.write("wrong.xml",
             world("<changes>\n<change time=\"1\" path=\"robot[r9]/@x\" value=\"1\"/>\n"
                   "<change time=\"1.5\" path=\"robot[r1]/@max_speed\" value=\"fast\"/>\n"
                   "</changes>"));
  for (const std::string command : {"check ", "run "}) {
    const auto wrong = here.elsie(command + "wrong.xml");
    CHECK(wrong.exit_code == 2);
    CHECK_THAT(wrong.err,
               Catch::Contains("wrong.xml:3: at 1 s, robot[r9]/@x=1: there is no "
                               "robot[r9]; there are: r1\n") &&
                   Catch::Contains("wrong.xml:4: at 1.5 s, robot[r1]/@max_speed=fast: ") &&
                   !Catch::Contains("--at"));
  }
  here.write("engines.xml",
             world("<changes>\n<change time=\"1\" path=\"robot[r1]/@x\" value=\"1\"/>\n"
                   "<change time=\"1\" path=\"physics/@engine\" value=\"planar\"/>\n"
                   "<change time=\"1.5\" path=\"physics/@engine\" value=\"planr\"/>\n</changes>"));
  for (const std::string command : {"check ", "run "}) {
    const auto engines = here.elsie(command + "engines.xml");
    CHECK(engines.exit_code == 2);
    CHECK_THAT(engines.err,
               Catch::Contains("engines.xml:4: at 1 s, physics/@engine=planar: one engine cannot "
                               "take over the bodies of another") &&
                   Catch::Contains("engines.xml:5: at 1.5 s, physics/@engine=planr: ") &&
                   !Catch::Contains("engines.xml:3"));
  }
  here.write("right.xml", world(""));
  here.write("study.xml",
             "<experiment format=\"1\"><worlds><world file=\"right.xml\"/></worlds>\n"
             "<at time=\"1\">\n<set path=\"robot[r9]/@remove\" value=\"true\"/></at>\n"
             "<seeds from=\"1\" to=\"2\"/></experiment>\n");
  for (const std::string command : {"check study.xml", "batch study.xml --database s.sqlite"}) {
    const auto wrong = here.elsie(command);
    CHECK(wrong.exit_code == 2);
    CHECK_THAT(wrong.err,
               Catch::Contains("study.xml:3: at 1 s, robot[r9]/@remove=true: there is no "
                               "robot[r9]; there are: r1"));
  }
  CHECK(!std::filesystem::exists(here.file("s.sqlite")));
}

TEST_CASE("A recording gives its run again, with all edits") {
  Workplace here;
  const std::string edits =
      " --at '0:obstacle[+]=<static_box id=\"a\" x=\"1\" y=\"1.2\"/>' --at "
      "'1:robot[r1]/@max_speed=0.2'"
      " --at '1.5:robot[+]=<robot id=\"late\" x=\"-1.5\" y=\"1.5\" "
      "template=\"../robots/scout.xml\"/>' --at '2:physics/@step=0.005'"
      " --at '3:obstacle[a]/@remove=true'";
  const auto hash = [&](const std::string& run) {
    const auto result = here.elsie(run + " --json");
    CAPTURE(result.err);
    REQUIRE(result.exit_code <= 1);
    return json::parse(result.out).at("state_hash").get<std::string>();
  };
  const std::string first =
      hash("run worlds/open_arena.xml --seed 5 --duration 4 --record run.mcap" + edits);
  const auto replayed = here.elsie("replay run.mcap --world again.xml");
  CAPTURE(replayed.err);
  REQUIRE(replayed.exit_code == 0);
  CHECK_THAT(replayed.out,
             Catch::StartsWith("the same run: elsie run again.xml --seed 5 --duration 4\n"));
  CHECK(hash("run again.xml --seed 5 --duration 4") == first);
  CHECK(hash("run worlds/open_arena.xml --seed 5 --duration 4") != first);
  CHECK(here.elsie("replay run.mcap --world again.xml").exit_code == 2);

  const json said = json::parse(here.elsie("replay run.mcap --json --world third.xml").out);
  CHECK(said.at("seed") == 5);
  CHECK(said.at("state_hash") == first);
  CHECK(said.at("complete") == true);
  CHECK(said.at("duration_s") == 4.0);
  CHECK(said.at("command") == "elsie run third.xml --seed 5 --duration 4");
  CHECK_FALSE(json::parse(here.elsie("replay run.mcap --json").out).contains("command"));
}

TEST_CASE(
    "A run of a batch is done again with its edits and data files, from its world alone, too") {
  Workplace here;
  here.write("study.xml", R"(<experiment format="1" name="study">
  <worlds><world file="worlds/maze.xml"/></worlds>
  <set path="limits/@time" value="4"/>
  <vary name="edit">
    <level label="slow"><at time="2"><set path="robot[1]/@max_speed" value="0.1"/></at></level>
    <level label="more"><at time="2"><set path="obstacle[+]"><static_box id="more" x="2.8" y="-2.8" length="0.05" width="0.05"/></set></at></level>
  </vary>
  <seeds from="1" to="1"/>
</experiment>
)");
  const auto batch = here.elsie("batch study.xml --database s.sqlite");
  CAPTURE(batch.out, batch.err);
  REQUIRE(batch.exit_code <= 1);
  for (const std::string run : {"1", "2"}) {
    const auto replay = here.elsie("replay s.sqlite " + run);
    CAPTURE(replay.out, replay.err);
    CHECK(replay.exit_code == 0);
    CHECK_THAT(replay.out, Catch::Contains("the same: state hash"));
  }
  const auto written = here.elsie("replay s.sqlite 2 --world 'of run 2.xml'");
  CAPTURE(written.out, written.err);
  REQUIRE(written.exit_code == 0);
  CHECK_THAT(written.out, Catch::StartsWith("the same run: elsie run 'of run 2.xml' --seed 1\n"));
  const auto run = here.elsie("run 'of run 2.xml' --seed 1 --json");
  const auto again = here.elsie("replay s.sqlite 2");
  CAPTURE(run.err, again.out);
  CHECK_THAT(again.out, Catch::Contains("the same: state hash " +
                                        json::parse(run.out).at("state_hash").get<std::string>()));
  CHECK(here.elsie("replay s.sqlite 2 --world 'of run 2.xml'").exit_code == 2);
  const json said = json::parse(here.elsie("replay s.sqlite 2 --json --world other.xml").out);
  CHECK(said == json{{"seed", 1}, {"command", "elsie run other.xml --seed 1"}});
  const auto alone = here.elsie("replay s.sqlite 2 --json");
  CHECK(alone.exit_code == 2);
  CHECK_THAT(alone.err, Catch::Contains("it needs --world"));
}

TEST_CASE("Edits after the end of a run are warned of by check and batch, at their lines") {
  Workplace here;
  here.write("room.xml",
             "<world format=\"1\"><limits time=\"2\"/><robots><robot id=\"r1\"/></robots>\n"
             "<changes>\n<change time=\"5\" path=\"@name\" value=\"b\"/></changes></world>\n");
  const std::string sentence =
      "warning: The edits at 5 s are not made: the run ends after 2 s at the latest.\n";
  const auto room = here.elsie("check room.xml");
  CHECK(room.exit_code == 0);
  CHECK(room.err == "room.xml:3: " + sentence);
  here.write("plain.xml", "<world format=\"1\"><robots><robot id=\"r1\"/></robots></world>");
  here.write("study.xml",
             "<experiment format=\"1\"><worlds><world file=\"plain.xml\"/></worlds>\n"
             "<set path=\"limits/@time\" value=\"2\"/>\n<at time=\"5\">\n"
             "<set path=\"@name\" value=\"b\"/></at>\n"
             "<seeds from=\"1\" to=\"2\"/></experiment>\n");
  for (const std::string command : {"check study.xml", "batch study.xml --database s.sqlite"}) {
    const auto study = here.elsie(command);
    CAPTURE(command, study.err);
    CHECK(study.exit_code <= 1);
    CHECK_THAT(study.err, Catch::Contains("study.xml:4: " + sentence));
  }
}
