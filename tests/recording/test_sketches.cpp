// What plugins draw and publish, and what robots believe, in recordings.
#include <cmath>
#include <fstream>
#include <limits>

#include <catch2/catch.hpp>

#include "elsie/recording/csv_recorder.h"

#include "recorded.h"
#include "sketches.h"

using namespace elsie;
using namespace elsie::test;
using simulation::Simulation;

namespace {

/// Draws a mark of each kind, and publishes a number that exists from the second decision on.
class Drawing final : public Behavior {
 public:
  double clearance = std::numeric_limits<double>::quiet_NaN();

  Response respond(const Perception& now) override {
    if (now.time_s() > 0.0) clearance = 1.5;
    return Response(Motion{0.1, 0.0, 0.0});
  }
  void sketch(Sketch& sketch) const override {
    sketch.line(SketchRole::range, {0, 0, 0.1}, {1, 0, 0.1});
    sketch.point(SketchRole::hit, {1, 0, 0.1});
    sketch.circle(SketchRole::field, {0, 0, 0}, 0.5);
    sketch.arrow(SketchRole::wish, {0, 0, 0}, {0.3, 0.2, 0.1});
    sketch.text(SketchRole::target, {0, 1, 0}, "there");
  }
};

PublishedNumber clearance() {
  return {"clearance",
          {.unit = "m", .meaning = "to the nearest wall"},
          [](const Component& object) { return static_cast<const Drawing&>(object).clearance; }};
}

struct DrawingHost {
  plugin::Host host{shipped_directory()};

  DrawingHost() {
    Declaration drawing =
        declaration_of(PluginKind::behavior, "drawing", [] { return std::make_unique<Drawing>(); });
    drawing.published.push_back(clearance());
    host.add(std::move(drawing));
  }
};

std::vector<std::string> lines_of(const std::filesystem::path& file) {
  std::vector<std::string> lines;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string ends_of(const std::string& line) { return line.substr(line.rfind(',') + 1); }

}  // namespace

TEST_CASE("Sketches are read back from a message as they were drawn") {
  Sketch sketch(Frame::turned({1, 2, 0}, 0.7, 0.0));
  Drawing().sketch(sketch);
  sketch.points(SketchRole::belief, std::vector<Vector3>{{1, 2, 3}, {4, 5, 6}});
  sketch.line(SketchRole::range, {0, 0, 0}, {0, 2, 0});
  const simulation::PluginSketch one{"explore/draw", PluginKind::behavior, sketch};
  const recording::Json message = recording::sketches_message(1'000'000'000, 150'000'000, "r1",
                                                              std::span(&one, std::size_t{1}));
  REQUIRE(message["entities"].size() == 1);
  CHECK(message["entities"][0]["id"] == "r1/explore/draw");
  CHECK(message["entities"][0]["frame_id"] == "world");
  CHECK(message["entities"][0]["lifetime"]["nsec"] == 150'000'000);
  CHECK(message["entities"][0]["lines"].size() == 3);  // range, hit and field

  const std::vector<Sketch> read = recording::sketches_of(message);
  REQUIRE(read.size() == 1);
  REQUIRE(read[0].marks().size() == sketch.marks().size());
  for (std::size_t i = 0; i < sketch.marks().size(); ++i) {
    const Sketch::Mark &mark = sketch.marks()[i], &again = read[0].marks()[i];
    CHECK(again.kind == mark.kind);
    // A line of a range that ends at a hit is one.
    CHECK(again.role == (i == 0 ? SketchRole::hit : mark.role));
    CHECK(again.text == mark.text);
    REQUIRE(again.count == mark.count);
    for (std::size_t k = 0; k < mark.count; ++k) {
      const Vector3 off = read[0].places(again)[k] - sketch.places(mark)[k];
      CHECK(std::abs(off.x) + std::abs(off.y) + std::abs(off.z) < 1e-12);
    }
  }
}

TEST_CASE("Plugins with the same path have entities of their own") {
  Sketch sketch(Frame{});
  sketch.point(SketchRole::hit, {});
  const std::vector<simulation::PluginSketch> two{{"a", PluginKind::behavior, sketch},
                                                  {"a", PluginKind::coordinator, sketch}};
  const recording::Json message = recording::sketches_message(0, 0, "r1", two);
  CHECK(message["entities"][0]["id"] == "r1/a");
  CHECK(message["entities"][1]["id"] == "r1/a coordinator");
}

TEST_CASE("What a plugin draws and publishes has channels; a world without it has none") {
  const DrawingHost plugins;
  world::World world;
  world.robots.push_back(robot("r1", 0, 0, 0, behavior("drawing")));
  world.robots.push_back(robot("r2", 1, 1, 0, behavior("wander")));
  world.limits.time = 0.5;
  McapFile file;
  Simulation simulation(world, plugins.host);
  record(simulation, file.path);
  const auto all = recorded(file.path);
  REQUIRE(all.contains("/robots/r1/sketches"));
  CHECK(all.at("/robots/r1/sketches").size() + 1 == all.at("/robots/r1/state").size());
  CHECK(all.at("/robots/r1/sketches")[0].content["entities"][0]["id"] == "r1/drawing");
  CHECK(all.at("/robots/r1/published").size() == all.at("/robots/r1/sketches").size());
  CHECK(all.at("/robots/r1/published").back().content["plugins"]["drawing"]["clearance"] == 1.5);
  for (const char* topic : {"/robots/r2/sketches", "/robots/r2/published", "/robots/r1/belief",
                            "/sketches", "/published"}) {
    INFO(topic);
    CHECK_FALSE(all.contains(topic));
  }
  const traces::Trace trace = recording::read_trace(file.path);
  REQUIRE(trace.robots[0].numbers.size() == 1);
  const traces::TraceNumber& number = trace.robots[0].numbers[0];
  CHECK(number.path == "drawing");
  CHECK(number.name == "clearance");
  CHECK(number.unit == "m");
  REQUIRE(number.samples.size() > 3);
  CHECK(number.samples.back().value == 1.5);
  CHECK(trace.robots[1].numbers.empty());
}

TEST_CASE("A recording lacks what a plugin fails to draw, says so once, and the run is the same") {
  class Scrawling final : public Behavior {
    Response respond(const Perception& /*now*/) override { return Response(Motion{0.1, 0.0, 0.0}); }
    void sketch(Sketch& sketch) const override {
      sketch.point(SketchRole::hit, {std::numeric_limits<double>::infinity(), 0, 0});
    }
  };
  plugin::Host host{shipped_directory()};
  host.add(declaration_of(PluginKind::behavior, "scrawling",
                          [] { return std::make_unique<Scrawling>(); }));
  world::World world;
  world.robots.push_back(robot("r1", 0, 0, 0, behavior("scrawling")));
  world.limits.time = 0.5;
  McapFile file;
  Simulation simulation(world, host);
  std::vector<std::string> warnings;
  recording::RecorderOptions options;
  options.warn = [&](const std::string& text) { warnings.push_back(text); };
  const auto result = record(simulation, file.path, options);
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0],
             Catch::Contains("the recording lacks sketches") && Catch::Contains("'scrawling'"));
  CHECK_FALSE(recorded(file.path).contains("/robots/r1/sketches"));
  CHECK(result.state_hash == Simulation(world, host).run().state_hash);
}

