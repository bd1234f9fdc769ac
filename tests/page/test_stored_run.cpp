// A run of a database for the viewer: what it shows, and what it says that it does not show.
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <zlib.h>

#include "elsie/base/random.h"
#include "elsie/files/base64.h"
#include "elsie/page/stored_run.h"
#include "elsie/picture/top_view.h"
#include "elsie/world/description.h"
#include "elsie/world/error.h"

#include "folder.h"

using namespace elsie;
using nlohmann::json;
using page::StoredRun;

namespace {

/// What the viewer reads.
json data_of(const page::PageRun& run) {
  const std::string packed = files::from_base64(run.data).value();
  std::string text(50'000'000, '\0');
  z_stream stream{};
  constexpr int kRaw = -15;
  REQUIRE(inflateInit2(&stream, kRaw) == Z_OK);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(text.data());
  stream.avail_out = static_cast<uInt>(text.size());
  REQUIRE(inflate(&stream, Z_FINISH) == Z_STREAM_END);
  text.resize(stream.total_out);
  inflateEnd(&stream);
  return json::parse(text);
}

/// Lists are written as differences.
std::vector<double> sums(const json& differences, double unit = 1.0) {
  std::vector<double> all;
  double sum = 0.0;
  for (const json& each : differences) all.push_back((sum += each.get<double>()) * unit);
  return all;
}

constexpr double kFine = 1e-4;

/// A room with a robot, a resource and a box that can be pushed.
StoredRun stored() {
  StoredRun run;
  run.world_xml =
      "<world format=\"1\" name=\"a room\"><arena length=\"10\" width=\"10\"/>"
      "<obstacles><dynamic_box id=\"box\" x=\"1\" y=\"0.5\"/></obstacles>"
      "<resources><resource id=\"apple\" x=\"3\" y=\"3\"/></resources>"
      "<robots><robot id=\"r1\"/></robots></world>";
  run.world_file = "/nowhere/room.xml";
  run.library = "elsie 0.0.0";
  run.seed = 7;
  run.end_s = 1.75;
  run.result = {"success", "all is collected", 1.75, 175, "0123456789abcdef", {{"time_s", 1.75}}};
  run.robots.push_back({.id = "r1",
                        .period_s = 0.5,
                        .poses = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 3.0}, {2, 2, -3.0}},
                        .has_end = true});
  return run;
}

page::PageRun page_of(const StoredRun& run, page::PageOptions options = {}) {
  return page_run(run, plugin::Host(), options);
}

/// The body that a scene's robot or box has, and the places that it was at.
json body_of_robot(const json& data) {
  return data["poses"]["bodies"][data["scenes"][0]["robots"][0]["body"].get<std::size_t>()];
}
json body_of_box(const json& data, std::size_t number) {
  std::vector<int> bodies;
  for (const json& box : data["scenes"][0]["boxes"]) {
    const int body = box["body"].get<int>();
    if (body >= 0 && body != data["scenes"][0]["robots"][0]["body"].get<int>() &&
        (bodies.empty() || bodies.back() != body)) {
      bodies.push_back(body);
    }
  }
  INFO(data["scenes"][0].dump());
  REQUIRE(bodies.size() > number);
  return data["poses"]["bodies"][static_cast<std::size_t>(bodies[number])];
}

}  // namespace

TEST_CASE("A stored run has its poses at their times, and the last one at its end") {
  const json data = data_of(page_of(stored()));
  CHECK(sums(data["times"], kFine) == std::vector<double>{0.0, 0.5, 1.0, 1.5, 1.75});
  const json robot = body_of_robot(data);
  CHECK(sums(robot["x"], kFine) == std::vector<double>{0, 1, 2, 2, 2});
  CHECK(sums(robot["y"], kFine) == std::vector<double>{0, 0, 0, 1, 2});
  CHECK(data["end"] == 17500);
}

TEST_CASE("A robot turns the shorter way between two poses") {
  const std::vector<double> headings = sums(body_of_robot(data_of(page_of(stored())))["h"], kFine);
  REQUIRE(headings.size() == 5);
  CHECK(headings[4] - headings[3] == Approx(2.0 * M_PI - 6.0).margin(2e-4));
}

