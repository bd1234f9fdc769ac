// The page in a browser, at the width of a desktop and of a phone, in light and dark mode.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "browser.h"
#include "edge_cases.h"
#include "hostile.h"

namespace fs = std::filesystem;
using namespace elsie::test;
using nlohmann::json;

namespace {

Browser browser_of(const std::string& html) {
  return Browser(html, {.folder = "tests/report/browser",
                        .script = "tests/report/browser/check.js",
                        .flags = "--disable-gpu"});
}

elsie::report::Questions questions() {
  elsie::experiment::Expectation fusion;
  fusion.name = "fusion completes every case";
  fusion.measure = "success";
  fusion.statistic = elsie::report::Statistic::rate;
  fusion.where = {{"coordinator", {"fusion"}}};
  fusion.at_least = 1.0;
  elsie::experiment::Expectation arbitration = fusion;
  arbitration.name = "arbitration does so, too";
  arbitration.where = {{"coordinator", {"arbitration"}}};
  elsie::report::Questions questions;
  questions.expectations = {fusion, arbitration};
  return questions;
}

void check(const json& found) {
  INFO(found.dump(1));
  CHECK(found["errors"].empty());
  CHECK(found["resources"].empty());
  CHECK(found["scrollWidth"].get<int>() <= found["width"].get<int>());
  CHECK(found["beyond"].empty());
  if (found["width"] > 1000) CHECK(found["wide"].empty());
  CHECK(found["flat"].empty());
  CHECK(found["tall"].empty());
  CHECK(found["cut"].empty());
  CHECK(found["small"].empty());
  CHECK(found["faint"].empty());
  CHECK(found["anchors"] == 0);
}

}  // namespace

TEST_CASE("The page of a study, at a desk and on a phone, in light and in dark") {
  Browser browser = browser_of(Made(elsie::test::made_study(), questions()).html());
  const auto [width, flags] = GENERATE(table<int, std::string>(
      {{1280, ""}, {390, ""}, {1280, "--force-dark-mode"}, {390, "--force-dark-mode"}}));
  const json found = browser.look(width, flags);
  CAPTURE(width, flags);
  CHECK(found["width"] == width);
  CHECK(found["dark"] == !flags.empty());
  check(found);
  CHECK(found["figures"].get<int>() >= 8 * 3 + 5 + 1);
  CHECK(found["pictures"].get<int>() >= 8 * 3 + 5 + 1);

  auto upwards = found["upwards"].get<std::vector<std::string>>();
  const auto by_number = [](const std::string& a, const std::string& b) {
    return std::stod(a) < std::stod(b);
  };
  CHECK(upwards != found["before"].get<std::vector<std::string>>());
  CHECK(std::is_sorted(upwards.begin(), upwards.end(), by_number));
  CHECK(found["sortedAs"] == "ascending");
  std::reverse(upwards.begin(), upwards.end());
  CHECK(found["downwards"].get<std::vector<std::string>>() == upwards);

  CHECK(found["filter"] == true);
  CHECK(found["chosen"] == json({"2 2, fusion", "2 2 2 2, fusion"}));
  CHECK(found["chosenRows"] == 2);

  // There were no requests to the network, and no complaints.
  CHECK(browser.log().find("CONSOLE") == std::string::npos);
  CHECK(browser.network() == std::vector<std::string>{});
}

TEST_CASE("A page with a request to the network would be detected") {
  std::string html = Made(elsie::test::made_study(), questions()).html();
  const std::string policy = "img-src data:";
  html.replace(html.find(policy), policy.size(), "img-src *");
  html.insert(html.find("</main>"), "<img src=\"http://elsie.invalid/picture.png\">");
  Browser browser = browser_of(html);
  browser.look(1280);
  const auto asked = browser.network();
  CHECK(std::find(asked.begin(), asked.end(), "http://elsie.invalid/picture.png") != asked.end());
}

TEST_CASE("Hostile names break neither the page nor its width") {
  Browser browser = browser_of(
      Made(elsie::test::hostile(), elsie::test::expecting(elsie::test::hostile_expectation()))
          .html(elsie::test::kHostile));
  const json found = browser.look(390);
  check(found);
  CHECK(browser.log().find("CONSOLE") == std::string::npos);
}

TEST_CASE("Pages of what is hardly a study fit a desk and a phone") {
  for (const elsie::test::EdgeCase& edge : elsie::test::edge_cases()) {
    Browser browser = browser_of(Made(edge.experiment, elsie::test::edge_questions()).html());
    for (const int width : {1280, 390}) {
      CAPTURE(edge.name, width);
      check(browser.look(width));
      CHECK(browser.log().find("CONSOLE") == std::string::npos);
    }
  }
}

