#include "top_view.h"

#include <utility>

#include "elsie/picture/top_view.h"
#include "elsie/recording/beams.h"

namespace elsie::program {

namespace {

std::vector<picture::Beam> beams(const simulation::Simulation& simulation, std::size_t robot) {
  std::vector<picture::Beam> beams;
  for (const auto& beam : recording::range_beams(simulation, robot)) {
    beams.push_back({{beam.from.x, beam.from.y}, {beam.to.x, beam.to.y}, beam.hit});
  }
  return beams;
}

}  // namespace

void draw(const simulation::Simulation& simulation, const traces::TrackRecorder* tracks,
          const std::vector<std::string>& subtitles, const std::filesystem::path& file, int width,
          const picture::PathChoice& paths, bool bare) {
  picture::TopView view{simulation.world()};
  view.bare = bare;
  for (std::size_t i = 0; i < simulation.robots(); ++i) {
    const simulation::RobotView robot = simulation.robot(i);
    picture::RobotTrack track;
    track.id = robot.description->id;
    track.now = robot.pose;
    for (std::size_t k = 0; k < simulation.segments(i); ++k) {
      track.segments.push_back(simulation.segment(i, k).pose);
    }
    track.beams = beams(simulation, i);
    if (tracks) {
      track.path = tracks->tracks()[i].path;
      track.touches = tracks->tracks()[i].touches;
      track.placed = tracks->tracks()[i].placed;
      track.from_s = tracks->tracks()[i].from_s;
    }
    view.robots.push_back(std::move(track));
  }
  for (std::size_t i = 0; i < simulation.world().obstacles.size(); ++i) {
    view.boxes.push_back(simulation.obstacle(i));
  }
  view.subtitles = subtitles;
  view.paths = paths;
  view.path_period_s = tracks ? tracks->period_s() : 0.0;
  picture::save_top_view(view, file, {width, 0});
}

}  // namespace elsie::program
