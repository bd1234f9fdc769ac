// The shipped models: the wheel speeds for a beam in any direction.
#include <filesystem>
#include <string>

#include <catch2/catch.hpp>

#include "elsie/fuzzy/fcl.h"

#include "places.h"

using elsie::fuzzy::Model;
using elsie::fuzzy::Workspace;

namespace {

const std::string kFolder = elsie::test::source_path("fuzzy_models/");

struct Rates {
  double left = 0.0;
  double right = 0.0;
};

/// The two models of a behaviour.
class Pair {
 public:
  explicit Pair(const std::string& behavior)
      : left_(elsie::fuzzy::read_fcl(kFolder + behavior + "_left.fcl")),
        right_(elsie::fuzzy::read_fcl(kFolder + behavior + "_right.fcl")) {}

  /// Of a file with both: the blocks are called left_PAIR and right_PAIR.
  Pair(const std::string& file, const std::string& pair)
      : left_(elsie::fuzzy::read_fcl(kFolder + file, "left_" + pair)),
        right_(elsie::fuzzy::read_fcl(kFolder + file, "right_" + pair)) {}

  Rates operator()(double range_m, double azimuth_deg) {
    const double inputs[] = {range_m, azimuth_deg};
    Rates rates;
    left_.evaluate(inputs, {&rates.left, 1}, workspace_);
    right_.evaluate(inputs, {&rates.right, 1}, workspace_);
    return rates;
  }

 private:
  Model left_;
  Model right_;
  Workspace workspace_;
};

}  // namespace

TEST_CASE("Every model of a wheel takes range and azimuth and answers with a speed, everywhere") {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    const std::string name = entry.path().stem().string();
    if (!name.ends_with("_left") && !name.ends_with("_right")) {
      continue;
    }
    INFO(entry.path());
    const Model model = elsie::fuzzy::read_fcl(entry.path().string());
    CHECK(model.name() == entry.path().stem().string());
    REQUIRE(model.inputs().size() == 2);
    CHECK(model.inputs()[0].name == "range");
    CHECK(model.inputs()[1].name == "azimuth");
    REQUIRE(model.outputs().size() == 1);
    CHECK(model.outputs()[0].name == "speed");
    CHECK_FALSE(model.outputs()[0].default_value);  // some rule decides for every beam
    ++count;
  }
  CHECK(count == 8);
}

TEST_CASE("The eight pairs of avoidance models do what their names say") {
  for (const int inner : {0, 30}) {
    for (const int open : {20, 30}) {
      for (const double near_m : {0.6, 1.0}) {
        const std::string name = "inner_" + std::to_string(inner) + "_open_" +
                                 std::to_string(open) + (near_m < 1.0 ? "_near_06" : "_near_10");
        CAPTURE(name);
        Pair avoid("avoidance_family.fcl", name);
        CHECK(avoid(near_m, 35).right == Approx(open));
        CHECK(avoid(0, 35).left == Approx(0.5 * open));  // the outer wheel: the obstacle is left
        CHECK(avoid(0, 35).right == Approx(-inner).margin(1e-9));
        CHECK(avoid(0.5 * near_m, 35).left == Approx(0.75 * open));
        CHECK(avoid(0.5 * near_m, 35).right == Approx(0.5 * (0.5 * open - inner)));
        for (double range = 0.0; range <= 1.0; range += 0.05) {
          for (const double azimuth : {-35.0, -15.0, 15.0, 35.0}) {
            CHECK(avoid(range, azimuth).left == Approx(avoid(range, -azimuth).right));
          }
        }
      }
    }
  }
}

TEST_CASE("avoid_obstacle drives on at 20 rad/s where nothing is in reach") {
  Pair avoid("avoid_obstacle");
  for (double azimuth = -180; azimuth <= 180; azimuth += 5) {
    CHECK(avoid(1.0, azimuth).left == Approx(20));
    CHECK(avoid(1.0, azimuth).right == Approx(20));
  }
}

TEST_CASE("avoid_obstacle turns away from the nearer side, and slows down with nearness") {
  Pair avoid("avoid_obstacle");
  for (const double azimuth : {15.0, 35.0, 45.0}) {
    double last_mean = 20.0;
    double last_turn = 0.0;
    for (const double range : {0.7, 0.6, 0.5, 0.4, 0.3, 0.25, 0.2, 0.15, 0.1}) {
      const Rates rates = avoid(range, azimuth);
      CHECK(rates.left > rates.right);
      CHECK(rates.left - rates.right >= last_turn - 1e-9);
      CHECK(0.5 * (rates.left + rates.right) <= last_mean + 1e-9);
      last_mean = 0.5 * (rates.left + rates.right);
      last_turn = rates.left - rates.right;
    }
  }
  CHECK(avoid(0.2, 90).left > avoid(0.2, 90).right);
  CHECK(avoid(0.2, -90).left < avoid(0.2, -90).right);
}

