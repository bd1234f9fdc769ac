// How networks are trained, and what is reported about it.
#include <catch2/catch.hpp>

#include "support.h"

using namespace elsie;
using namespace elsie::test;

TEST_CASE("Each run's stream trains a network of its own, the same for the same stream") {
  const Object fusion = coordinator(kFusion);
  Team team;
  add_two_behaviors(team);
  const auto trained = [&](std::uint64_t seed) {
    start(*fusion, team, seed);
    decide(*fusion, team, 0.7, 0.9);
    return weight(team, 0);
  };
  const double one = trained(1), two = trained(2);
  CHECK(one != two);
  CHECK(trained(1) == one);
  CHECK(trained(2) == two);
}

TEST_CASE("A seed of its own fixes the network, whatever the run") {
  const auto trained = [](std::int64_t seed, std::uint64_t run) {
    const Object fusion = coordinator(kFusion, {{"seed", seed}});
    Team team;
    add_two_behaviors(team);
    start(*fusion, team, run);
    decide(*fusion, team, 0.7, 0.9);
    return weight(team, 0);
  };
  CHECK(trained(7, 1) == trained(7, 2));
  CHECK(trained(7, 1) != trained(8, 1));
}

TEST_CASE("What a program trains is what the coordinator trains in a run") {
  for (const char* name : {kFusion, kArbiter}) {
    const Object object = coordinator(name, {{"hidden", std::string("3")}});
    const auto* trainable = dynamic_cast<const neural::Trainable*>(object.get());
    REQUIRE(trainable);
    CHECK(trainable->fixed_seed() == -1);
    Team team;
    add_two_behaviors(team);
    start(*object, team, 5);
    Random random(5);
    const neural::Lesson lesson = trainable->learn(random, {});
    CHECK(lesson.samples.size() == 9);
    CHECK(lesson.training.presentations == 200'000);
    CHECK(lesson.outputs == std::vector<std::string>{"avoid_obstacle", "find_resource"});
    neural::Workspace workspace(lesson.weights.network);
    const double inputs[] = {0.7, 0.9};
    double outputs[2];
    lesson.weights.network.evaluate(inputs, outputs, workspace);
    decide(*object, team, 0.7, 0.9);
    CHECK(weight(team, 0) == outputs[0]);
    CHECK(weight(team, 1) == outputs[1]);
  }
}

TEST_CASE("A training that misses a sample is tried again, as often as is allowed") {
  const Object once = coordinator(kFusion);
  const Object often = coordinator(kFusion, {{"attempts", std::int64_t{20}}});
  Team team;
  add_two_behaviors(team);
  const auto lesson = [&](const Object& object, std::uint64_t seed) {
    start(*object, team, seed);
    Random random(seed);
    return dynamic_cast<const neural::Trainable&>(*object).learn(random, {});
  };
  int missed = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const neural::Lesson first = lesson(once, seed), best = lesson(often, seed);
    CHECK(first.attempts == 1);
    CHECK(best.assessment.missed == 0);
    CHECK((best.attempts == 1) == (first.assessment.missed == 0));
    if (first.assessment.missed > 0) {
      ++missed;
      CHECK(best.assessment.error < first.assessment.error);
      CHECK_THAT(often->notes().front(),
                 Catch::Contains("the best of") && Catch::Contains("attempts"));
    } else {
      CHECK(best.assessment.answers == first.assessment.answers);
    }
  }
  CHECK(missed > 0);
}

TEST_CASE("Weights that were written are used as they are, and nothing is trained") {
  Files files;
  const Object trained = coordinator(kFusion, {{"hidden", std::string("4 4")}});
  Team team;
  add_two_behaviors(team);
  start(*trained, team, 3);
  decide(*trained, team, 0.7, 0.9);
  const double expected = weight(team, 0);
  Random random(3);
  const neural::Lesson lesson = dynamic_cast<const neural::Trainable&>(*trained).learn(random, {});
  const Object loaded = coordinator(kFusion, {{"weights", files.weights(lesson.weights)}});
  start(*loaded, team, 99);
  decide(*loaded, team, 0.7, 0.9);
  CHECK(weight(team, 0) == expected);
  const auto notes = loaded->notes();
  REQUIRE(notes.size() == 1);
  CHECK_THAT(notes[0], Catch::StartsWith("Network 2-4-4-2 with the weights of") &&
                           Catch::EndsWith("nothing is trained."));
}

