#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/api/behavior.h"
#include "elsie/plugin/error.h"
#include "elsie/plugin/parameters.h"

using namespace elsie;
using namespace elsie::plugin;
using Catch::Contains;

namespace {

class Walker final : public Behavior {
 public:
  double speed = 1.0;
  double gain = 1.0;
  float factor = 0.5F;
  int level = 3;
  unsigned count = 2;
  std::uint8_t byte = 1;
  bool shy = false;
  std::string mode = "low";
  FilePath model{"a.fcl"};
  std::vector<double> weights{1, 2};
  int times_configured = 0;

  void configured() override {
    ++times_configured;
    if (speed > gain * 2) {
      throw std::invalid_argument("speed must not be above twice the gain");
    }
  }
  Response respond(const Perception&) override { return Motion{}; }
};

Declaration walker() {
  return declare<Walker>(
      PluginKind::behavior, "walker", "Walks",
      parameter("speed", &Walker::speed, {.unit = "rad/s", .min = 0, .max = 50}),
      parameter("gain", &Walker::gain, {.above = 0}), parameter("factor", &Walker::factor),
      parameter("level", &Walker::level, {.max = 9}), parameter("count", &Walker::count),
      parameter("byte", &Walker::byte), parameter("shy", &Walker::shy),
      parameter("mode", &Walker::mode, {.choices = {"low", "high"}}),
      parameter("model", &Walker::model), parameter("weights", &Walker::weights, {.min = -1}));
}

const ParameterDeclaration& named(const Declaration& declaration, const std::string& name) {
  for (const ParameterDeclaration& parameter : declaration.parameters) {
    if (parameter.name == name) {
      return parameter;
    }
  }
  throw std::out_of_range(name);
}

std::string value_refusal(const std::string& name, const ParameterValue& value) {
  return check_value(named(walker(), name), value).value_or("");
}

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("A value at the edge of its range is allowed, one beyond is not") {
  CHECK(value_refusal("speed", 0.0).empty());
  CHECK(value_refusal("speed", 50.0).empty());
  CHECK(value_refusal("speed", 60.0) ==
        "speed is 60, but must be a number at least 0 and at most 50 rad/s");
  CHECK(value_refusal("speed", -1e-300) ==
        "speed is -1e-300, but must be a number at least 0 and at most 50 rad/s");
  CHECK(value_refusal("gain", 1e-300).empty());
  CHECK(value_refusal("gain", 0.0) == "gain is 0, but must be a number above 0");
  CHECK(value_refusal("level", std::int64_t{9}).empty());
  CHECK(value_refusal("level", std::int64_t{10}) ==
        "level is 10, but must be a whole number at most 9");
}

TEST_CASE("Numbers must be finite, also where there is no range") {
  CHECK(value_refusal("speed", kNotANumber) ==
        "speed is nan, but must be a number at least 0 and at most 50 rad/s");
  CHECK(value_refusal("gain", kInfinity) == "gain is inf, but must be a number above 0");
  CHECK(value_refusal("weights", std::vector{1.0, kNotANumber}) ==
        "weights is '1 nan', but must be a list of numbers, each at least -1, separated by blanks; "
        "'nan' is none of those");
}

TEST_CASE("Each number of a list must be in range") {
  CHECK(value_refusal("weights", std::vector{0.0, -1.0, 5.0}).empty());
  CHECK(value_refusal("weights", std::vector<double>{}).empty());
  CHECK(value_refusal("weights", std::vector{0.0, -2.0}) ==
        "weights is '0 -2', but must be a list of numbers, each at least -1, separated by blanks; "
        "'-2' is none of those");
}

TEST_CASE("A text must be one of the choices, with a hint at the nearest") {
  CHECK(value_refusal("mode", std::string("high")).empty());
  CHECK(value_refusal("mode", std::string("hihg")) ==
        "mode is 'hihg', but must be one of 'low', 'high'; did you mean 'high'?");
  CHECK(value_refusal("model", std::string("anything at all")).empty());
}

TEST_CASE("A value of another type is refused") {
  CHECK(value_refusal("speed", std::int64_t{3}) ==
        "speed is 3, but must be a number at least 0 and at most 50 rad/s");
  CHECK(value_refusal("level", 3.0) == "level is 3, but must be a whole number at most 9");
  CHECK(value_refusal("shy", std::string("yes")) == "shy is 'yes', but must be true or false");
  CHECK(value_refusal("model", true) == "model is true, but must be the path of a file");
}

TEST_CASE("A number that the plugin's member cannot hold is refused") {
  CHECK(value_refusal("level", std::int64_t{std::numeric_limits<int>::min()}).empty());
  CHECK_THAT(value_refusal("level", std::int64_t{std::numeric_limits<int>::min()} - 1),
             Contains("beyond what can be stored"));
  CHECK(value_refusal("count", std::int64_t{4294967295}).empty());
  CHECK_THAT(value_refusal("count", std::int64_t{4294967296}),
             Contains("beyond what can be stored"));
  CHECK_THAT(value_refusal("count", std::int64_t{-1}), Contains("a whole number at least 0"));
  CHECK_THAT(value_refusal("byte", std::int64_t{256}), Contains("(0 to 255)"));
  CHECK_THAT(value_refusal("factor", 1e39), Contains("beyond what can be stored"));
  CHECK(value_refusal("factor", 1e38).empty());
}

TEST_CASE("What is given is set, the rest keeps its default, and the object is configured once") {
  Walker object;
  apply_parameters(walker(), object,
                   {{"speed", 1.5},
                    {"level", std::int64_t{-4}},
                    {"shy", true},
                    {"mode", std::string("high")},
                    {"model", std::string("b.fcl")},
                    {"weights", std::vector{4.0}}});
  CHECK(object.speed == 1.5);
  CHECK(object.gain == 1.0);
  CHECK(object.level == -4);
  CHECK(object.shy);
  CHECK(object.mode == "high");
  CHECK(object.model.path == "b.fcl");
  CHECK(object.weights == std::vector{4.0});
  CHECK(object.times_configured == 1);

  Walker untouched;
  apply_parameters(walker(), untouched, {});
  CHECK(untouched.times_configured == 1);
}

TEST_CASE("All wrong parameters are reported at once, and nothing is set then") {
  Walker object;
  CHECK_THROWS_MATCHES(
      apply_parameters(walker(), object, {{"gain", 3.0}, {"speed", 51.0}, {"moed", true}}),
      PluginError,
      Catch::Matchers::Message(
          "behavior 'walker': it has no parameter 'moed'; did you mean 'mode'?; speed is 51, "
          "but must be a number at least 0 and at most 50 rad/s"));
  CHECK(object.gain == 1.0);
  CHECK(object.times_configured == 0);
}

TEST_CASE("What configured() throws is passed on with the plugin's name") {
  Walker object;
  CHECK_THROWS_MATCHES(
      apply_parameters(walker(), object, {{"speed", 3.0}}), PluginError,
      Catch::Matchers::Message("behavior 'walker': speed must not be above twice the gain"));
}

TEST_CASE("What a parameter takes is described in words") {
  const Declaration declaration = walker();
  CHECK(allowed_values(named(declaration, "speed")) == "a number at least 0 and at most 50 rad/s");
  CHECK(allowed_values(named(declaration, "factor")) == "a number");
  CHECK(allowed_values(named(declaration, "count")) == "a whole number at least 0");
  CHECK(allowed_values(named(declaration, "shy")) == "true or false");
  CHECK(allowed_values(named(declaration, "mode")) == "one of 'low', 'high'");
  CHECK(allowed_values(named(declaration, "model")) == "the path of a file");
}