TEST_CASE("avoid_obstacle is the same on both sides, but for what is very near in front") {
  Pair avoid("avoid_obstacle");
  for (const double azimuth : {15.0, 35.0, 45.0, 60.0, 90.0, 135.0, 180.0}) {
    for (const double range : {0.3, 0.35, 0.4, 0.5, 0.65, 0.8, 1.0}) {
      CHECK(avoid(range, azimuth).left == Approx(avoid(range, -azimuth).right));
      CHECK(avoid(range, azimuth).right == Approx(avoid(range, -azimuth).left));
    }
  }
  CHECK(avoid(0.1, 90).left == Approx(avoid(0.1, -90).right));
}

TEST_CASE("Very near in front the robot backs off and spins away, harder from the left side") {
  Pair avoid("avoid_obstacle");
  for (const double azimuth : {5.0, 15.0, 30.0, 50.0}) {
    const Rates from_left = avoid(0.1, azimuth);
    const Rates from_right = avoid(0.1, -azimuth);
    CHECK(from_left.left < 0);
    CHECK(from_left.right < -25);
    CHECK(from_left.left - from_left.right > 40);
    CHECK(from_right.right < 0);
    if (azimuth > 10) {  // near the middle, obstacles ahead are avoided to the right
      CHECK(from_right.right - from_right.left > 5);
    }
  }
}

TEST_CASE("What is behind matters little") {
  Pair avoid("avoid_obstacle");
  for (const double azimuth : {-180.0, -150.0, -110.0, 110.0, 150.0}) {
    CHECK(avoid(0.05, azimuth).left == Approx(20));
    CHECK(avoid(0.05, azimuth).right == Approx(20));
  }
}

TEST_CASE("turn_left and turn_right mirror each other") {
  Pair left("turn_left");
  Pair right("turn_right");
  for (double azimuth = -180; azimuth <= 180; azimuth += 7.5) {
    for (double range = 0; range <= 1; range += 0.05) {
      CHECK(left(range, azimuth).left == Approx(right(range, -azimuth).right));
      CHECK(left(range, azimuth).right == Approx(right(range, -azimuth).left));
    }
  }
}

TEST_CASE("turn_left turns left from what is on the right, and from nothing else") {
  Pair turn("turn_left");
  for (const double azimuth : {0.0, 15.0, 35.0, 90.0, 150.0, -150.0}) {
    CHECK(turn(0.05, azimuth).left == Approx(20));
    CHECK(turn(0.05, azimuth).right == Approx(20));
  }
  for (const double azimuth : {-15.0, -35.0, -60.0, -90.0}) {
    double last_turn = 0.0;
    for (const double range : {0.45, 0.4, 0.3, 0.2, 0.1}) {
      const Rates rates = turn(range, azimuth);
      CHECK(rates.right > rates.left);
      CHECK(rates.right - rates.left >= last_turn - 1.0);
      last_turn = rates.right - rates.left;
    }
  }
  CHECK(turn(0.1, -30).left < 0);
  CHECK(turn(1.0, -30).left == Approx(20));
}

TEST_CASE("slow_down only ever drives on: the slower the nearer, away from the nearer side") {
  Pair slow_down("slow_down");
  for (double azimuth = 0.0; azimuth <= 180.0; azimuth += 15.0) {
    double last = 0.0;
    for (double range = 0.05; range <= 1.0; range += 0.05) {
      const Rates left = slow_down(range, azimuth);
      const Rates right = slow_down(range, -azimuth);
      INFO(range << " m at " << azimuth << " deg");
      CHECK(left.left + left.right > last);
      CHECK(left.left >= 0.0);
      CHECK(left.right >= 0.0);
      CHECK(left.left == Approx(right.right).margin(1e-9));
      CHECK(left.right == Approx(right.left).margin(1e-9));
      CHECK(left.left >= left.right - 1e-9);
      CHECK((azimuth == 0.0 || range > 0.85 || left.left > left.right));
      last = left.left + left.right;
    }
  }
  CHECK(slow_down(1.0, 15.0).left == Approx(20.0));
}
