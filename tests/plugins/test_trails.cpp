// Who lays trails, who senses them, and who follows them.
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/commands/pen.h"
#include "elsie/readings/antennae.h"
#include "elsie/testing/actuator.h"
#include "elsie/testing/behavior.h"
#include "elsie/testing/checker.h"
#include "elsie/testing/sensor.h"

using namespace elsie;

namespace {

/// What antennae with two tips sense, 6 cm apart.
testing::Situation senses(double left, double right) {
  AntennaeReading reading;
  reading.values = {left, right};
  reading.first_m = 0.03;
  reading.step_m = 0.06;
  testing::Situation now;
  now.reading(reading);
  return now;
}

/// None: it commands nothing.
std::optional<double> flow_of(const Response& response) {
  if (response.acts.empty()) return std::nullopt;
  REQUIRE(response.acts.size() == 1);
  return static_cast<const PenCommand*>(response.acts[0].command())->flow;
}

}  // namespace

TEST_CASE("A pen deposits its rate times its flow into its field, while it is down") {
  testing::Actuator pen("pen", {{"field", "ink"}, {"rate", 5.0}});
  CHECK(pen.hold().deposited.empty());
  CHECK(pen.act(PenCommand{0.5}).deposited.at("ink") == Approx(5.0 * 0.5 * 0.01));
  CHECK(pen.hold().deposited.at("ink") == Approx(5.0 * 0.5 * 0.01));
  CHECK(pen.act(PenCommand{7.0}).deposited.at("ink") == Approx(5.0 * 0.01));
  CHECK(pen.act(PenCommand{-1.0}).deposited.empty());
  testing::Actuator rubber("pen", {{"rate", -2.0}});
  CHECK(rubber.act(PenCommand{1.0}).deposited.at("pheromone") == Approx(-2.0 * 0.01));
}

TEST_CASE("Antennae read their field at their tips, from left to right") {
  testing::Surroundings floor;
  floor.field("heat", [](const Vector2& at) { return 10.0 + at.x + 100.0 * at.y; });
  testing::Sensor antennae("antennae", {{"field", "heat"}, {"tips", 3}, {"width", 0.2}});
  antennae.mounted({{0.5, 0.0, 0.1}, 0.0, 0.0});
  const auto reading = antennae.sense<AntennaeReading>(floor);
  REQUIRE(reading.values.size() == 3);
  CHECK(reading.values[0] == Approx(20.5));
  CHECK(reading.values[1] == Approx(10.5));
  CHECK(reading.values[2] == Approx(0.5));
  CHECK(reading.offset_m(0) == Approx(0.1));
  CHECK(reading.offset_m(2) == Approx(-0.1));
  // Turned to the left, its left is west.
  const auto turned = antennae.sense<AntennaeReading>(floor.at(0.0, 0.0, 90.0));
  CHECK(turned.values[0] == Approx(10.0 - 0.1 + 50.0));
  CHECK(turned.values[2] == Approx(10.0 + 0.1 + 50.0));
}

TEST_CASE("A single tip is at the place of the antennae, and other fields are not sensed") {
  testing::Surroundings floor;
  floor.field("pheromone", [](const Vector2& at) { return at.x; });
  testing::Sensor one("antennae", {{"tips", 1}});
  one.mounted({{0.5, 0.2, 0.1}, 0.0, 0.0});
  CHECK(one.sense<AntennaeReading>(floor).values == std::vector<double>{0.5});
  testing::Sensor other("antennae", {{"field", "smoke"}});
  CHECK(other.sense<AntennaeReading>(floor).values == std::vector<double>{0.0, 0.0});
}

TEST_CASE("A trail is laid always, or from one event until another") {
  testing::Behavior always("lay_trail", {{"flow", 0.3}});
  CHECK(flow_of(always.respond(testing::Situation())) == 0.3);
  testing::Behavior between("lay_trail", {{"from", "collected"}, {"until", "arrived"}});
  const auto after = [&](const std::string& event) {
    testing::Situation now;
    if (!event.empty()) now.event(event);
    return flow_of(between.respond(now));
  };
  CHECK_FALSE(after(""));
  CHECK_FALSE(after("collision"));
  CHECK(after("collected") == 1.0);
  CHECK(after("") == 1.0);
  CHECK(after("arrived") == 0.0);
  CHECK_FALSE(after(""));  // it has lifted the pen, and leaves it to others
  CHECK(after("collected") == 1.0);
  testing::Behavior once("lay_trail", {{"until", "arrived"}});
  CHECK(flow_of(once.respond(testing::Situation())) == 1.0);
  CHECK(flow_of(once.respond(testing::Situation().event("arrived"))) == 0.0);
  between.reset();
  CHECK_FALSE(after(""));
}

