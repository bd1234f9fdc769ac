#include "elsie/recording/run_picture.h"

#include <utility>
#include <vector>

#include "elsie/simulation/fault.h"

namespace elsie::recording {
namespace {

/// The sketches of a robot or of measures. The picture is no part of the run: if a plugin fails to
/// draw, it lacks these sketches.
template <class List>
std::vector<Sketch> sketches_of(const List& list,
                                const std::function<void(const std::string&)>& warn) {
  std::vector<Sketch> sketches;
  try {
    for (simulation::PluginSketch& each : list()) sketches.push_back(std::move(each.sketch));
  } catch (const simulation::PluginFault& fault) {
    warn(std::string("the picture lacks sketches: ") + fault.what());
  }
  return sketches;
}

picture::RobotTrack track_of(const simulation::Simulation& simulation, std::size_t i,
                             const traces::TrackRecorder* tracks) {
  const simulation::RobotView robot = simulation.robot(i);
  picture::RobotTrack track;
  track.id = robot.description->id;
  track.now = robot.pose;
  if (robot.description->localisation) track.believed = robot.state->pose;
  for (std::size_t k = 0; k < simulation.segments(i); ++k) {
    track.segments.push_back(simulation.segment(i, k).pose);
  }
  for (std::size_t k = 0; k < simulation.actuators(i); ++k) {
    const simulation::ActuatorView actuator = simulation.actuator(i, k);
    const Vector3& place = actuator.frame.origin;
    if (actuator.shine) track.lights.push_back({{place.x, place.y}, *actuator.shine});
  }
  if (tracks) {
    const traces::Track& driven = tracks->tracks()[i];
    track.path = driven.path;
    track.touches = driven.touches;
    track.placed = driven.placed;
    track.from_s = driven.from_s;
    track.believed_path = driven.believed;
  }
  return track;
}

}  // namespace

picture::TopView view_of(const simulation::Simulation& simulation,
                         const traces::TrackRecorder* tracks,
                         const std::function<void(const std::string&)>& warn) {
  picture::TopView view{simulation.world()};
  for (std::size_t i = 0; i < simulation.robots(); ++i) {
    view.robots.push_back(track_of(simulation, i, tracks));
    view.robots.back().sketches = sketches_of([&] { return simulation.sketches(i); }, warn);
  }
  view.sketches = sketches_of([&] { return simulation.sketches(); }, warn);
  for (std::size_t i = 0; i < simulation.world().obstacles.size(); ++i) {
    view.boxes.push_back(simulation.obstacle(i));
  }
  for (std::size_t i = 0; i < simulation.fields(); ++i) {
    view.fields.push_back(picture::floor_field(simulation.field(i), picture::kMostFieldTiles));
  }
  view.path_period_s = tracks ? tracks->period_s() : 0.0;
  return view;
}

}  // namespace elsie::recording
