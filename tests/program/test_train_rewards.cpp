// elsie train, of coordinators that learn from the rewards of their world.
#include <filesystem>
#include <set>
#include <sstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "places.h"
#include "program.h"

using elsie::test::Workplace;
using nlohmann::json;

namespace {

/// A robot whose first behaviour leads away from what it should collect.
std::string small_world(
    const std::string& attributes = "",
    const std::string& rewards = "<reward id='food' robot='r1' of='collected'/>") {
  return R"(<world format="1">
  <arena length="6" width="4"/>
  <resources><resource id="apple" x="0.35" y="0"/></resources>
  <robots>
    <robot id="r1">
      <behaviors>
        <go_to_point id="west" x="-2" y="0"/>
        <go_to_point id="east" x="2" y="0"/>
      </behaviors>
      <coordinator>
        <arbiter_learning )" +
         attributes + R"(><feature of="x"/></arbiter_learning>
      </coordinator>
    </robot>
    <robot id="r2" x="-2" y="1.5"/>
  </robots>
  <goals><collect/></goals>
  <limits time="10"/>
  <measures>)" +
         rewards + "</measures>\n</world>\n";
}

}  // namespace

TEST_CASE("train learns values from rewards, and with them a run reaches its goal") {
  Workplace here;
  here.write("small.xml", small_world());
  const auto trained =
      here.elsie("train small.xml --robot r1 --episodes 30 --seed 3 --values learned");
  CAPTURE(trained.err);
  REQUIRE(trained.exit_code == 0);
  CHECK_THAT(trained.out,
             Catch::StartsWith("r1, arbiter_learning: food; 30 episodes from seed 3, in ") &&
                 Catch::Contains("the last 3: mean reward 1, success in 3 of 3\n") &&
                 Catch::EndsWith("\nvalues: learned\n"));
  CHECK_THAT(here.read("learned"),
             Catch::StartsWith("elsie values 1\nabout method q\nabout behaviors west east\n"
                               "about features x at 0.5\nabout rewards food\n"
                               "about training 30 episodes from seed 3, exploration 0.3\n"
                               "table value 2 2\n") &&
                 Catch::EndsWith("\nend\n"));
  const std::string run = "run small.xml --json --set robot[r1]/coordinator/@";
  const json result = json::parse(here.elsie(run + "values=learned").out);
  CHECK(result.at("outcome") == "success");
  CHECK_THAT(result.at("notes").at(0).at("text").get<std::string>(),
             Catch::Equals("Values of learned, learned in 30 episodes from seed 3, exploration "
                           "0.3; nothing is learned."));
  CHECK(json::parse(here.elsie(run + "untrained=true").out).at("outcome") == "time_limit");
}

TEST_CASE("The same seed gives the same file, and another one another") {
  Workplace here;
  here.write("small.xml", small_world());
  for (const char* how : {"a --seed 2", "b --seed 2", "c --seed 9"}) {
    REQUIRE(here.elsie("train small.xml --robot r1 --quiet --episodes 12 --explore 1 --values " +
                       std::string(how))
                .exit_code == 0);
  }
  CHECK(here.read("a") == here.read("b"));
  CHECK(here.read("a") != here.read("c"));
}

TEST_CASE("Values of before do not matter to a training, and a run does not change them") {
  Workplace here;
  here.write("small.xml", small_world());
  REQUIRE(here.elsie("train small.xml --robot r1 --quiet --episodes 12 --explore 1 --values a")
              .exit_code == 0);
  here.write("trained.xml", small_world("values=\"a\""));
  const std::string before = here.read("a");
  CHECK(here.elsie("run trained.xml --quiet").exit_code == 0);
  CHECK(here.read("a") == before);
  REQUIRE(here.elsie("train trained.xml --robot r1 --quiet --episodes 12 --explore 1 --values b")
              .exit_code == 0);
  CHECK(here.read("b") == before);
}

TEST_CASE("A training from rewards says how each episode went, as JSON, and draws it") {
  Workplace here;
  here.write("small.xml", small_world());
  const auto run = here.elsie(
      "train small.xml --robot r1 --episodes 20 --explore 0.5 --json --progress "
      "--curve rewards.png");
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  std::istringstream lines(run.out);
  std::vector<json> objects;
  for (std::string line; std::getline(lines, line);) objects.push_back(json::parse(line));
  REQUIRE(objects.size() >= 2);
  CHECK(objects[0].at("of") == 20);
  CHECK(objects[0].at("episode") == 1);
  CHECK(objects[0].contains("reward"));
  const json& result = objects.back();
  CHECK(result.at("robot") == "r1");
  CHECK(result.at("plugin") == "arbiter_learning");
  CHECK(result.at("seed") == 1);
  CHECK(result.at("explore") == 0.5);
  CHECK(result.at("rewards") == json({"food"}));
  CHECK(result.at("untrained") == false);
  REQUIRE(result.at("episodes").size() == 20);
  const json& last = result.at("episodes").back();
  CHECK(last.at("reward") == 1.0);
  CHECK(last.at("rewards") == json({1.0}));
  CHECK(last.at("outcome") == "success");
  CHECK(last.at("time_s").get<double>() < 10.0);
  CHECK_THAT(here.read("rewards.png"), Catch::StartsWith("\x89PNG"));
}

