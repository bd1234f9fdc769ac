// elsie train, and worlds whose coordinators learn.
#include <fstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "places.h"
#include "program.h"

using elsie::test::Workplace;
using nlohmann::json;

namespace {

const std::string kLearners = "worlds/learned_priorities.xml";

/// A note of the run about its network, for example its error.
std::string note(const json& run) { return run.at("notes").at(0).at("text"); }

}  // namespace

TEST_CASE("train writes weights with which a run trains nothing and does the same") {
  Workplace here;
  const auto trained =
      here.elsie("train " + kLearners + " --robot r1 --seed 4 --weights r1.weights");
  CAPTURE(trained.err);
  REQUIRE(trained.exit_code == 0);
  CHECK_THAT(trained.out, Catch::StartsWith("r1, fusion_neural_network: network 2-2-2-2, seed 4\n"
                                            "mean error "));
  CHECK_THAT(trained.out, Catch::Contains("left  right  avoid_obstacle  answer  go_to_point"));
  CHECK_THAT(here.read("r1.weights"), Catch::StartsWith("elsie network 1\nsizes 2 2 2 2\n") &&
                                          Catch::Contains("about seed 4\n") &&
                                          Catch::EndsWith("\nend\n"));

  const json own =
      json::parse(here.elsie("run " + kLearners + " --seed 4 --duration 20 --json").out);
  const json loaded = json::parse(
      here.elsie("run " + kLearners +
                 " --seed 4 --duration 20 --json --set robot[r1]/coordinator/@weights=r1.weights")
          .out);
  CHECK_THAT(note(own), Catch::Contains("trained on two_sensors_two_behaviors.txt: mean error"));
  CHECK_THAT(note(loaded), Catch::Contains("with the weights of r1.weights; nothing is trained"));
  CHECK(own.at("state_hash") == loaded.at("state_hash"));
}

TEST_CASE("Weights that the world names may be missing, and those of another robot are kept") {
  Workplace here;
  const std::string train =
      "train " + kLearners +
      " --robot r1 --quiet --weights w --set robot[r1]/coordinator/@weights=w";
  const auto first = here.elsie(train);
  CAPTURE(first.err);
  REQUIRE(first.exit_code == 0);
  const std::string before = here.read("w");
  const auto refused = here.elsie(train +
                                  " --seed 3 --set 'robot[+]=<robot id=\"r2\" y=\"2\">"
                                  "<sensors><beam_range/></sensors><behaviors><wander/>"
                                  "</behaviors><coordinator><fusion_neural_network "
                                  "weights=\"w\"/></coordinator></robot>'");
  CHECK(refused.exit_code == 2);
  CHECK_THAT(refused.err, Catch::Contains("--weights: 'w' is") && Catch::Contains("is read here"));
  CHECK(here.read("w") == before);
}

TEST_CASE("train --json has the largest seed as a number, digit by digit") {
  const Workplace here;
  const auto run =
      here.elsie("train " + kLearners + " --seed 18446744073709551615 --presentations 9 --json");
  CHECK(json::parse(run.out).at("seed") == json(18446744073709551615U));
}

TEST_CASE("Weights of other layers than the default need not be announced in the world") {
  const Workplace here;
  REQUIRE(here.elsie("train " + kLearners + " --hidden '4 4' --weights w").exit_code == 0);
  const std::string run = "run " + kLearners + " --quiet --set robot[r1]/coordinator/@weights=w";
  CHECK(here.elsie(run).exit_code == 0);
  const auto refused = here.elsie(run + " --set 'robot[r1]/coordinator/@hidden=2 2'");
  CHECK(refused.exit_code == 2);
  CHECK_THAT(refused.err, Catch::Contains("its network is 2-4-4-2, but hidden is '2 2'; make it "
                                          "'auto' or leave it out"));
}

TEST_CASE("train gives the same bytes again for the same seed, and others for another") {
  Workplace here;
  for (const char* run : {"a --seed 2", "b --seed 2", "c --seed 3"}) {
    REQUIRE(here.elsie("train " + kLearners + " --quiet --weights " + run).exit_code == 0);
  }
  CHECK(here.read("a") == here.read("b"));
  CHECK(here.read("a") != here.read("c"));
}