TEST_CASE("A localisation has a channel of what the robot believes, and columns of a table") {
  world::World world;
  world.robots.push_back(robot("r1", 0, 0, 0, behavior("wander")));
  world.robots.push_back(robot("r2", 1, 1, 0, behavior("wander")));
  world::PluginUse odometry;
  odometry.plugin = odometry.id = "odometry";
  world.robots[0].localisation = odometry;
  world.limits.time = 2;
  McapFile file;
  TemporaryFile table;
  Simulation simulation(world, shipped(), {.seed = 3});
  {
    const auto mcap = recording::mcap_recorder(file.path);
    const auto csv = recording::csv_recorder(table.path, {.rate_hz = 10.0});
    simulation::Observer* const observers[] = {mcap.get(), csv.get()};
    simulation.run(observers);
  }
  const auto all = recorded(file.path);
  CHECK(all.at("/robots/r1/belief").size() == all.at("/robots/r1/pose").size());
  CHECK_FALSE(all.contains("/robots/r2/belief"));
  const Pose& believed = simulation.robot(0).state->pose;
  const auto& last = all.at("/robots/r1/belief").back().content["pose"]["position"];
  CHECK(last["x"] == believed.x);
  CHECK(all.at("/robots/r1/state").back().content["x_m"] == simulation.robot(0).pose.x);
  const recording::RecordedRun run = recording::read_recorded_run(file.path);
  REQUIRE(run.robots[0].believed);
  CHECK(run.robots[0].believed->x == believed.x);
  CHECK(run.robots[0].believed->heading_rad == Approx(wrap_angle(believed.heading_rad)));
  CHECK(run.robots[0].believed_path.size() == run.robots[0].path.size());
  CHECK_FALSE(run.robots[1].believed);
  const Folder folder;
  recording::save_picture(run, shipped(), {}, folder.file("replayed.png"), {300, 0});
  CHECK(folder.read("replayed.png").size() > 1000);

  const std::vector<std::string> lines = lines_of(table.path);
  CHECK_THAT(lines[0], Catch::Contains(",believed_x_m,believed_y_m,believed_heading_rad"));
  CHECK_THAT(lines[2], Catch::Contains(",,,"));  // r2 knows
}

TEST_CASE("Published numbers are columns of a table, empty where there are none") {
  const DrawingHost plugins;
  world::World world;
  world.robots.push_back(robot("r1", 0, 0, 0, behavior("drawing")));
  world.robots.push_back(robot("r2", 1, 1, 0, behavior("wander")));
  world.limits.time = 0.5;
  TemporaryFile table;
  Simulation simulation(world, plugins.host);
  {
    const auto csv = recording::csv_recorder(table.path, {.rate_hz = 10.0});
    simulation::Observer* const observers[] = {csv.get()};
    simulation.run(observers);
  }
  const std::vector<std::string> lines = lines_of(table.path);
  CHECK(ends_of(lines[0]) == "drawing.clearance");
  CHECK_THAT(lines[0], !Catch::Contains("believed"));
  CHECK(ends_of(lines[1]).empty());  // before any decision
  CHECK(ends_of(lines[lines.size() - 2]) == "1.5");
  CHECK(ends_of(lines.back()).empty());  // r2
}
