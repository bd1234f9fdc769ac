#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "elsie/neural/error.h"
#include "elsie/neural/trainable.h"

#include "shipped.h"
#include "situation.h"

using namespace elsie;
using elsie::test::Situation;
using elsie::test::Team;
namespace fs = std::filesystem;

namespace {

const char* const kFusion = "fusion_neural_network";
const char* const kArbiter = "arbiter_neural_network";

using Object = plugin::Object<Coordinator>;

/// A coordinator with these parameters; the reference samples unless others or weights are given.
Object coordinator(const char* name, test::Parameters parameters = {}) {
  if (!parameters.contains("weights")) {
    parameters["weights"] = std::string();
    parameters.try_emplace("training",
                           test::source_path("training_sets/two_sensors_two_behaviors.txt"));
  }
  parameters.try_emplace("training", std::string());
  return test::make<Coordinator>(PluginKind::coordinator, name, std::move(parameters));
}

/// Two behaviours, as the reference samples have them.
void add_two_behaviors(Team& team) {
  team.member("avoid_obstacle", 1, MotorCommand{-10, 10})
      .member("find_resource", 1, MotorCommand{20, 20});
}

Situation beams(double left, double right) {
  Situation now;
  now.beam(15, left).beam(-15, right);
  return now;
}

/// Equips the coordinator for a robot with two beams, and trains it with a seed.
void start(Coordinator& object, Team& team, std::uint64_t seed = 1) {
  Situation now = beams(1, 1);
  object.equipped(team.members(), now.perception());
  Random random(seed);
  object.reset(random);
}

/// What it makes of these readings: command, and the trace in the team.
MotorCommand decide(Coordinator& object, Team& team, double left, double right) {
  for (Member& member : team.members()) {
    member.begin_step();
  }
  Situation now = beams(left, right);
  return object.coordinate(team.members(), now.perception());
}

double weight(Team& team, std::size_t i) { return team.members()[i].trace.weight; }
double share(Team& team, std::size_t i) { return team.members()[i].trace.share; }
std::string reason(Team& team, std::size_t i) { return team.members()[i].trace.reason; }

/// Weight files in a folder of their own.
class Files {
 public:
  Files() {
    std::string name = (fs::temp_directory_path() / "elsie-test-XXXXXX").string();
    if (!mkdtemp(name.data())) {
      throw std::runtime_error("cannot make a folder for the test");
    }
    folder_ = name;
  }
  ~Files() { fs::remove_all(folder_); }
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;

  std::string weights(const neural::Weights& weights) {
    const std::string path = (folder_ / ("w" + std::to_string(++count_))).string();
    neural::write_weights(weights, path);
    return path;
  }
  std::string text(const std::string& content) {
    const std::string path = (folder_ / ("t" + std::to_string(++count_))).string();
    std::ofstream(path) << content;
    return path;
  }