TEST_CASE("A trail is laid with the pen that it names") {
  const auto pen = [](const testing::Settings& parameters) {
    testing::Behavior lays("lay_trail", parameters);
    const Response response = lays.respond(testing::Situation());
    REQUIRE(response.acts.size() == 1);
    return std::string(response.acts[0].actuator());
  };
  CHECK(pen({}).empty());  // the first
  CHECK(pen({{"pen", "ink"}}) == "ink");
}

TEST_CASE("It turns to the side on which a field is stronger, by the contrast of the two sides") {
  testing::Behavior follow("follow_gradient", {{"speed", 0.2}, {"gain", 4.0}});
  const auto wish = [&](double left, double right) {
    return follow.respond(senses(left, right)).command;
  };
  CHECK(wish(3, 1).turn == Approx(4.0 * 0.5));
  CHECK(wish(3, 1).forward == Approx(0.2 * 0.5));
  CHECK(wish(300, 100) == wish(3, 1));  // Weber's law
  CHECK(wish(1, 3).turn == Approx(-2.0));
  CHECK(wish(2, 2) == Motion{0.2, 0.0, 0.0});
  CHECK(wish(2, 0) == Motion{0.0, 0.0, 4.0});
  testing::Behavior down("follow_gradient", {{"gain", 4.0}, {"down", true}});
  CHECK(down.respond(senses(3, 1)).command.turn == Approx(-2.0));
}

TEST_CASE("It wants nothing where there is too little, and stops where there is enough") {
  testing::Behavior follow("follow_gradient", {{"least", 0.5}, {"enough", 9.0}});
  const Response nothing = follow.respond(senses(0.4, 0.1));
  CHECK(nothing.activation == 0.0);
  CHECK(nothing.strength == 0.0);
  const Response there = follow.respond(senses(2, 9.5));
  CHECK(there.activation == 1.0);
  CHECK(there.command == Motion{});
  CHECK(follow.respond(senses(2, 8.5)).command.turn < 0.0);
}

TEST_CASE("Several antennae count by how far their tips are to the side") {
  const auto turn = [](double yaw_deg, double y) {
    AntennaeReading reading;
    reading.values = {3.0, 1.0};
    reading.first_m = 0.03;
    reading.step_m = 0.06;
    testing::Situation now;
    now.reading(reading, Mounting{{0.1, y, 0.0}, radians(yaw_deg), 0.0});
    return testing::Behavior("follow_gradient", {{"gain", 1.0}}).respond(now).command.turn;
  };
  CHECK(turn(0, 0) == Approx(0.5));
  CHECK(turn(180, 0) == Approx(-0.5));  // looks back: its left is the robot's right
  CHECK(turn(0, 0.01) == Approx((3 * 0.04 - 0.02) / (3 * 0.04 + 0.02)));
}

TEST_CASE("It follows the antennae that it names, by default all") {
  const auto turn = [](const std::string& antennae) {
    testing::Situation now;
    for (const auto& [id, values] : {std::pair("food", std::vector<double>{3.0, 1.0}),
                                     std::pair("home", std::vector<double>{1.0, 7.0})}) {
      AntennaeReading reading;
      reading.values = values;
      reading.first_m = 0.03;
      reading.step_m = 0.06;
      now.reading(reading, Mounting{}, id);
    }
    testing::Behavior follow("follow_gradient", {{"gain", 1.0}, {"antennae", antennae}});
    return follow.respond(now).command.turn;
  };
  CHECK(turn("food") == Approx(0.5));
  CHECK(turn("home") == Approx(-0.75));
  CHECK(turn("") == Approx((4.0 - 8.0) / 12.0));
  CHECK_THROWS_WITH(turn("nest"), Catch::Contains("no antennae with the id 'nest'"));
}

TEST_CASE("Antennae that cannot tell left from right are refused") {
  AntennaeReading one;
  one.values = {1.0};
  testing::Situation now;
  now.reading(one);
  testing::Behavior follow("follow_gradient");
  CHECK_THROWS_WITH(follow.respond(now),
                    Catch::Contains("on the middle line of the robot, where it cannot tell left "
                                    "from right; give the antennae more than 1 tip, or a y"));
}
