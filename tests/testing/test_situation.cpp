#include <cmath>

#include "elsie/testing/catch.h"

using namespace elsie;
using elsie::testing::Sequence;
using elsie::testing::Situation;

namespace {

/// A kind of reading that the library does not know.
struct Light {
  static constexpr const char* kind = "light";
  double lux = 0.0;
};

struct Word {
  static constexpr const char* kind = "word";
  int number = 0;
};

}  // namespace

TEST_CASE("A situation is perceived as it was put together") {
  Situation now;
  now.beam(15, 0.2).proximity(-90, true).beam(-15, 1.0).reading(Light{80}, 45);
  const Perception seen = now.perception();
  const auto beams = seen.readings<RangeReading>();
  REQUIRE(beams.size() == 2);
  CHECK(beams[0]->distance_m == 0.2);
  CHECK(beams[0]->hit);
  CHECK(beams[0].azimuth_rad() == Approx(radians(15)));
  CHECK(beams[0].sensor() == "range1");
  CHECK_FALSE(beams[1]->hit);
  CHECK(seen.readings<ProximityReading>()[0]->detected);
  CHECK(seen.readings<Light>()[0]->lux == 80);
  CHECK(seen.readings<VisionReading>().empty());
}

TEST_CASE("A blob comes with a picture that shows it") {
  Situation now;
  now.blob(70, 30, 400, 0, testing::kBlue);
  const auto seen = now.perception().readings<VisionReading>()[0];
  CHECK(seen->found);
  CHECK(seen->column == 70);
  CHECK(*seen->raw.pixel(70, 50) == testing::kBlue.red);
  CHECK(*seen->processed.pixel(70, 50) == 255);
  CHECK(*seen->processed.pixel(20, 50) == 0);
  double columns = 0, count = 0;
  for (int column = 0; column < 100; ++column) {
    for (int row = 0; row < 100; ++row) {
      if (*seen->processed.pixel(column, row) != 0) {
        columns += column + 0.5;
        ++count;
      }
    }
  }
  CHECK(columns / count == Approx(70).margin(0.5));
  CHECK(count == Approx(400).epsilon(0.05));
}

TEST_CASE("Mates are seen from the robot's final position") {
  Situation now;
  now.leader(1, 2, 90).at(1, 0, 0).charger(3, 4).battery(0.1).charging().event("collision");
  const Perception seen = now.perception();
  REQUIRE(seen.team().leader());
  CHECK(seen.team().leader()->distance_m == Approx(2));
  CHECK(seen.team().leader()->bearing_rad == Approx(radians(90)));
  CHECK(seen.team().charger->x == 3);
  CHECK(seen.self().energy == Approx(500));
  CHECK(seen.self().charging);
  REQUIRE(seen.events().size() == 1);
  CHECK(seen.events()[0].name == "collision");
}

TEST_CASE("A situation has messages with all that a device tells") {
  Situation now;
  now.hear(Word{1}, "r2", 2.0, 90.0)
      .hear(Word{2}, {.device = "radio",
                      .from = "r3",
                      .age_s = 0.2,
                      .distance_m = 1.0,
                      .bearing_rad = 0.1,
                      .elevation_rad = -0.3});
  const Situation copy = now;
  const Perception seen = copy.perception();
  CHECK(copy.listened().empty());
  auto heard = seen.heard<Word>().begin();
  CHECK((*heard)->number == 1);
  CHECK((*heard).from() == "r2");
  CHECK((*heard).bearing_rad() == Approx(radians(90)));
  CHECK((*heard).elevation_rad() == 0.0);
  ++heard;
  CHECK((*heard)->number == 2);
  CHECK((*heard).device() == "radio");
  CHECK((*heard).from() == "r3");
  CHECK((*heard).age_s() == 0.2);
  CHECK((*heard).elevation_rad() == -0.3);
  REQUIRE(copy.listened().size() == 1);
  CHECK(std::string(copy.listened()[0].name) == "word");
}

TEST_CASE("A moving robot perceives its motion") {
  Situation now;
  now.moving(0.2, 1.0);
  CHECK(now.perception().self().moving == elsie::Motion{0.2, 0.0, 1.0});
}

TEST_CASE("A copy of a situation is independent") {
  Situation one;
  one.beam(0, 0.5).mate("a", 1, 0);
  one.perception();
  Situation other = one;
  other.clear_readings().beam(0, 0.1).mate("b", 2, 0);
  const Perception of_one = one.perception();
  const Perception of_other = other.perception();
  CHECK(of_one.readings<RangeReading>()[0]->distance_m == 0.5);
  CHECK(of_other.readings<RangeReading>()[0]->distance_m == 0.1);
  CHECK(of_one.team().mates.size() == 1);
  CHECK(of_other.team().mates.size() == 2);
}

TEST_CASE("A sequence has an instant for each control period") {
  Sequence way(0.1);
  way.hold(0.3, Situation().beam(0, 1.0)).change(0.2, [](double t) {
    return Situation().beam(0, 0.5 - t);
  });
  const auto& instants = way.instants();
  REQUIRE(instants.size() == 5);
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(instants[i].time_s() == Approx(0.1 * static_cast<double>(i)));
    CHECK(instants[i].perception().period_s() == 0.1);
  }
  CHECK(instants[3].perception().readings<RangeReading>()[0]->distance_m == 0.5);
  CHECK(instants[4].perception().readings<RangeReading>()[0]->distance_m == Approx(0.4));
}

TEST_CASE("A picture that has no pixels cannot be drawn") {
  CHECK_THROWS_WITH(testing::Picture(0, 5), "a picture of 0 x 5 pixels cannot be drawn");
}
