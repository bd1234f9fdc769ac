// The page of a run in a browser, with pictures drawn in software: where robots are drawn, links,
// keys, touch, and what is left without WebGL.
#include <cmath>
#include <filesystem>
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "elsie/page/run_page.h"

#include "browser.h"
#include "made_run.h"

using namespace elsie;
using namespace elsie::test;
using nlohmann::json;

namespace {

constexpr const char* kSoftware =
    "--use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader";

Browser browser_of(const std::string& html, const std::string& flags = kSoftware) {
  return Browser(
      html,
      {.folder = "tests/page/browser", .script = "tests/page/browser/check.js", .flags = flags});
}

void check_page(const json& found) {
  INFO(found.dump(1));
  CHECK(found["errors"].empty());
  CHECK(found["resources"].empty());
  CHECK(found["hacked"].is_null());
  CHECK(found["images"] == 1);
  CHECK(found["scrollWidth"].get<int>() <= found["width"].get<int>());
  CHECK(found["beyond"].empty());
  CHECK(found["nameless"].empty());
  CHECK(found["inked"] == true);
}

/// A channel of a colour without its grey.
double tint(const json& colour, std::size_t channel) {
  return colour[channel].get<double>() -
         std::min({colour[0].get<double>(), colour[1].get<double>(), colour[2].get<double>()});
}

/// How far apart two colours are in hue, whatever their brightness and paleness: 0 to 2.
double apart(const json& a, const json& b) {
  const auto share = [](const json& colour, std::size_t i) {
    return tint(colour, i) / std::max(tint(colour, 0) + tint(colour, 1) + tint(colour, 2), 1.0);
  };
  double sum = 0.0;
  for (const std::size_t i : {0, 1, 2}) sum += std::abs(share(a, i) - share(b, i));
  return sum;
}

}  // namespace

TEST_CASE("Robots are drawn where the recording has them, in the colours of their teams") {
  RecordedFile run(two_robots(), shipped());
  Browser browser = browser_of(page::run_page(run.path, shipped()).html);
  const json found = browser.look(1280);
  check_page(found);
  CHECK(found["space"] == true);
  CHECK(found["robots"] == json({"r1", "r2"}));
  REQUIRE(found["instants"].size() == 3);
  for (const json& instant : found["instants"]) {
    const auto recorded = recording::read_recorded_run(run.path, instant["time"].get<double>());
    for (std::size_t i = 0; i < 2; ++i) {
      const json& robot = instant["robots"][i];
      const Pose& pose = recorded.robots[i].now;
      CAPTURE(instant["time"], robot.dump());
      CHECK(robot["pose"]["x"].get<double>() == Approx(pose.x).margin(1e-4));
      CHECK(robot["pose"]["y"].get<double>() == Approx(pose.y).margin(1e-4));
      CHECK(std::abs(wrap_angle(robot["pose"]["h"].get<double>() - pose.heading_rad)) < 2e-4);
      CHECK(apart(robot["shown"], robot["colour"]) < 0.2);
      CHECK(tint(robot["shown"], 0) + tint(robot["shown"], 2) > 60.0);  // it is no grey
      // Nothing of that colour was there before.
      CHECK(apart(robot["at_start"], robot["colour"]) > 0.3);
    }
  }
  CHECK(browser.log().find("CONSOLE") == std::string::npos);
  CHECK(browser.network() == std::vector<std::string>{});
}

TEST_CASE("A link leads to an instant and a robot; keys, slider and fingers do what they should") {
  RecordedFile run(two_robots(), shipped());
  Browser browser = browser_of(page::run_page(run.path, shipped()).html);
  const json found = browser.look(390, "--force-dark-mode", "#t=12.5&robot=r2");
  check_page(found);
  CHECK(found["width"] == 390);
  CHECK(found["dark"] == true);
  CHECK(found["at_load"] == json({{"time", 12.5}, {"robot", "r2"}}));
  CHECK(found["at_end"] == found["end"]);
  CHECK(found["at_home"] == 0);
  CHECK(found["plays"] == true);
  CHECK(found["play_label"] == "Pause");
  CHECK(found["pauses"] == true);
  CHECK(found["first_event"][0] == found["first_event"][1]);
  CHECK(found["second"] == "r2");
  CHECK(found["slid"].get<double>() == Approx(10.0));
  CHECK_THAT(found["text"].get<std::string>(), Catch::Matches("10\\.0 s, [a-z_]+ decides"));
  CHECK(found["address"] == "#t=10&robot=r2");
  CHECK(found["linked"] == json({{"time", 1.5}, {"robot", "r1"}}));
  CHECK(found["holds_keys"] == false);
  CHECK(found["views"] == 3);
}

