// Sensors of light and colour.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "elsie/readings/ground.h"
#include "elsie/readings/light.h"
#include "elsie/readings/omnidirectional_camera.h"
#include "elsie/testing/behavior.h"
#include "elsie/testing/sensor.h"

using namespace elsie;

namespace {

testing::Sensor at_half_a_metre(const std::string& name, const testing::Settings& settings = {}) {
  testing::Sensor sensor(name, settings);
  sensor.mounted({{0.0, 0.0, 0.5}, 0.0, 0.0});
  return sensor;
}

double light_of(const testing::Surroundings& room, const testing::Settings& settings) {
  return at_half_a_metre("light", settings).sense<LightReading>(room).values[0];
}

}  // namespace

TEST_CASE("A light cell sees the sum of (I / d) squared of the lamps, at most 1") {
  testing::Surroundings room;
  room.lamp(2, 0, 0.5, 1.0).lamp(0, 4, 0.5, 1.0);
  CHECK(light_of(room, {}) == Approx(0.25 + 1.0 / 16));
  room.lamp(-0.5, 0, 0.5, 1.0);
  CHECK(light_of(room, {}) == 1.0);
}

TEST_CASE("A lamp that is behind something is not seen") {
  testing::Surroundings room;
  room.lamp(2, 0);
  room.box(1, 0, 0.2, 0.2, 1.0);
  CHECK(light_of(room, {}) == 0.0);
}

TEST_CASE("The foot-bot's cells follow its law, by distance and angle") {
  testing::Surroundings room;
  room.lamp(1, 0, 0.5, 2.0);
  testing::Sensor ring = at_half_a_metre("light", {{"law", "footbot"}, {"cells", 24}});
  const auto reading = ring.sense<LightReading>(room);
  REQUIRE(reading.values.size() == 24);
  for (std::size_t i = 0; i < 24; ++i) {
    const double theta = std::abs(reading.azimuth_rad(i));
    const double expected = theta > std::numbers::pi / 2
                                ? 0.0
                                : std::exp(-2.0 * 1.0 / 2.0) * (1 - 2 * theta / std::numbers::pi);
    CHECK(reading.values[i] == Approx(expected).margin(1e-12));
  }
  testing::Surroundings far;
  far.lamp(5.1, 0, 0.5, 2.0);  // d / I = 2.55
  CHECK(at_half_a_metre("light", {{"law", "footbot"}}).sense<LightReading>(far).values[0] == 0.0);
}

TEST_CASE("A light cell that has measured nothing reads dark, whatever its law") {
  for (const std::string law : {"generic", "footbot", "khepera"}) {
    CAPTURE(law);
    testing::Sensor light = at_half_a_metre("light", {{"law", law}});
    const auto dark = light.sense<LightReading>(testing::Surroundings()).values;
    light.reset();
    CHECK(static_cast<const LightReading*>(light->reading())->values == dark);
  }
}

TEST_CASE("A light cell sees lamps on other robots within its range") {
  testing::Surroundings room;
  room.light("r2", {1.0, 0.0, 0.5}, 0.5).light("r3", {0.0, 3.0, 0.5}, 0.6);
  CHECK(light_of(room, {}) == Approx(0.25));
  CHECK(light_of(room, {{"led_range", 4.0}}) == Approx(0.25 + 0.04));
  CHECK(light_of(room, {{"led_range", 0.0}}) == 0.0);
  room.box(0.5, 0, 0.2, 0.2, 1.0);
  CHECK(light_of(room, {}) == 0.0);
}

TEST_CASE("Cells all around that see the same tell no direction to the light") {
  testing::Surroundings room;
  room.lamp(1.5, 1.5, 0.5, 1.0);
  const auto wish = [&](const std::string& law) {
    testing::Sensor ring = at_half_a_metre("light", {{"law", law}, {"cells", 8}});
    testing::Behavior seek("seek_light");
    const LightReading reading = ring.sense<LightReading>(room);
    testing::Situation now;
    now.reading(reading, 0);
    return seek.respond(now);
  };
  CHECK(wish("generic").activation == 0.0);
  CHECK(wish("footbot").activation == 1.0);
  CHECK(wish("footbot").command.turn == Approx(3.0 * std::numbers::pi / 4));
}

TEST_CASE("Khepera's cells read 500 in the dark, and less near a lamp") {
  CHECK(light_of(testing::Surroundings(), {{"law", "khepera"}}) == 500.0);
  for (const auto& [distance, value] :
       {std::pair(0.075, 75.0), {0.1, 100.0}, {0.2, 250.0}, {0.4, 375.0}, {0.9, 450.0}}) {
    testing::Surroundings room;
    room.lamp(distance, 0);
    CHECK(light_of(room, {{"law", "khepera"}}) == Approx(value));
  }
  testing::Surroundings behind;
  behind.lamp(-0.2, 0);
  CHECK(light_of(behind, {{"law", "khepera"}}) == 500.0);
}

TEST_CASE("A ground sensor reads the colour of the floor below it") {
  testing::Sensor ground("ground");
  ground.mounted({{0.1, 0.0, 0.02}, 0.0, 0.0});
  testing::Surroundings hall;
  CHECK(ground.sense<GroundReading>(hall).grey == 1.0);
  hall.floor({100, 150, 200});
  const auto reading = ground.sense<GroundReading>(hall);
  CHECK(reading.red == Approx(100 / 255.0));
  CHECK(reading.grey == Approx((0.299 * 100 + 0.587 * 150 + 0.114 * 200) / 255));
  world::Patch line;
  line.x = 0.1;
  line.length = line.width = 0.05;
  line.colour = {0, 0, 0};
  hall.patch(line);
  CHECK(ground.sense<GroundReading>(hall).grey == 0.0);
  CHECK(ground.sense<GroundReading>(hall.at(0.0, 0.0, 90)).grey > 0.5);
  testing::Sensor switched("ground", {{"threshold", 0.5}});
  CHECK(switched.sense<GroundReading>(hall).grey == 1.0);
}

TEST_CASE("An omnidirectional camera lists the coloured things that it sees, the nearest first") {
  testing::Surroundings room;
  room.resource(1.5, 0, {200, 0, 0}).robot("mate", 0, 1).charger(-0.5, 0).lamp(0, -1.2, 0.1);
  room.resource(3, 0).wall(-1, -1, 1, -1);  // the wall hides the lamp, which is lower than its top
  testing::Sensor camera("omnidirectional_camera");
  camera.mounted({{0.0, 0.0, 0.08}, 0.0, 0.0});
  const auto reading = camera.sense<OmnidirectionalReading>(room);
  REQUIRE(reading.blobs.size() >= 3);
  CHECK(reading.blobs[0].distance_m == Approx(0.5));
  CHECK(std::abs(reading.blobs[0].bearing_rad) == Approx(std::numbers::pi));
  CHECK(reading.blobs[1].bearing_rad == Approx(std::numbers::pi / 2));
  CHECK(reading.blobs[2].distance_m == Approx(1.5));
  CHECK(reading.blobs[2].red == 200);
  testing::Sensor near("omnidirectional_camera", {{"most", 1}});
  near.mounted({{0.0, 0.0, 0.08}, 0.0, 0.0});
  CHECK(near.sense<OmnidirectionalReading>(room).blobs.size() == 1);
}

TEST_CASE("An omnidirectional camera does not see what is behind a wall") {
  testing::Surroundings room;
  room.resource(1.5, 0).wall(0.8, -1, 0.8, 1);
  testing::Sensor camera("omnidirectional_camera");
  CHECK(camera.sense<OmnidirectionalReading>(room).blobs.empty());
}