TEST_CASE("train takes its options from the command line, and says how it went") {
  Workplace here;
  const auto run = here.elsie("train " + kLearners +
                              " --hidden '4 4' --learning-rate 0.5 --momentum 0.2 --threshold 0.001"
                              " --presentations 90000 --json --curve curve.png");
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  const json result = json::parse(run.out);
  CHECK(result.at("sizes") == json({2, 4, 4, 2}));
  CHECK(result.at("seed") == json(1));  // a number, as in elsie run --json
  CHECK(result.at("below_threshold") == true);
  CHECK(result.at("error").get<double>() < 0.0012);
  CHECK(result.at("presentations").get<int>() < 90000);
  CHECK(result.at("untrained") == false);
  CHECK(result.at("inputs") == json({"left", "right"}));
  CHECK(result.at("outputs") == json({"avoid_obstacle", "go_to_point"}));
  CHECK(result.at("samples").size() == 9);
  CHECK(result.at("samples")[0].at("targets") == json({0.0, 1.0}));
  // A point of the curve is a mean over several epochs: only the last epoch is below the threshold.
  CHECK(result.at("curve").back()[1].get<double>() < 0.0011);
  CHECK_THAT(here.read("curve.png"), Catch::StartsWith("\x89PNG"));
}

TEST_CASE("train --progress prints lines of JSON before the object") {
  Workplace here;
  const std::string most = " --presentations 2000000 --threshold 0 --json";
  const auto run = here.elsie("train " + kLearners + most + " --progress");
  CAPTURE(run.err);
  std::istringstream lines(run.out);
  std::vector<json> objects;
  for (std::string line; std::getline(lines, line);) {
    objects.push_back(json::parse(line));
  }
  REQUIRE(objects.size() >= 2);
  std::uint64_t last = 0;
  for (std::size_t i = 0; i + 1 < objects.size(); ++i) {
    CHECK(objects[i].size() == 3);
    CHECK(objects[i].at("of") == 2000000);
    CHECK(objects[i].at("error").get<double>() > 0.0);
    CHECK(objects[i].at("presentations").get<std::uint64_t>() >= last);
    last = objects[i].at("presentations");
  }
  CHECK(objects.back() == json::parse(here.elsie("train " + kLearners + most).out));
  CHECK(here.elsie("train " + kLearners + " --progress").exit_code == 2);
}

TEST_CASE("train --stdin reads the world from standard input, and files beside its name") {
  Workplace here;
  const auto from_file = here.elsie("train " + kLearners + " --json");
  const auto from_input = here.elsie("train " + kLearners + " --stdin --json < " + kLearners);
  CHECK(from_input.exit_code == 0);
  CHECK(from_input.out == from_file.out);
  const auto wrong = here.elsie("train " + kLearners + " --stdin --json < /dev/null");
  CHECK(wrong.exit_code == 2);
  CHECK(wrong.err.find(kLearners) != std::string::npos);
}

TEST_CASE("A network on the plateau ends train with exit code 1, and says so") {
  Workplace here;
  int untrained = 0;
  for (int seed = 1; seed <= 6; ++seed) {
    const auto run = here.elsie("train " + kLearners + " --hidden '2 2 2 2' --weights w --seed " +
                                std::to_string(seed));
    if (run.exit_code == 0) {
      CHECK_THAT(run.out, !Catch::Contains("untrained"));
      continue;
    }
    ++untrained;
    CHECK(run.exit_code == 1);
    CHECK_THAT(run.out, Catch::Contains("The network is untrained: it sits on a plateau"));
    CHECK_THAT(here.read("w"), Catch::EndsWith("end\n"));
  }
  CHECK(untrained > 0);
}

TEST_CASE("train refuses what it cannot do, and writes nothing then") {
  Workplace here;
  here.write("two.xml", R"(<world format="1"><robots>
    <robot id="a"><behaviors><wander/></behaviors><coordinator><arbiter_suppression/></coordinator></robot>
    <robot id="b" x="1"/></robots></world>)");
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {kLearners + " --robot r2", "there is no robot 'r2' in this world; did you mean 'r1'?"},
      {"two.xml", "say which with --robot: a, b"},
      {"two.xml --robot a",
       "'arbiter_suppression' of the robot 'a' does not learn; those that do: "
       "arbiter_learning, arbiter_neural_network, fusion_neural_network"},
      {"two.xml --robot b", "has no coordinator"},
      {kLearners + " --behavior explore", "there is no behaviour 'explore' in robot 'r1'"},
      {kLearners + " --behavior go_to_point", "holds no other behaviours"},
      {kLearners + " --hidden 4,4",
       "--hidden: coordinator 'fusion_neural_network': hidden is '4,4'"},
      {kLearners + " --learning-rate 2", "--learning-rate: learning_rate=\"2\" of "},
      {kLearners + " --momentum 0", "--momentum"},
      {kLearners + " --hidden 3 --momentum 1", "--momentum: coordinator"},
      {kLearners + " --training nothing.txt", "--training: training=\"nothing.txt\" of "},
      {kLearners + " --curve curve.jpg", "must end in .png or .svg"},
      {kLearners + " --presentations 99999999999999999999", "is not a whole number, or too large"},
      {kLearners + " --presentations 1e5", "'1e5' is not a whole number"},
      {kLearners + " --set robot[r1]/coordinator/@seed=3 --seed 4", "has the seed 3 of its own"},
      {"nothing.xml", "nothing.xml"}};
  for (const auto& [arguments, message] : wrong) {
    const auto run = here.elsie("train " + arguments + " --weights w");
    CAPTURE(arguments, run.err);
    CHECK(run.exit_code == 2);
    CHECK_THAT(run.err, Catch::Contains(message));
    CHECK(here.read("w").empty());
  }
  here.write("precious.xml", "<world/>");
  const auto over = here.elsie("train " + kLearners + " --weights precious.xml");
  CHECK(over.exit_code == 2);
  CHECK_THAT(over.err, Catch::Contains("is not a weight file"));
  CHECK(here.read("precious.xml") == "<world/>");
  CHECK(here.elsie("train " + kLearners + " --weights no/such/folder/w").exit_code == 2);
  CHECK(here.elsie("train " + kLearners + " --weights both.png --curve ./both.png").err ==
        "elsie: --curve: './both.png' is also the file of --weights; choose another name\n");
  CHECK(here.read("both.png").empty());
}