TEST_CASE("A robot whose poses are farther apart than others' drives straight between them") {
  StoredRun run = stored();
  run.robots[0].period_s = 1.0;
  run.robots[0].poses = {{0, 0, 0}, {1, 0, 0}};
  run.robots[0].has_end = false;
  run.robots.push_back(
      {.id = "other", .period_s = 0.25, .poses = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}});
  const std::vector<double> x = sums(body_of_robot(data_of(page_of(run)))["x"], kFine);
  CHECK(x == std::vector<double>{0.0, 0.25, 0.5, 0.75, 1.0});
}

TEST_CASE("A robot that an edit put elsewhere does not drive there") {
  StoredRun run = stored();
  run.events.push_back({1.2, "r1", "changed", "robot[r1]/@y=1", false});
  const json data = data_of(page_of(run));
  CHECK(body_of_robot(data)["set"] == json({3}));
  CHECK_THAT(page_of(run).facts, Catch::Contains("without its edits"));
}

TEST_CASE("A robot that is taken out of the world is not there any more") {
  StoredRun run = stored();
  run.robots[0].poses.resize(2);
  run.robots[0].has_end = false;
  run.robots.push_back(
      {.id = "other", .period_s = 0.5, .poses = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}});
  const json robot = body_of_robot(data_of(page_of(run)));
  CHECK(sums(robot["s"]) == std::vector<double>{0, 1, 2});
  CHECK(robot["gone"] == json({2}));
}

TEST_CASE("A run that failed ends at its last pose, and all robots are there until then") {
  StoredRun run = stored();
  run.robots[0].has_end = false;
  run.result = {};
  run.result.outcome = "fault";
  const page::PageRun shown = page_of(run);
  const json data = data_of(shown);
  CHECK(data["end"] == 20000);
  CHECK(body_of_robot(data)["gone"] == json::array());
  CHECK(shown.summary == "fault after 2.0 s  (seed 7)");
  CHECK(shown.outcome == "fault");
}

TEST_CASE("What is collected is gone from then on") {
  StoredRun run = stored();
  run.events.push_back({0.9, "r1", "collected", "apple", false});
  const json data = data_of(page_of(run));
  std::vector<json> gone;
  for (const json& body : data["poses"]["bodies"]) {
    if (!body["gone"].empty()) gone.push_back(sums(body["s"])[body["gone"][0].get<std::size_t>()]);
  }
  CHECK(gone == std::vector<json>{2.0});  // the sample at 1.0 s
  CHECK(data["events"][0] == json({9000, "r1", "collected", "apple", 0}));
}

TEST_CASE("What a robot holds moves with it, and stays where it is let go") {
  StoredRun run = stored();
  run.events = {{0.5, "r1", "taken", "box", false}, {1.0, "r1", "released", "box", false}};
  const json box = body_of_box(data_of(page_of(run)), 0);
  CHECK(sums(box["x"], kFine) == std::vector<double>{1.0, 2.0});
  CHECK(sums(box["y"], kFine) == std::vector<double>{0.5, 0.5});
}

TEST_CASE("A stored run says who decided when, and for which part of the time") {
  StoredRun run = stored();
  run.robots[0].behaviors = {"avoid", "roam", "roam/wander"};
  run.robots[0].episodes = {{0.0, 0.5, "avoid"},
                            {0.5, 1.0, "*", {{"avoid", 0.1}, {"roam", 0.3}, {"", 0.1}}},
                            {1.0, 1.5, ""},
                            {1.5, 1.75, "roam/wander"}};
  const json decisions = data_of(page_of(run))["decisions"][0];
  CHECK(decisions["of"] == "time");
  CHECK(decisions["bands"][0]["who"] == json({0, -2, -1, 2}));
  CHECK(sums(decisions["bands"][0]["t"], kFine) == std::vector<double>{0, 0.5, 1.0, 1.5});
  CHECK(sums(decisions["shares"][0]) == std::vector<double>{100, 20, 0, 0});
  CHECK(sums(decisions["shares"][1]) == std::vector<double>{0, 60, 0, 0});
  CHECK(sums(decisions["shares"][2]) == std::vector<double>{0, 0, 0, 100});
  CHECK(decisions["members"][2]["depth"] == 1);
}

