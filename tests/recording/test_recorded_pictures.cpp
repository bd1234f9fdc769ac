#include <fstream>

#include <catch2/catch.hpp>

#include "elsie/recording/beams.h"
#include "elsie/render/world_cameras.h"
#include "elsie/traces/tracks.h"

#include "recorded.h"

using namespace elsie;
using namespace elsie::test;
using simulation::Simulation;

namespace {

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The picture of a simulation itself, as the program draws it.
void draw(const Simulation& simulation, const traces::TrackRecorder& tracks,
          const std::filesystem::path& file) {
  picture::TopView view{simulation.world()};
  for (std::size_t r = 0; r < simulation.robots(); ++r) {
    const simulation::RobotView robot = simulation.robot(r);
    const traces::Track& track = tracks.tracks()[r];
    picture::RobotTrack drawn{robot.description->id, track.path, robot.state->pose, {},
                              track.touches,         {},         track.placed};
    for (const auto& beam : recording::range_beams(simulation, r)) {
      drawn.beams.push_back({{beam.from.x, beam.from.y}, {beam.to.x, beam.to.y}, beam.hit});
    }
    for (std::size_t k = 0; k < robot.description->segments.size(); ++k) {
      drawn.segments.push_back(simulation.segment(r, k).pose);
    }
    view.robots.push_back(std::move(drawn));
  }
  for (std::size_t i = 0; i < simulation.world().boxes.size(); ++i) {
    view.boxes.push_back(simulation.box(i));
  }
  view.subtitles = {"end"};
  view.path_period_s = tracks.period_s();
  picture::save_top_view(view, file, {600, 0});
}

}  // namespace

// Collected and pushed boxes, moving ones, chargers, segments, teams, collisions, beams.
TEST_CASE("The picture from a recording alone is that of the run itself, byte for byte") {
  for (const char* name :
       {"four_resources.xml", "pushing.xml", "clutter_moving.xml", "train.xml", "recharge.xml",
        "ten_robots.xml", "nested.xml", "drives.xml", "khepera.xml"}) {
    INFO(name);
    McapFile file;
    TemporaryFile own, replayed;
    const std::string own_png = own.path.string() + ".png";
    const std::string replayed_png = replayed.path.string() + ".png";
    Simulation simulation(shipped_world(name, 12.34), shipped(),
                          {.cameras = render::world_cameras});
    traces::TrackRecorder tracks;
    {
      recording::McapRecorder recorder(file.path);
      simulation::Observer* const observers[] = {&tracks, &recorder};
      simulation.run(observers);
    }
    draw(simulation, tracks, own_png);
    recording::save_picture(recording::read_recorded_run(file.path), shipped(), {"end"},
                            replayed_png, {600, 0});
    CHECK(bytes_of(own_png).size() > 5000);
    const bool same = bytes_of(own_png) == bytes_of(replayed_png);
    CHECK(same);
    std::filesystem::remove(own_png);
    std::filesystem::remove(replayed_png);
  }
}

TEST_CASE("A robot that was put elsewhere is drawn without a line to there, from a recording too") {
  McapFile file;
  Simulation simulation(shipped_world("open_arena.xml", 4), shipped());
  traces::TrackRecorder tracks;
  {
    recording::McapRecorder recorder(file.path);
    simulation::Observer* const observers[] = {&tracks, &recorder};
    const simulation::TimedChange changes[] = {{2.0, {"robot[r1]/@x", "-1.5"}}};
    simulation.run(observers, changes);
  }
  const auto run = recording::read_recorded_run(file.path);
  REQUIRE(!tracks.tracks()[0].placed.empty());
  CHECK(run.robots[0].placed == tracks.tracks()[0].placed);
  CHECK(run.robots[0].path == tracks.tracks()[0].path);
}
