#include <optional>
#include <string>
#include <utility>

#include <catch2/catch.hpp>

#include "shipped.h"
#include "situation.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::test;

namespace {

plugin::Object<Behavior> finder(test::Parameters parameters = {}) {
  return test::make<Behavior>(PluginKind::behavior, "find_resource", std::move(parameters));
}

/// The answer to a blob at this column of a picture of 100 x 100 pixels.
Motion answer(double column, double fov_deg = 30.0, test::Parameters parameters = {}) {
  return finder(std::move(parameters))
      ->respond(Situation().blob(column, fov_deg).perception())
      .command;
}

VisionReading sees(double column, int width = 100, double fov_deg = 30.0, double area_px = 100.0) {
  VisionReading view;
  view.found = true;
  view.column = column;
  view.area_px = area_px;
  view.width = width;
  view.height = 100;
  view.horizontal_fov_rad = radians(fov_deg);
  return view;
}

void check(const Motion& command, double left, double right) {
  CHECK(rates(command).left == Approx(left).margin(1e-12));
  CHECK(rates(command).right == Approx(right).margin(1e-12));
}

}  // namespace

TEST_CASE("A resource near the middle of the picture is driven to, one at the side turned to") {
  check(answer(50), 20, 20);
  check(answer(45), 20, 20);  // c = -5
  check(answer(55), 20, 20);  // c = 5
  check(answer(44.999), -5.001 / 30, 5.001 / 30);
  check(answer(55.001), 5.001 / 30, -5.001 / 30);
  check(answer(0), -50.0 / 30, 50.0 / 30);
  check(answer(100), 50.0 / 30, -50.0 / 30);
}

TEST_CASE("The turn is the slower the wider the camera sees") {
  check(answer(20, 30), -1, 1);
  check(answer(20, 60), -0.5, 0.5);
}

TEST_CASE("A picture of another width is scaled: the same part of it counts the same") {
  const auto command = [](double column, int width) {
    return finder()->respond(Situation().view(sees(column, width)).perception()).command;
  };
  check(command(320, 640), 20, 20);
  check(command(288, 640), 20, 20);
  check(command(287, 640), -(33.0 / 6.4) / 30, (33.0 / 6.4) / 30);
  check(command(640, 640), 50.0 / 30, -50.0 / 30);
  check(command(8, 20), -10.0 / 30, 10.0 / 30);
}

TEST_CASE("When nothing is seen it turns left as if the resource were at the left edge") {
  Situation now;
  now.camera();
  check(finder()->respond(now.perception()).command, -50.0 / 30, 50.0 / 30);
  check(finder({{"search_column", 20.0}})->respond(now.perception()).command, 20.0 / 30,
        -20.0 / 30);
  check(finder({{"search_column", 5.0}})->respond(now.perception()).command, 20, 20);
}

TEST_CASE("Cameras that look to the sides make one wide picture") {
  const auto command = [](double azimuth_deg, double column) {
    return finder()->respond(Situation().view(sees(column), azimuth_deg).perception()).command;
  };
  // The right edge of a camera that looks 30 degrees to the left is the left edge of the front one.
  check(command(30, 100), -50.0 / 30, 50.0 / 30);
  check(command(30, 50), -100.0 / 30, 100.0 / 30);
  check(command(-30, 50), 100.0 / 30, -100.0 / 30);
  // Left in a camera that looks back is right of the robot.
  check(command(180, 40), 590.0 / 30, -590.0 / 30);
  check(command(180, 60), -590.0 / 30, 590.0 / 30);
}

TEST_CASE("Of several resources in several cameras the one most nearly ahead counts") {
  Situation now;
  now.camera().view(sees(50), 90).view(sees(90)).view(sees(50), -30);
  check(finder()->respond(now.perception()).command, 40.0 / 30, -40.0 / 30);
}

TEST_CASE("Most nearly ahead is by the angle, also between cameras that see differently wide") {
  Situation now;
  // 17 degrees off in a wide picture, 9 off at the edge of a narrow one.
  now.view(sees(65, 100, 90)).view(sees(95, 100, 20));
  check(finder()->respond(now.perception()).command, 45.0 / 20, -45.0 / 20);
}

