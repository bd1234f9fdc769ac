#include <catch2/catch.hpp>

#include "elsie/render/world_cameras.h"
#include "elsie/traces/tracks.h"

#include "recorded.h"

using namespace elsie;
using namespace elsie::test;
using simulation::Simulation;

namespace {

/// The picture of a simulation itself, as the program draws it.
void draw(const Simulation& simulation, const traces::TrackRecorder& tracks,
          const std::filesystem::path& file) {
  picture::TopView view{simulation.world()};
  for (std::size_t r = 0; r < simulation.robots(); ++r) {
    const simulation::RobotView robot = simulation.robot(r);
    const traces::Track& track = tracks.tracks()[r];
    picture::RobotTrack drawn{robot.description->id, track.path, robot.pose,   {},
                              track.touches,         {},         track.placed, track.from_s};
    for (const auto& each : simulation.sketches(r)) drawn.sketches.push_back(each.sketch);
    if (robot.description->localisation) drawn.believed = robot.state->pose;
    drawn.believed_path = track.believed;
    for (std::size_t k = 0; k < robot.description->segments.size(); ++k) {
      drawn.segments.push_back(simulation.segment(r, k).pose);
    }
    view.robots.push_back(std::move(drawn));
  }
  for (std::size_t i = 0; i < simulation.world().obstacles.size(); ++i) {
    view.boxes.push_back(simulation.obstacle(i));
  }
  for (const auto& each : simulation.sketches()) view.sketches.push_back(each.sketch);
  view.subtitles = {"end"};
  view.path_period_s = tracks.period_s();
  picture::save_top_view(view, file, {600, 0});
}

}  // namespace

// Collected and pushed boxes, moving ones, chargers, segments, teams, collisions, sketches; what
// was collected comes back elsewhere, and is collected again.
TEST_CASE("The picture from a recording alone is that of the run itself, byte for byte") {
  const std::vector<std::pair<const char*, double>> worlds{
      {"four_resources.xml", 12.34}, {"pushing.xml", 12.34},
      {"clutter_moving.xml", 12.34}, {"train.xml", 12.34},
      {"recharge.xml", 12.34},       {"ten_robots.xml", 12.34},
      {"nested.xml", 12.34},         {"drives.xml", 12.34},
      {"khepera.xml", 12.34},        {"../examples/09-acts/pasture.xml", 191.0}};
  for (const auto& [name, duration_s] : worlds) {
    INFO(name);
    McapFile file;
    const Folder folder;
    Simulation simulation(shipped_world(name, duration_s), shipped(),
                          {.cameras = render::world_cameras});
    traces::TrackRecorder tracks;
    {
      const auto recorder = recording::mcap_recorder(file.path);
      simulation::Observer* const observers[] = {&tracks, recorder.get()};
      simulation.run(observers);
    }
    draw(simulation, tracks, folder.file("own.png"));
    recording::save_picture(recording::read_recorded_run(file.path), shipped(), {"end"},
                            folder.file("replayed.png"), {600, 0});
    CHECK(folder.read("own.png").size() > 5000);
    const bool same = folder.read("own.png") == folder.read("replayed.png");
    CHECK(same);
  }
}

TEST_CASE("A box that was put elsewhere begins there") {
  McapFile file;
  Simulation simulation(world::parse_world(R"(<world format="1"><obstacles>
      <dynamic_box id="b" x="-1" mass="1"/></obstacles><limits time="1"/></world>)",
                                           "", shipped()),
                        shipped());
  {
    const auto recorder = recording::mcap_recorder(file.path);
    simulation::Observer* const observers[] = {recorder.get()};
    const simulation::TimedEdit changes[] = {{0.5, {"obstacle[b]/@x", "1.5"}}};
    simulation.run(observers, changes);
  }
  CHECK(recording::read_recorded_run(file.path, 0.3).starts.at("b").x == -1.0);
  const auto run = recording::read_recorded_run(file.path);
  CHECK(run.starts.at("b").x == 1.5);
  CHECK(run.moved.at("b").x == Approx(1.5).margin(0.01));
}

TEST_CASE("A robot that was put elsewhere is drawn without a line to there, from a recording too") {
  McapFile file;
  Simulation simulation(shipped_world("open_arena.xml", 4), shipped());
  traces::TrackRecorder tracks;
  {
    const auto recorder = recording::mcap_recorder(file.path);
    simulation::Observer* const observers[] = {&tracks, recorder.get()};
    const simulation::TimedEdit changes[] = {{2.0, {"robot[r1]/@x", "-1.5"}}};
    simulation.run(observers, changes);
  }
  const auto run = recording::read_recorded_run(file.path);
  REQUIRE(!tracks.tracks()[0].placed.empty());
  CHECK(run.robots[0].placed == tracks.tracks()[0].placed);
  CHECK(run.robots[0].path == tracks.tracks()[0].path);
}

TEST_CASE("Robots that an edit removed or added are drawn as they are, from a recording too") {
  McapFile file;
  const Folder folder;
  world::World world = shipped_world("ten_robots.xml", 300.0);
  const std::string first = world.robots[0].id, second = world.robots[1].id;
  Simulation simulation(std::move(world), shipped(),
                        {.data_directories = {source_path("")},
                         .time_limit_s = 4.0,
                         .cameras = render::world_cameras});
  const auto recorder = recording::mcap_recorder(file.path);
  traces::TrackRecorder tracks;
  simulation::Observer* const observers[] = {&tracks, recorder.get()};
  simulation.run(observers, std::vector<simulation::TimedEdit>{
                                {1.0, {"robot[" + first + "]/@remove", "true"}},
                                {1.5, {"physics/@step", "0.003"}},
                                {2.03, {"robot[+]", "<robot id=\"late\" x=\"0.1\" y=\"0.1\"/>"}},
                                {2.5, {"robot[" + second + "]/body/@mass", "1.5"}}});
  draw(simulation, tracks, folder.file("own.png"));
  const recording::RecordedRun run = recording::read_recorded_run(file.path);
  recording::save_picture(run, shipped(), {"end"}, folder.file("replayed.png"), {600, 0});
  CHECK(folder.read("own.png") == folder.read("replayed.png"));
  REQUIRE(run.robots.size() == 10);
  for (const picture::RobotTrack& robot : run.robots) {
    CHECK(robot.id != first);
    CHECK(robot.from_s == Approx(robot.id == "late" ? 2.1 : 0.0));
    CHECK(robot.path.size() == (robot.id == "late" ? 20 : 41));
  }
  // As it was before the edits.
  const recording::RecordedRun before = recording::read_recorded_run(file.path, 0.95);
  CHECK(before.robots.size() == 10);
  CHECK(std::none_of(before.robots.begin(), before.robots.end(),
                     [](const picture::RobotTrack& robot) { return robot.id == "late"; }));
}