TEST_CASE("Without WebGL the picture from above and the time line are left") {
  RecordedFile run(two_robots(), shipped());
  Browser browser =
      browser_of(page::run_page(run.path, shipped()).html, "--disable-gpu --disable-3d-apis");
  const json found = browser.look(1280);
  check_page(found);
  CHECK(found["space"] == false);
  CHECK(found["picture"] == json({{"shown", true}, {"loaded", true}}));
  CHECK(found["lanes"].get<int>() >= 3);
  CHECK(found["decides"] != "");
  CHECK(found["linked"] == json({{"time", 1.5}, {"robot", "r1"}}));
}

TEST_CASE("A legend says what the colours of fields mean at the time") {
  world::World world = two_robots();
  world.fields.resize(3);
  world.fields[0].id = "pheromone";
  world.fields[0].half_life = 10.0;
  world.fields[0].start = 2.0;
  world.fields[1].id = "none";
  world.fields[2].id = "heat";
  world.fields[2].start = 0.5;
  world.fields[2].full = 40.0;
  world.fields[2].colour = {200, 60, 0};
  RecordedFile run(world, shipped());
  Browser browser = browser_of(page::run_page(run.path, shipped()).html);
  const json found = browser.look(390);
  check_page(found);
  CHECK(found["fields"][0] == json({"heat 0 40 per m²", "pheromone 0 2 per m²"}));
  CHECK(found["fields"][1] == json({"heat 0 40 per m²", "pheromone 0 0.5 per m²"}));
  browser.shoot("fields.png", 1280, 800, "", "#t=9");
  browser.shoot("fields-dark.png", 1280, 800, "--force-dark-mode", "#t=9");
  browser.shoot("fields-phone.png", 390, 844, "", "#t=9");
}

TEST_CASE("The camera that follows a robot looks over a wall behind it") {
  world::World world = two_robots();
  world.robots[0].x = -2.7;
  world.robots[0].heading_deg = 0.0;
  RecordedFile run(world, shipped());
  Browser browser = browser_of(page::run_page(run.path, shipped()).html);
  const json found = browser.look(1280);
  check_page(found);
  CHECK(apart(found["followed"]["shown"], found["followed"]["colour"]) < 0.2);
  CHECK(tint(found["followed"]["shown"], 0) + tint(found["followed"]["shown"], 2) > 60.0);
}

TEST_CASE("A page without fields has no legend") {
  RecordedFile run(two_robots(), shipped());
  Browser browser = browser_of(page::run_page(run.path, shipped()).html);
  CHECK(browser.look(1280)["fields"] == json({json::array(), json::array()}));
}

TEST_CASE("Texts that look like markup stay texts") {
  RecordedFile run(two_robots(), shipped());
  McapFile hostile;
  write_hostile(run.path, hostile.path);
  Browser browser = browser_of(page::run_page(hostile.path, shipped()).html);
  const json found = browser.look(390);
  check_page(found);
  CHECK(found["scripts"] == 3);  // the data, the viewer, and the one that looks
  CHECK(found["title"] == kHostileText);
  CHECK(found["why"] == kHostileText);
  CHECK(found["first_listed"] == kHostileText + kHostileText);
  CHECK(browser.log().find("CONSOLE") == std::string::npos);
}

TEST_CASE("Pictures of the page, to be looked at", "[.pictures]") {
  RecordedFile run(shipped_world("clutter.xml", 40), shipped());
  Browser browser = browser_of(page::run_page(run.path, shipped()).html);
  CHECK(std::filesystem::file_size(browser.shoot("desk.png", 1280, 800, "", "#t=25")) > 50'000);
  CHECK(std::filesystem::file_size(
            browser.shoot("dark.png", 1280, 800, "--force-dark-mode", "#t=25")) > 50'000);
  CHECK(std::filesystem::file_size(browser.shoot("phone.png", 390, 844, "", "#t=25")) > 30'000);
}
