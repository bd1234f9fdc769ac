#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "elsie/picture/axis.h"

using namespace elsie::picture;
using elsie::Vector2;

TEST_CASE("Steps of an axis are 1, 2 or 5 times a power of ten") {
  CHECK(nice_step(10, 10) == Approx(1));
  CHECK(nice_step(10, 5) == Approx(2));
  CHECK(nice_step(1, 2) == Approx(0.5));
  CHECK(nice_step(0.003, 6) == Approx(0.0005));
  CHECK(nice_step(95, 10) == Approx(10));
  CHECK(nice_step(1e6, 4) == Approx(200000));
  CHECK(nice_step(0, 5) == 1);
  CHECK(nice_step(std::nan(""), 5) == 1);
}

TEST_CASE("Ticks are the multiples of the step within the interval, borders included") {
  CHECK(nice_ticks(-5, 5, 10).at == std::vector<double>{-5, -4, -3, -2, -1, 0, 1, 2, 3, 4, 5});
  const Ticks tenths = nice_ticks(0, 0.3, 3);
  REQUIRE(tenths.at.size() == 4);
  CHECK(tenths.at[3] == Approx(0.3));
  CHECK(tenths.at[3] <= 0.3);
  CHECK(nice_ticks(0.1, 0.9, 1).at.size() <= 2);
}

TEST_CASE("Any span has a readable number of ticks") {
  for (double span = 1e-9; span < 1e12; span *= 1.37) {
    const Ticks ticks = nice_ticks(-0.31 * span, 0.69 * span, 6);
    CHECK(ticks.at.size() >= 3);
    CHECK(ticks.at.size() <= 10);
  }
}

TEST_CASE("An interval that is empty or not finite has no ticks") {
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(nice_ticks(1, 1, 5).at.empty());
  CHECK(nice_ticks(2, 1, 5).at.empty());
  CHECK(nice_ticks(0, infinity, 5).at.empty());
  CHECK(nice_ticks(std::nan(""), 1, 5).at.empty());
  CHECK(nice_ticks(-1e308, 1.7e308, 5).at.empty());
  CHECK(nice_ticks(1e17, 1e17 + 32, 1000000).at.size() < 1000);
}

TEST_CASE("A tick's label has the decimals of its step") {
  CHECK(tick_label(2, 1) == "2");
  CHECK(tick_label(2, 0.5) == "2.0");
  CHECK(tick_label(0.25, 0.05) == "0.25");
  CHECK(tick_label(-3, 1) == "\u22123");
  CHECK(tick_label(-1e-17, 0.2) == "0.0");
  CHECK(tick_label(20, 10) == "20");
  CHECK(tick_label(2e6, 1e6) == "2e+06");
}

TEST_CASE("The map of a plane and its inverse agree") {
  const PlaneMap map{90, -90, 500, 520};
  CHECK(map.pixel({0, 0}) == Vector2{500, 520});
  CHECK(map.pixel({1, 2}) == Vector2{590, 340});
  const Vector2 back = map.point(map.pixel({-3.25, 4.5}));
  CHECK(back.x == Approx(-3.25));
  CHECK(back.y == Approx(4.5));
}

TEST_CASE("An interval grows with what is finite, and a single value gets room") {
  Interval interval;
  CHECK(interval.empty());
  CHECK(interval.widened().low == -1.0);
  interval.include(std::nan(""));
  interval.include(20.0);
  CHECK(interval.widened().low == Approx(18.0));
  CHECK(interval.widened().high == Approx(22.0));
  interval.include(10.0);
  CHECK(interval.widened().low == 10.0);
  CHECK(interval.part(12.5) == Approx(0.25));
}

TEST_CASE("Ticks end where steps are below the resolution of the numbers, and such spans widen") {
  const double next = std::nextafter(2.5, 3.0);
  CHECK(nice_ticks(2.5, next, 4).at.empty());
  CHECK(Interval{2.5, next}.widened().span() == Approx(0.5));
  CHECK(Interval{2.5, 2.6}.widened().span() == Approx(0.1));
}