TEST_CASE("Where no reward ever comes, the values stay 0, and train says so") {
  Workplace here;
  here.write("small.xml", small_world("", "<reward of='0 * collected'/>"));
  const auto run = here.elsie("train small.xml --robot r1 --episodes 2 --values w");
  CHECK(run.exit_code == 1);
  CHECK_THAT(run.out,
             Catch::Contains("It is untrained: all values are 0. In no episode was there a "
                             "reward of "));
  CHECK_THAT(here.read("w"), Catch::EndsWith("end\n"));
}

TEST_CASE("Rewards of others do not count, those of all do; agents have the names of theirs") {
  Workplace here;
  here.write("small.xml", small_world("method=\"w\"",
                                      "<reward id='food' robot='r1' of='collected'/>"
                                      "<reward id='all' of='-collisions'/>"
                                      "<reward id='other' robot='r2' of='collected'/>"
                                      "<path_length/>"));
  REQUIRE(here.elsie("train small.xml --robot r1 --quiet --episodes 30 --explore 1 --values w")
              .exit_code == 0);
  CHECK_THAT(here.read("w"),
             Catch::Contains("about rewards food all\n") && Catch::Contains("table food 2 2\n") &&
                 Catch::Contains("table all 2 2\n") && Catch::Contains("table W 2 2\n"));
}

TEST_CASE("What cannot be trained from rewards is refused, and nothing is written") {
  Workplace here;
  here.write("small.xml", small_world());
  here.write("without.xml", small_world("", "<path_length/>"));
  here.write("w.xml", small_world("method=\"w\""));
  here.write("edited.xml", [] {
    std::string world = small_world();
    return world.insert(world.find("<measures>"),
                        "<changes><change time='1' path='robot[r1]/coordinator'>"
                        "<arbiter_suppression/></change></changes>");
  }());
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"without.xml --robot r1",
       "nothing rewards the robot 'r1': no measure of this world publishes a number 'reward' for "
       "it; add one to <measures>, such as <reward robot=\"r1\""},
      {"w.xml --robot r1", "with method=\"w\" rewards compete; its robot has one"},
      {"small.xml --robot r2", "the robot 'r2' has no coordinator"},
      {"edited.xml --robot r1", "an edit in the run put another one in its place"},
      {"small.xml --robot r1 --hidden 3",
       "--hidden: the coordinator 'arbiter_learning' has no network: it learns from rewards"},
      {"small.xml --robot r1 --learning-rate 0.3", "--learning-rate: the coordinator"},
      {"small.xml --robot r1 --weights other", "--weights: the coordinator"},
      {"small.xml --robot r1 --episodes 0", "--episodes"},
      {"small.xml --robot r1 --explore 1.5", "--explore"},
      {"worlds/learned_priorities.xml",
       "--values: the coordinator 'fusion_neural_network' learns from samples, not from rewards"},
      {"small.xml --robot r1 --curve w", "must end in .png or .svg"}};
  for (const auto& [arguments, message] : wrong) {
    const auto run = here.elsie("train " + arguments + " --values w");
    CAPTURE(arguments, run.err);
    CHECK(run.exit_code == 2);
    CHECK_THAT(run.err, Catch::Contains(message));
    CHECK(here.read("w").empty());
  }
  for (const char* option : {"--episodes 3", "--explore 0.1"}) {
    const auto run = here.elsie(std::string("train worlds/learned_priorities.xml ") + option);
    CHECK(run.exit_code == 2);
    CHECK_THAT(run.err, Catch::Contains("learns from samples, not from rewards"));
  }
  here.write("precious.xml", "<world/>");
  const auto over = here.elsie("train small.xml --robot r1 --values precious.xml");
  CHECK(over.exit_code == 2);
  CHECK_THAT(over.err, Catch::Contains("already exists and is not a file of values"));
  CHECK(here.read("precious.xml") == "<world/>");
}

TEST_CASE("A file of values that the world already names may be missing before the training") {
  Workplace here;
  here.write("small.xml", small_world("values=\"later\""));
  CHECK(here.elsie("run small.xml --quiet").exit_code == 2);
  const auto trained = here.elsie("train small.xml --robot r1 --quiet --values later");
  CAPTURE(trained.err);
  CHECK(trained.exit_code == 0);
  CHECK(here.elsie("run small.xml --quiet").exit_code == 0);

  here.write("wrong.xml", small_world("values=\"never\" rat=\"1\""));
  const auto wrong = here.elsie("train wrong.xml --robot r1 --values w");
  CHECK(wrong.exit_code == 2);
  CHECK_THAT(wrong.err, Catch::Contains("there is no such file") && Catch::Contains("rat"));
}

