// Resources, collisions, energy, time.
#include "support.h"

namespace testing = elsie::testing;
using elsie::RunEnd;
using namespace elsie::test;

TEST_CASE("Collected tells when the last resource was taken; none when none was") {
  Scene now = three_robots();
  Measure collected("collected", {{"team", "red"}});
  collected.observe(now);
  CHECK(collected.value("count") == 0.0);
  CHECK_FALSE(collected.value("last_s"));
  now["b1"].collected = 1;
  collected.observe(now.at_step(50));
  CHECK_FALSE(collected.value("last_s"));  // the other team's
  now["r1"].collected = 1;
  collected.observe(now.at_step(100));
  now["r2"].collected = 1;
  collected.observe(now.at_step(250));
  collected.observe(now.at_step(300));
  CHECK(collected.value("count") == 2.0);
  CHECK(collected.value("last_s") == Approx(2.5));
}

TEST_CASE("Collisions tells when the first was; none when none was") {
  Scene now = three_robots();
  Measure collisions("collisions");
  collisions.observe(now);
  CHECK(collisions.value("count") == 0.0);
  CHECK_FALSE(collisions.value("first_s"));
  now["r2"].collisions = 1;
  collisions.observe(now.at_step(120));
  now["r2"].collisions = 3;
  collisions.observe(now.at_step(200));
  CHECK(collisions.value("count") == 3.0);
  CHECK(collisions.value("first_s") == Approx(1.2));
}

TEST_CASE("Energy that was used is not what is missing from a battery that was charged") {
  Scene now;
  now.robot("r1");
  now["r1"].energy = 1000.0;
  Measure energy("energy");
  energy.equip(now);
  energy.reset();
  CHECK(energy.value("left") == 1000.0);
  energy.observe(now);
  now["r1"].energy_used = 300.0;
  now["r1"].energy = 1500.0;  // a resource gave it 800
  energy.observe(now.step());
  CHECK(energy.value("used") == 300.0);
  CHECK(energy.value("left") == 1500.0);
}

TEST_CASE("The time of a run is that of its end; of a success only, if that is asked for") {
  Scene now = three_robots();
  Measure time("run_time"), success("run_time", {{"only_success", true}});
  for (Measure* measure : {&time, &success}) {
    measure->observe(now);
    measure->observe(now.at_step(1234));
  }
  CHECK(time.value("") == Approx(12.34));
  CHECK(time.value("", RunEnd::Outcome::failure) == Approx(12.34));
  CHECK_FALSE(success.value("", RunEnd::Outcome::time_limit));
  CHECK_FALSE(success.value("", RunEnd::Outcome::running));
  CHECK(success.value("", RunEnd::Outcome::success) == Approx(12.34));
}
