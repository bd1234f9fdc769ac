#include <cmath>

#include "elsie/testing/catch.h"

using namespace elsie::testing;
using elsie::ProximityReading;
using elsie::radians;
using elsie::RangeReading;
using elsie::TeamMate;
using elsie::VisionReading;

TEST_CASE("A beam reads how far a wall is from where it is mounted") {
  Sensor beam("beam_range", {{"max_range", 2}});
  Surroundings room;
  room.wall(1.005, -2, 1.005, 2);  // its near face at x = 1
  CHECK(beam.sense<RangeReading>(room).distance_m == Approx(0.96));
  CHECK(beam.turned(60).sense<RangeReading>(room).distance_m ==
        Approx(0.96 / std::cos(radians(60))));
  CHECK_FALSE(beam.turned(180).sense<RangeReading>(room).hit);
  CHECK(beam.sense<RangeReading>(room.at(0, 0, 180)).distance_m == Approx(1.04));
  CHECK(beam.turned(0).sense<RangeReading>(room.at(0.5, 0, 0)).distance_m == Approx(0.46));
}

TEST_CASE("Boxes and robots are seen as in a simulation") {
  Sensor beam("beam_range");
  CHECK(beam.sense<RangeReading>(Surroundings().box(0.5, 0)).distance_m == Approx(0.36));
  CHECK(beam.sense<RangeReading>(Surroundings().robot("mate", 0.5, 0)).distance_m == Approx(0.42));
  elsie::world::Robot round;
  round.x = 0.5;
  round.y = 0.03;
  round.body.round = true;
  CHECK(beam.sense<RangeReading>(Surroundings().robot(round)).distance_m ==
        Approx(0.46 - std::sqrt(0.04 * 0.04 - 0.03 * 0.03)));
  Sensor proximity("proximity");
  CHECK(proximity.sense<ProximityReading>(Surroundings().box(0.3, 0)).detected);
  CHECK_FALSE(proximity.sense<ProximityReading>(Surroundings().box(-0.3, 0)).detected);
}

TEST_CASE("Other robots have distance and bearing") {
  Surroundings field;
  field.robot("far", 3, 0).robot("near", 0, 1, 90, true);
  std::vector<elsie::NearThing> robots;
  field.things_within(2, robots);
  REQUIRE(robots.size() == 1);
  CHECK(robots[0].thing.id == "near");
  CHECK(robots[0].bearing_rad == Approx(radians(90)));
  CHECK(robots[0].distance_m == Approx(1));
  robots.clear();
  field.things_within(0.5, robots);
  CHECK(robots.empty());
}

TEST_CASE("Noise comes from the seed") {
  const auto read = [](std::uint64_t seed) {
    Sensor beam("beam_range", {{"error", 0.1}});
    beam.reset(seed);
    return beam.sense<RangeReading>(Surroundings().box(0.5, 0)).distance_m;
  };
  CHECK(read(1) == read(1));
  CHECK(read(1) != read(2));
}

TEST_CASE("A sensor with a camera looks at a picture that was drawn by hand") {
  Sensor camera("vision");
  Surroundings colours;
  colours.resource(2, 0, kRed);
  const auto& seen = camera.sense<VisionReading>(Picture().disc(70, 40, 8), colours);
  REQUIRE(seen.found);
  CHECK(seen.column == Approx(70).margin(1));
  CHECK(seen.row == Approx(40).margin(1));
  CHECK_FALSE(camera.sense<VisionReading>(Picture(), colours).found);
}

TEST_CASE("A sensor with a camera sees its surroundings") {
  Sensor camera("vision");
  const Surroundings room = std::move(Surroundings().resource(1, 0.1, kBlue));
  const auto& seen = camera.sense<VisionReading>(room);
  REQUIRE(seen.found);
  CHECK(seen.column < 50);
}

TEST_CASE("Readings of another kind are refused") {
  Sensor beam("beam_range");
  CHECK_THROWS_WITH(
      beam.sense<ProximityReading>(Surroundings()),
      Catch::Contains("makes readings of the kind 'range'") && Catch::Contains("not 'proximity'"));
}

TEST_CASE("The numbers of a reading have names") {
  Sensor beam("beam_range");
  beam.update(Surroundings(), nullptr);
  const auto values = beam.values();
  REQUIRE(values.size() == 2);
  CHECK(values[0].name == std::string("distance_m"));
  CHECK(values[0].value == 1.0);
}