 private:
  fs::path folder_;
  int count_ = 0;
};

double logistic(double x) { return 1.0 / (1.0 + std::exp(-x)); }

/// No hidden layer: the first priority is s(left), the second s(1 - 2 right).
neural::Network simple_network() {
  neural::Network network({2, 2});
  network.set_weight(0, 0, 0, 1.0);
  network.set_bias(0, 1, 1.0);
  network.set_weight(0, 1, 1, -2.0);
  return network;
}

/// What equipping complains about; "" when it does not.
std::string refusal(Coordinator& object, Team& team, Situation& now) {
  try {
    object.equipped(team.members(), now.perception());
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("Fusion takes each command times the network's output and divides by their number") {
  Files files;
  const Object fusion = coordinator(kFusion, {{"weights", files.weights({simple_network()})}});
  Team team;
  add_two_behaviors(team);
  start(*fusion, team);
  const MotorCommand command = decide(*fusion, team, 0.4, 0.7);
  const double first = logistic(0.4), second = logistic(1.0 - 2.0 * 0.7);
  CHECK(command.left == Approx((first * -10 + second * 20) / 2));
  CHECK(command.right == Approx((first * 10 + second * 20) / 2));
  CHECK(weight(team, 0) == Approx(first));
  CHECK(weight(team, 1) == Approx(second));
  // Shares are the parts in the sum, by the length of each one's contribution.
  CHECK(share(team, 0) == Approx(first * 10 / (first * 10 + second * 20)));
  CHECK(share(team, 0) + share(team, 1) == Approx(1.0));
  CHECK(reason(team, 1) == "priority from the network");
}

TEST_CASE("Arbitration runs the behaviour with the largest output, and no other") {
  Files files;
  const Object arbiter = coordinator(kArbiter, {{"weights", files.weights({simple_network()})}});
  Team team;
  add_two_behaviors(team);
  start(*arbiter, team);
  CHECK(decide(*arbiter, team, 0.4, 0.7) == MotorCommand{-10, 10});
  CHECK(team.asked(0) == 1);
  CHECK(team.asked(1) == 0);
  CHECK(weight(team, 0) == Approx(logistic(0.4)));
  CHECK(weight(team, 1) == Approx(logistic(-0.4)));  // visible, although it was not asked
  CHECK(share(team, 0) == 1.0);
  CHECK(share(team, 1) == 0.0);
  CHECK(team.members()[1].trace.inhibited_by == 0);
  CHECK(team.members()[0].trace.inhibited_by == -1);
  CHECK(reason(team, 0) == "largest priority");
  CHECK(reason(team, 1) == "smaller priority");

  CHECK(decide(*arbiter, team, 0.1, 0.2) == MotorCommand{20, 20});
  CHECK(team.asked(1) == 1);
  CHECK(team.members()[0].trace.inhibited_by == 1);
}

TEST_CASE("With equal outputs the first behaviour in the file wins") {
  Files files;
  const Object arbiter =
      coordinator(kArbiter, {{"weights", files.weights({neural::Network({2, 2})})}});
  Team team;
  add_two_behaviors(team);
  start(*arbiter, team);
  CHECK(decide(*arbiter, team, 0.4, 0.7) == MotorCommand{-10, 10});
  CHECK(weight(team, 0) == 0.5);
  CHECK(weight(team, 1) == 0.5);
}

TEST_CASE("Nested, the arbiter wishes what its winner wishes") {
  Files files;
  const Object arbiter = coordinator(kArbiter, {{"weights", files.weights({simple_network()})}});
  Team team;
  add_two_behaviors(team);
  start(*arbiter, team);
  const MotorCommand given = decide(*arbiter, team, 0.4, 0.7);
  const MotorCommand candidates[] = {{-10, 10}, {20, 20}};
  double wished[2], of_winner[2];
  arbiter->rate(team.members(), given, candidates, wished);
  team.members()[0].rate(candidates, of_winner);
  CHECK(wished[0] == of_winner[0]);
  CHECK(wished[1] == of_winner[1]);
  CHECK(arbiter->command_sets(team.members(), given).left == team.members()[0].command_sets().left);
}

TEST_CASE("Trained on the reference samples, the network avoids near obstacles and seeks else") {
  for (const char* hidden : {"2 2", "4 4"}) {
    const Object arbiter = coordinator(kArbiter, {{"hidden", std::string(hidden)}});
    Team team;
    add_two_behaviors(team);
    start(*arbiter, team);
    CAPTURE(hidden);
    CHECK(decide(*arbiter, team, 1, 1) == MotorCommand{20, 20});
    CHECK(weight(team, 1) == Approx(1).margin(0.05));
    CHECK(decide(*arbiter, team, 0.2, 1) == MotorCommand{-10, 10});
    CHECK(decide(*arbiter, team, 1, 0.6) == MotorCommand{-10, 10});
    CHECK(decide(*arbiter, team, 0.2, 0.2) == MotorCommand{-10, 10});
    CHECK(weight(team, 0) == Approx(0.3).margin(0.05));
  }
}

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
    // It begins where the training does, and ends where that ends.
    CHECK(points.front() ==
          Curve::Point{static_cast<double>(all.front().presentations), all.front().error});
    CHECK(points.back().x == static_cast<double>(all.back().presentations));
    // Nothing is left out: each point is the mean of what came since the one before.
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

TEST_CASE("Normalised readings are parts of the maximum range") {
  Files files;
  for (const bool normalise : {false, true}) {
    const Object fusion = coordinator(
        kFusion, {{"weights", files.weights({simple_network()})}, {"normalise", normalise}});
    Team team;
    add_two_behaviors(team);
    start(*fusion, team);
    Situation now;
    now.beam(15, 1.0, 4.0).beam(-15, 1.0, 2.0);
    fusion->coordinate(team.members(), now.perception());
    CHECK(weight(team, 0) == Approx(logistic(normalise ? 0.25 : 1.0)));
    CHECK(weight(team, 1) == Approx(logistic(1.0 - 2.0 * (normalise ? 0.5 : 1.0))));
  }
}

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
  team.member("wander", 1, MotorCommand{1, 1});
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
  // "2 2" is what a network gets that is trained, but here somebody has asked for it.
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
  CHECK_NOTHROW(decide(*fusion, team, 1, 1));  // the run goes on
  Random random(1);
  fusion->reset(random);
  CHECK_THAT(fusion->notes().at(0), Catch::StartsWith("Network 2-4-4-2 trained"));
  CHECK_THROWS(plugin::apply_parameters(
      declaration, *fusion,
      {{"training", test::source_path("training_sets/three_sensors_two_behaviors.txt")}}));
}

TEST_CASE("Without behaviours the command is zero, and there is nothing to train") {
  for (const char* name : {kFusion, kArbiter}) {
    const Object object = coordinator(name);
    Situation now = beams(1, 1);
    object->equipped({}, now.perception());
    Random random(1);
    object->reset(random);
    CHECK(object->coordinate({}, now.perception()) == MotorCommand{});
    CHECK(object->notes().empty());
  }
}

TEST_CASE("Behaviours that all wish to stand still share by their priorities") {
  Files files;
  const Object fusion = coordinator(kFusion, {{"weights", files.weights({simple_network()})}});
  Team team;
  team.member("a", 1, MotorCommand{}).member("b", 1, MotorCommand{});
  start(*fusion, team);
  CHECK(decide(*fusion, team, 0.4, 0.7) == MotorCommand{});
  CHECK(share(team, 0) == Approx(logistic(0.4)));  // the two outputs make 1 together here
  CHECK(share(team, 0) + share(team, 1) == Approx(1.0));
}

TEST_CASE("A reading that is no finite number is an error, not a guess") {
  const Object fusion = coordinator(kFusion);
  Team team;
  add_two_behaviors(team);
  start(*fusion, team);
  CHECK_THROWS_WITH(decide(*fusion, team, std::numeric_limits<double>::quiet_NaN(), 1),
                    Catch::Contains("not a finite number"));
}

TEST_CASE("Robots without range sensors are refused by the declaration") {
  for (const char* name : {kFusion, kArbiter}) {
    const Declaration* declaration = test::shipped().find(PluginKind::coordinator, name);
    REQUIRE(declaration);
    REQUIRE(declaration->needs.size() == 1);
    CHECK(declaration->needs[0].kind == "range");
  }
}
