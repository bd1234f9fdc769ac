// Weights, samples and robots that do not fit.
#include <catch2/catch.hpp>

#include "support.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::test;
using elsie::test::wheels;

TEST_CASE("Samples that do not fit the robot are refused when it is put together") {
  Files files;
  Team team;
  add_two_behaviors(team);
  Situation two = beams(1, 1);
  const Object three_columns = coordinator(kFusion, {{"training", files.text("1 1 0 1\n1 0 1\n")}});
  CHECK_THAT(refusal(*three_columns, team, two),
             Catch::Contains(":2: 3 numbers, expected 4: 2 inputs (one for each range sensor: ") &&
                 Catch::Contains("2 outputs (one for each behaviour: avoid_obstacle, "
                                 "find_resource)"));

  const Object reference = coordinator(kArbiter);
  Situation three = beams(1, 1);
  three.beam(0, 1);
  CHECK_THAT(refusal(*reference, team, three), Catch::Contains("expected 5: 3 inputs"));
  Situation none;
  CHECK_THAT(refusal(*reference, team, none), Catch::Contains("has none"));
  team.member("wander", 1, wheels(1, 1));
  CHECK_THAT(refusal(*reference, team, two), Catch::Contains("3 outputs"));

  const Object nothing = coordinator(kFusion, {{"training", std::string()}});
  CHECK_THAT(refusal(*nothing, team, two), Catch::Contains("nothing that its network could learn"));
}

TEST_CASE("Weights that do not fit are refused when the robot is put together") {
  Files files;
  Team team;
  add_two_behaviors(team);
  Situation now = beams(1, 1);
  const auto complaint = [&](const std::string& file, test::Parameters parameters = {}) {
    parameters["weights"] = file;
    return refusal(*coordinator(kFusion, std::move(parameters)), team, now);
  };
  const std::string fitting = files.weights({neural::Network({2, 3, 2}), {{"inputs", "metres"}}});
  CHECK(complaint(fitting).empty());
  CHECK(complaint(fitting, {{"hidden", std::string("3")}}).empty());
  CHECK(complaint(fitting, {{"hidden", std::string("auto")}}).empty());
  // "2 2" is the default of a trained network, but here the user asked for it.
  for (const std::string hidden : {"4 4", "2 2", "0"}) {
    CHECK_THAT(complaint(fitting, {{"hidden", hidden}}),
               Catch::Contains("2-3-2") && Catch::Contains("hidden is '" + hidden + "'"));
  }
  CHECK_THAT(complaint(fitting, {{"normalise", true}}),
             Catch::Contains("metres") && Catch::Contains("normalise is true"));
  CHECK_THAT(complaint(files.weights({neural::Network({3, 2})})),
             Catch::Contains("3 inputs and 2 outputs") && Catch::Contains("needs 2 inputs"));
  CHECK_THAT(complaint(files.weights({neural::Network({2, 2, 1})})),
             Catch::Contains("2 inputs and 1 output"));
  CHECK_THAT(complaint(files.text("elsie network 2\n")), Catch::Contains("version"));
  CHECK_THAT(complaint(files.text("1 1 0 1\n")), Catch::Contains("no weight file"));
}

TEST_CASE("Weights that were trained for other behaviours are used, but it is said") {
  Files files;
  Team team;
  add_two_behaviors(team);
  const Object fusion = coordinator(
      kFusion, {{"weights", files.weights({neural::Network({2, 2}),
                                           {{"behaviors", "find_resource avoid_obstacle"}}})}});
  start(*fusion, team);
  REQUIRE(fusion->notes().size() == 2);
  CHECK_THAT(fusion->notes()[1], Catch::Contains("find_resource avoid_obstacle") &&
                                     Catch::Contains("avoid_obstacle find_resource here"));
}

TEST_CASE("Parameters that make no network are refused") {
  const auto refused = [](test::Parameters parameters, const char* complaint) {
    CHECK_THROWS_WITH(coordinator(kFusion, std::move(parameters)), Catch::Contains(complaint));
  };
  refused({{"hidden", std::string("2,2")}}, "hidden is '2,2'");
  refused({{"learning_rate", 0.0}}, "learning_rate is 0");
  refused({{"learning_rate", 1.0}}, "learning rate is 1, but must be a number above 0 and below 1");
  refused({{"learning_rate", 1.5}}, "learning_rate is 1.5");
  refused({{"momentum", 1.0}}, "momentum is 1");
  refused({{"momentum", -0.1}}, "momentum is -0.1");
  refused({{"threshold", -1.0}}, "threshold is -1");
  refused({{"presentations", std::int64_t{0}}}, "presentations is 0");
  refused({{"seed", std::int64_t{-2}}}, "seed is -2");
}

TEST_CASE("Robots without range sensors are refused by the declaration") {
  for (const char* name : {kFusion, kArbiter}) {
    const Declaration* declaration = test::shipped().find(PluginKind::coordinator, name);
    REQUIRE(declaration);
    REQUIRE(declaration->needs.size() == 1);
    CHECK(declaration->needs[0].kind == "range");
  }
}