TEST_CASE("An interrupted training writes nothing") {
  Workplace here;
  const auto run = here.sh("elsie train " + kLearners +
                           " --presentations 1000000000000 --weights w --json --progress > lines & "
                           "pid=$!\n"
                           "until [ -s lines ]; do sleep 0.02; done\n"
                           "kill -INT $pid; wait $pid");
  CHECK(run.exit_code == 4);
  CHECK_THAT(run.err,
             Catch::Contains("interrupted after") && Catch::Contains("nothing was written"));
  CHECK(here.read("w").empty());
}

TEST_CASE("A coordinator inside a behaviour can be trained, too") {
  Workplace here;
  here.write("blend.xml", R"(<world format="1"><robots><robot id="r1">
    <sensors><beam_range id="left" yaw_deg="15"/><beam_range id="right" yaw_deg="-15"/></sensors>
    <behaviors><blend id="drive">
      <behaviors><avoid_obstacle/><wander/></behaviors>
      <coordinator><arbiter_neural_network training="training_sets/two_sensors_two_behaviors.txt"/></coordinator>
    </blend></behaviors>
    <coordinator><arbiter_suppression/></coordinator></robot></robots><limits time="1"/></world>)");
  const auto run = here.elsie("train blend.xml --behavior drive --weights w --seed 2");
  CAPTURE(run.err);
  CHECK(run.exit_code == 0);
  const json own = json::parse(here.elsie("run blend.xml --seed 2 --json").out);
  CHECK_THAT(here.read("w"), Catch::Contains("about behaviors avoid_obstacle wander"));
  const std::string text = note(own);
  CHECK_THAT(run.out, Catch::Contains(text.substr(text.find("mean error"), 20)));
}

TEST_CASE("A coordinator is trained for its robot, equipped as in a run") {
  const Workplace here;
  here.write("body.xml", R"(<world format="1">
  <chargers><charger id="far" x="4" y="4"/><charger id="near" x="-1" y="2" team="blue"/></chargers>
  <robots>
    <robot id="first" team="blue" x="-2"/><robot id="other" team="red"/>
    <robot id="odd" team="blue" x="1" leader="true" max_speed="0.3" coverage="2" battery="800">
      <body length="0.2" width="0.12" wheel_radius="0.03"/>
      <sensors><beam_range id="nose"/><beam_range id="back" x="-0.05"/></sensors>
      <behaviors><wander/></behaviors>
      <coordinator><body_learner/></coordinator>
    </robot>
  </robots></world>)");
  const auto run = here.elsie("train body.xml --robot odd --weights w --plugin-path " +
                              elsie::test::build_path("tests/program/plugins"));
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK_THAT(here.read("w"), Catch::Contains("about body 0.03 0.065 0.2 0.12 0.3 2 800\n") &&
                                 Catch::Contains("about team blue 1 1 charger -1 2\n") &&
                                 Catch::Contains("about sensors nose 0.1 back -0.05 wander\n"));
}

TEST_CASE("A mistake in the world is reported for its line, with any options") {
  const Workplace here;
  here.write("short.txt", "1 1 0 1\n1 1 0\n");
  const auto run = here.elsie("train " + kLearners +
                              " --set robot[r1]/coordinator/@training=short.txt"
                              " --learning-rate 0.5 --threshold 0.1");
  CHECK(run.exit_code == 2);
  CHECK_THAT(run.err, Catch::StartsWith(kLearners + ":22: plugin") &&
                          Catch::Contains("short.txt:2: 3 numbers"));
}

TEST_CASE("The robot with learned priorities arrives, whatever the seed") {
  Workplace here;
  for (int seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    CHECK(here.elsie("run " + kLearners + " --quiet --seed " + std::to_string(seed)).exit_code ==
          0);
  }
}