TEST_CASE("The activation is low while it searches, and grows with the size of the resource") {
  CHECK(finder()->respond(Situation().camera().perception()).activation == 0.2);
  CHECK(
      finder({{"search_activation", 0.0}})->respond(Situation().camera().perception()).activation ==
      0.0);
  const auto activation = [](double area_px) {
    return finder()->respond(Situation().view(sees(50, 100, 30, area_px)).perception()).activation;
  };
  CHECK(activation(0) == Approx(0.5));
  CHECK(activation(2500) == Approx(0.75));
  CHECK(activation(10000) == Approx(1.0));
}

namespace {

/// The events of a behaviour that sees a resource or nothing at given times.
class Watch {
 public:
  explicit Watch(test::Parameters parameters = {}) : behavior(finder(std::move(parameters))) {}

  /// "in", "out" or "".
  std::string at(double time_s, bool seen) {
    Situation now;
    now.time(time_s);
    seen ? now.blob(50) : now.camera();
    const Response response = behavior->respond(now.perception());
    // Events may wait, commands do not.
    CHECK(rates(response.command).left == (seen ? Approx(20.0) : Approx(-50.0 / 30)));
    std::string text;
    for (const Event& event : response.events) {
      text += event.name == "resource_in_view"       ? "in"
              : event.name == "resource_out_of_view" ? "out"
                                                     : "?";
    }
    return text;
  }

  plugin::Object<Behavior> behavior;
};

}  // namespace

TEST_CASE("It says when a resource comes into view and when none was for half a second") {
  Watch watch;
  CHECK(watch.at(0, false).empty());
  CHECK(watch.at(1, true) == "in");
  CHECK(watch.at(2, true).empty());
  CHECK(watch.at(2.01, false).empty());
  CHECK(watch.at(2.49, false).empty());
  CHECK(watch.at(2.5, false) == "out");
  CHECK(watch.at(9, false).empty());
  CHECK(watch.at(9.01, true) == "in");
  Random random;
  watch.behavior->reset(random);
  CHECK(watch.at(0, true) == "in");
}

TEST_CASE("A resource that comes and goes at the edge of the picture is in view all the time") {
  Watch watch;
  std::string events;
  for (int i = 0; i < 1000; ++i) {
    events += watch.at(0.01 * i, i % 8 < 3);
  }
  CHECK(events == "in");
}

TEST_CASE("How long a resource must be out of sight to be lost is a parameter") {
  Watch patient({{"lost_after", 4.0}});
  CHECK(patient.at(0, true) == "in");
  CHECK(patient.at(3.99, false).empty());
  CHECK(patient.at(4, false) == "out");
  Watch hasty({{"lost_after", 0.0}});
  CHECK(hasty.at(0, true) == "in");
  CHECK(hasty.at(0.01, false) == "out");
  CHECK(hasty.at(0.02, true) == "in");
}

TEST_CASE("Threshold, gain and speed of find_resource are parameters") {
  const test::Parameters parameters{{"turn_above", 10.0}, {"gain", 3.0}, {"speed", 8.0}};
  check(answer(40, 30, parameters), 8, 8);
  check(answer(35, 30, parameters), -1.5, 1.5);
}

TEST_CASE("A robot without a camera is refused find_resource") {
  const Declaration* declaration = test::shipped().find(PluginKind::behavior, "find_resource");
  REQUIRE(declaration->needs.size() == 1);
  CHECK(declaration->needs[0].kind == "vision");
}

TEST_CASE("A search goes on to where the resource was seen last, or to that side") {
  for (const char* search : {"column", "last_column", "last_side"}) {
    CAPTURE(search);
    const auto finds = finder({{"search", std::string(search)}});
    Random random(1);
    finds->reset(random);
    const auto command = [&](std::optional<double> column) {
      Situation situation;
      if (column) {
        situation.blob(*column, 30.0);
      } else {
        situation.camera();
      }
      return finds->respond(situation.perception()).command;
    };
    check(command({}), -50.0 / 30, 50.0 / 30);  // nothing was seen yet: to the left
    command(80);
    const std::string how = search;
    const double rate = how == "column" ? -50.0 / 30 : how == "last_side" ? 50.0 / 30 : 30.0 / 30;
    check(command({}), rate, -rate);
    command(52);  // nearly ahead
    how == "last_column" ? check(command({}), 20, 20) : check(command({}), rate, -rate);
    command(10);
    const double left = how == "last_column" ? -40.0 / 30 : -50.0 / 30;
    check(command({}), left, -left);
  }
}