namespace {

constexpr const char* kSoftware =
    "--use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader";

/// Two cells with robots that drive around corners, and a run that failed.
MadeExperiment driving() {
  MadeExperiment experiment = made_from({{1, 2, 3}, {1, 2, 3}});
  experiment.cells[1].runs[0].end_as("fault");
  for (MadeCell& cell : experiment.cells) {
    for (MadeRun& run : cell.runs) {
      run.robots.front().poses = {{0, 0, 0}, {2, 0, 0}, {2, 0, 1.5}, {2, 2, 1.5}, {2, 4, 1.5}};
      run.robots.front().shares = {{"avoid", 0.4}, {"roam", 0.6}};
      run.robots.front().episodes = {{0, 1, "roam"}, {1, 2, "avoid"}};
    }
  }
  return experiment;
}

json play(const std::string& html, int width, const std::string& flags,
          const std::string& address = "") {
  Browser browser(
      html,
      {.folder = "tests/report/browser", .script = "tests/report/browser/runs.js", .flags = flags});
  const json found = browser.look(width, "", address);
  INFO(found.dump(1));
  INFO(browser.log());
  CHECK(found["errors"].empty());
  CHECK(found["resources"].empty());
  CHECK(found["hacked"].is_null());
  CHECK(found["scrollWidth"].get<int>() <= found["width"].get<int>());
  CHECK(browser.network() == std::vector<std::string>{});
  CHECK(browser.log().find("Content Security Policy") == std::string::npos);
  return found;
}

}  // namespace

TEST_CASE("A click plays a run where the database has its robots, at a desk and on a phone") {
  const std::string html = Made(driving()).html();
  const int width = GENERATE(1280, 390);
  const json found = play(html, width, kSoftware);
  INFO(found.dump(1));
  CHECK(found["first"] == true);
  CHECK(found["buttons"] == json({"Play run 2", "Play run 5", "Play run 4"}));
  REQUIRE(found["runs"].size() == 2);
  for (const json& run : found["runs"]) {
    CHECK(run["plays"] == true);
    CHECK(run["space"] == true);
    CHECK(run["current"] == json({run["id"]}));
    CHECK(run["end"].get<double>() == Approx(2.0));
    const std::vector<std::array<double, 3>> poses{{0, 0, 0}, {2, 0, 1.5}, {2, 4, 1.5}};
    for (std::size_t i = 0; i < 3; ++i) {
      const json& pose = run["instants"][i]["pose"];
      CHECK(pose["x"].get<double>() == Approx(poses[i][0]).margin(1e-3));
      CHECK(pose["y"].get<double>() == Approx(poses[i][1]).margin(1e-3));
      CHECK(pose["h"].get<double>() == Approx(poses[i][2]).margin(1e-3));
    }
  }
  CHECK(found["runs"][0]["title"] == "a");
  CHECK(found["runs"][1]["title"] == "b");
  // On a phone the frame is as high as what it shows, at a desk what it shows is as high as it.
  CHECK(found["fits"] == true);
  CHECK(found["frame"]["wide"].get<int>() <= found["frame"]["width"].get<int>());
}

TEST_CASE("A link leads to a run, an instant and a robot") {
  const json found = play(Made(driving()).html(), 1280, kSoftware, "#run=5&t=1.25&robot=r1");
  INFO(found.dump(1));
  CHECK(found["linked"]["run"] == "5");
  CHECK(found["linked"]["time"] == 1.25);
  CHECK(found["linked"]["robot"] == "r1");
  CHECK(std::abs(found["linked"]["top"].get<double>()) < 900.0);
  CHECK(found["runs"][0]["address"] == "#run=2&t=2&robot=r1");
}

TEST_CASE("Without WebGL a run is the picture from above, and its time line") {
  const json found = play(Made(driving()).html(), 1280, "--disable-gpu --disable-3d-apis");
  INFO(found.dump(1));
  CHECK(found["runs"][0]["space"] == false);
  CHECK(found["runs"][0]["flat"] == true);
  CHECK(found["runs"][0]["picture"].get<int>() > 0);
  CHECK(found["runs"][0]["plays"] == true);
}

TEST_CASE("Hostile names of runs that are played do nothing") {
  const json found =
      play(Made(elsie::test::hostile()).html(elsie::test::kHostile), 1280, kSoftware);
  INFO(found.dump(1));
  CHECK(found["runs"].size() > 0);
}

TEST_CASE("Pictures of the page, to be looked at") {
  Browser browser = browser_of(Made(elsie::test::made_study(), questions()).html());
  CHECK(fs::file_size(browser.shoot("desk.png", 1280, 9000)) > 100'000);
  CHECK(fs::file_size(browser.shoot("phone.png", 390, 12000)) > 100'000);
  CHECK(fs::file_size(browser.shoot("dark.png", 1280, 9000, "--force-dark-mode")) > 100'000);
}