TEST_CASE("The learning curve is that of the training, in at most two hundred points") {
  Team team;
  add_two_behaviors(team);
  for (const std::int64_t presentations : {9, 90, 1800, 3600, 200'000}) {
    CAPTURE(presentations);
    const Object object = coordinator(kFusion, {{"presentations", presentations}});
    CHECK(object->curves().empty());
    start(*object, team, 5);
    const std::vector<Curve> curves = object->curves();
    REQUIRE(curves.size() == 1);
    CHECK(curves[0].name == "error");
    Random random(5);
    const neural::Lesson lesson = dynamic_cast<const neural::Trainable&>(*object).learn(random, {});
    const auto& all = lesson.training.curve;
    const auto& points = curves[0].points;
    CHECK(points.size() == std::min<std::size_t>(points.size(), 200));
    CHECK(points.size() >= std::min<std::size_t>(all.size(), 100));
    // It begins and ends with the training.
    CHECK(points.front() ==
          Curve::Point{static_cast<double>(all.front().presentations), all.front().error});
    CHECK(points.back().x == static_cast<double>(all.back().presentations));
    // Nothing is left out: each point is the mean since the one before.
    std::size_t i = 0;
    for (const Curve::Point& point : points) {
      double sum = 0.0;
      int count = 0;
      for (; i < all.size() && static_cast<double>(all[i].presentations) <= point.x; ++i, ++count) {
        sum += all[i].error;
      }
      REQUIRE(count > 0);
      CHECK(point.y == Approx(sum / count));
    }
    CHECK(i == all.size());
  }
}

TEST_CASE("Weights from a file have no learning curve") {
  Files files;
  Team team;
  add_two_behaviors(team);
  const Object loaded = coordinator(kFusion, {{"weights", files.weights({simple_network()})}});
  start(*loaded, team);
  CHECK(loaded->curves().empty());
}

TEST_CASE("The notes tell error and presentations, and a plateau in words") {
  Team team;
  add_two_behaviors(team);
  const Object good = coordinator(kFusion);
  start(*good, team, 1);
  REQUIRE(good->notes().size() == 1);
  CHECK_THAT(good->notes()[0],
             Catch::StartsWith("Network 2-2-2-2 trained on two_sensors_two_behaviors.txt: mean "
                               "error ") &&
                 Catch::EndsWith("after 200000 presentations."));

  const Object deep = coordinator(kFusion, {{"hidden", std::string("2 2 2 2")}});
  int untrained = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    start(*deep, team, seed);
    const auto notes = deep->notes();
    REQUIRE_FALSE(notes.empty());
    if (notes.back().starts_with("The network is untrained")) {
      ++untrained;
      REQUIRE(notes.size() == 2);
      CHECK_THAT(notes[0], Catch::Contains("mean error 0.1139"));
      CHECK_THAT(notes[1], Catch::StartsWith("The network is untrained: it sits on a plateau") &&
                               Catch::Contains("same output whatever the input"));
    }
  }
  CHECK(untrained > 5);
}

TEST_CASE("Training options reach the training") {
  Team team;
  add_two_behaviors(team);
  const Object short_one = coordinator(kFusion, {{"presentations", std::int64_t{900}}});
  start(*short_one, team);
  CHECK_THAT(short_one->notes().at(0), Catch::Contains("after 900 presentations"));
  const Object easy = coordinator(kFusion, {{"threshold", 0.001}});
  start(*easy, team);
  CHECK_THAT(easy->notes().at(0), Catch::EndsWith(", below the threshold."));
}

TEST_CASE("A network whose layers nobody chose is trained with two of two neurons") {
  Team team;
  add_two_behaviors(team);
  for (const test::Parameters& parameters :
       {test::Parameters{}, test::Parameters{{"hidden", std::string("auto")}}}) {
    const Object fusion = coordinator(kFusion, parameters);
    start(*fusion, team);
    CHECK_THAT(fusion->notes().at(0), Catch::StartsWith("Network 2-2-2-2 trained"));
  }
}

TEST_CASE("Parameters that change take effect when the next run begins") {
  const Object fusion = coordinator(kFusion);
  Team team;
  add_two_behaviors(team);
  start(*fusion, team);
  const Declaration& declaration = *test::shipped().find(PluginKind::coordinator, kFusion);
  plugin::apply_parameters(declaration, *fusion, {{"hidden", std::string("4 4")}});
  CHECK_NOTHROW(decide(*fusion, team, 1, 1));  // the run continues
  Random random(1);
  fusion->reset(random);
  CHECK_THAT(fusion->notes().at(0), Catch::StartsWith("Network 2-4-4-2 trained"));
  CHECK_THROWS(plugin::apply_parameters(
      declaration, *fusion,
      {{"training", test::source_path("training_sets/three_sensors_two_behaviors.txt")}}));
}