TEST_CASE("The values of another robot are not overwritten") {
  Workplace here;
  here.write("small.xml", small_world());
  REQUIRE(here.elsie("train small.xml --robot r1 --quiet --values hers").exit_code == 0);
  const std::string before = here.read("hers");
  std::string world = small_world("values=\"hers\"");
  const std::size_t robot = world.find("<robot id=\"r1\">");
  const std::size_t end = world.find("<robot id=\"r2\"");
  std::string other = world.substr(robot, end - robot);
  other.replace(other.find("\"r1\""), 4, "\"r3\" y=\"-1.5\"");
  here.write("two.xml", world.insert(end, other));
  const auto refused =
      here.elsie("train two.xml --robot r1 --quiet --episodes 3 --seed 9 --values hers");
  CHECK(refused.exit_code == 2);
  CHECK_THAT(refused.err,
             Catch::Contains("--values: 'hers' is") && Catch::Contains("is read here"));
  CHECK(here.read("hers") == before);
}

TEST_CASE("A limit of time on the clock ends no episode") {
  Workplace here;
  std::string world = small_world();
  world.replace(world.find("time=\"10\""), 9, "time=\"10\" wall_time=\"1e-9\"");
  here.write("hasty.xml", world);
  here.write("small.xml", small_world());
  for (const std::string name : {"hasty", "small"}) {
    REQUIRE(here.elsie("train " + name + ".xml --robot r1 --quiet --episodes 20 --values " + name)
                .exit_code == 0);
  }
  CHECK(here.read("hasty") == here.read("small"));
}

TEST_CASE("A learner whose values cannot be used is refused before the first episode") {
  Workplace here;
  for (const auto& [what, message] : {std::pair("nothing", "it has learned has no table of values"),
                                      {"uneven", "its table 'b' has 3 states, but 'a' has 2"},
                                      {"remark", "'odd' cannot be written as a remark"}}) {
    std::string world = small_world();
    const std::size_t begin = world.find("<arbiter_learning");
    const std::string end = "</arbiter_learning>";
    world.replace(begin, world.find(end) + end.size() - begin,
                  "<odd_learner what='" + std::string(what) + "'/>");
    here.write("odd.xml", world);
    const auto run =
        here.elsie("train odd.xml --robot r1 --json --progress --values w --plugin-path " +
                   elsie::test::build_path("tests/program/plugins"));
    CAPTURE(what, run.err);
    CHECK(run.exit_code == 2);
    CHECK_THAT(run.err, Catch::Contains("the coordinator 'odd_learner' of the robot 'r1': ") &&
                            Catch::Contains(message));
    CHECK(run.out.empty());
    CHECK(here.read("w").empty());
  }
}

TEST_CASE("Without values neither run nor check takes the world, and both name elsie train") {
  Workplace here;
  here.write("small.xml", small_world());
  for (const char* command : {"run small.xml", "check small.xml"}) {
    const auto refused = here.elsie(command);
    CAPTURE(command);
    CHECK(refused.exit_code == 2);
    CHECK_THAT(refused.err, Catch::StartsWith("small.xml:11: ") &&
                                Catch::Contains("it has no values: train it with `elsie train"));
  }
}

TEST_CASE("An interrupted training from rewards writes nothing") {
  Workplace here;
  here.write("small.xml", small_world());
  const auto run = here.sh(
      "elsie train small.xml --robot r1 --episodes 1000000 --values w --json --progress > lines & "
      "pid=$!\n"
      "until [ -s lines ]; do sleep 0.02; done\n"
      "kill -INT $pid; wait $pid");
  CHECK(run.exit_code == 4);
  CHECK_THAT(run.err,
             Catch::Contains("interrupted after") && Catch::Contains("nothing was written"));
  CHECK(here.read("w").empty());
}

TEST_CASE("In a world with layouts each episode has a world of its own, as runs have") {
  Workplace here;
  std::string world = small_world();
  world.insert(world.find("<measures>"),
               "<layouts><draw path='resource[apple]/@x' from='-0.9' to='-0.3'/></layouts>");
  here.write("drawn.xml", world);
  const auto run = here.elsie("train drawn.xml --robot r1 --episodes 6 --explore 0 --json");
  CAPTURE(run.err);
  const json episodes = json::parse(run.out).at("episodes");
  REQUIRE(episodes.size() == 6);
  std::set<double> times;
  for (const json& each : episodes) times.insert(each.at("time_s").get<double>());
  CHECK(times.size() >= 3);
}

TEST_CASE("The values of the shipped worlds are those that train learns in the scattered one") {
  Workplace here;
  const auto run =
      here.elsie("train worlds/scattered/learned_arbitration.xml --quiet --values learned");
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(here.read("learned") == here.read("training_sets/learned_arbitration.values"));
}

TEST_CASE("In the shipped world W-learning gets there, too") {
  Workplace here;
  const std::string w = " --set robot[r1]/coordinator/@method=w";
  REQUIRE(here.elsie("train worlds/learned_arbitration.xml --quiet --values learned" + w +
                     " --set robot[r1]/coordinator/@values/@remove=true")
              .exit_code == 0);
  CHECK(here.elsie("run worlds/learned_arbitration.xml --quiet" + w +
                   " --set robot[r1]/coordinator/@values=learned")
            .exit_code == 0);
}