TEST_CASE("A stored run says what is not known of it") {
  const std::string facts = page_of(stored()).facts;
  CHECK_THAT(facts, Catch::Contains("poses every 0.5 s, to 1 mm and 0.001 rad"));
  CHECK_THAT(facts, Catch::Contains("boxes that move stand where they began"));
  CHECK_THAT(facts, !Catch::Contains("segments") && !Catch::Contains("edits"));
  CHECK_THAT(facts, Catch::Contains("0123456789abcdef after 175 steps"));
}

TEST_CASE("A stored run shows nothing that is on the disk") {
  const test::Folder folder;
  StoredRun run = stored();
  run.world_file = (folder / "room.xml").string();
  run.world_xml =
      "<world format=\"1\"><floor image=\"floor.png\"/><robots><robot id=\"r1\"/>"
      "</robots></world>";
  const page::PageRun without = page_of(run);
  picture::save_top_view({.world = world::World()}, folder / "floor.png");
  CHECK(page_of(run).data == without.data);
  CHECK_THAT(without.facts, Catch::Contains("the floor is without its image"));
}

TEST_CASE("Poses that are no numbers are left out") {
  StoredRun run = stored();
  const double none = std::numeric_limits<double>::quiet_NaN();
  run.robots[0].poses[1] = {none, none, none};
  CHECK(sums(body_of_robot(data_of(page_of(run)))["x"], kFine) == std::vector<double>{0, 2, 2, 2});
  for (Pose& pose : run.robots[0].poses) pose.x = none;
  CHECK_FALSE(has_poses(run.robots[0]));
  CHECK_THROWS_AS(page_of(run), std::invalid_argument);
}

TEST_CASE("A robot whose period is no time cannot be shown") {
  for (const double period_s : {0.0, -1.0, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    StoredRun run = stored();
    run.robots[0].period_s = period_s;
    CHECK_FALSE(has_poses(run.robots[0]));
  }
}

TEST_CASE("A run that ends at no sensible time is sampled so seldom that it ends") {
  for (const double end_s : {1e6, 1e300, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    CAPTURE(end_s);
    StoredRun run = stored();
    run.end_s = end_s;
    CHECK(sums(data_of(page_of(run))["times"]).size() <= 20'002);
  }
}

TEST_CASE("A stored run that is too large is sampled more coarsely") {
  StoredRun run = stored();
  Random random(1, "ways");
  run.robots[0].poses.clear();
  for (int i = 0; i < 2000; ++i) {
    run.robots[0].poses.push_back({random.uniform(-4, 4), random.uniform(-4, 4), 0.0});
  }
  run.end_s = 999.6;
  const page::PageRun whole = page_of(run), small = page_of(run, {.most_bytes = 24'000});
  CHECK(whole.poses_every_s == 0.5);
  CHECK(small.poses_every_s > 0.5);
  CHECK(small.data.size() < whole.data.size());
  CHECK(page_of(run).data == whole.data);
}

TEST_CASE("Texts of a stored run are texts") {
  StoredRun run = stored();
  const std::string hostile = "</script><script>alert(1)</script>{{data}}\"'&";
  run.title = run.library = run.result.reason = hostile;
  run.result.measures[hostile] = 1.0;
  run.facts = {{hostile, hostile}};
  page_of(run).for_each_text([](const char* name, const std::string& text) {
    CAPTURE(name);
    CHECK_THAT(text, !Catch::Contains("<script") && !Catch::Contains("</script"));
  });
  const std::string html = html_of(page_of(run));
  CHECK(html.find("<script>alert") == std::string::npos);
  CHECK(html.find("{{data}}") != std::string::npos);  // as it is in the texts
}

TEST_CASE("A world that cannot be read is refused") {
  StoredRun run = stored();
  run.world_xml = "<world format=\"99\"/>";
  CHECK_THROWS_AS(page_of(run), world::WorldError);
}
