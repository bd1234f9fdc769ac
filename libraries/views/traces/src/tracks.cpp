#include "elsie/traces/tracks.h"

#include <utility>

namespace elsie::traces {

void TrackRecorder::started(const simulation::Simulation& simulation) {
  const double step = simulation.world().physics.step;
  sampling_ = Sampling(static_cast<double>(steps_in(asked_period_s_, step)) * step);
  places_.clear();
  tracks_.clear();
  collisions_.clear();
  was_placed_.clear();
  replaced(simulation);
  events_ = simulation.events().size();
  sampling_.is_due(simulation.time_s());
  sample(simulation);
}

void TrackRecorder::stepped(const simulation::Simulation& simulation) {
  note_placements(simulation);
  if (sampling_.is_due(simulation.time_s())) {
    sample(simulation);
  }
  for (std::size_t i = 0; i < simulation.robots(); ++i) {
    const simulation::RobotView robot = simulation.robot(i);
    if (robot.collisions != collisions_[i]) {
      collisions_[i] = robot.collisions;
      tracks_[i].touches.push_back({robot.pose.x, robot.pose.y});
    }
  }
}

void TrackRecorder::replaced(const simulation::Simulation& simulation) {
  const std::unordered_map<std::string, std::size_t> places = std::exchange(places_, {});
  std::vector<Track> tracks = std::exchange(tracks_, {});
  const std::vector<int> collisions = std::exchange(collisions_, {});
  const std::vector<bool> was_placed = std::exchange(was_placed_, {});
  for (std::size_t i = 0; i < simulation.robots(); ++i) {
    const std::string& id = simulation.robot(i).description->id;
    places_.emplace(id, i);
    const auto known = places.find(id);
    const bool is_new = known == places.end();
    tracks_.push_back(is_new ? Track() : std::move(tracks[known->second]));
    collisions_.push_back(is_new ? 0 : collisions[known->second]);
    was_placed_.push_back(!is_new && was_placed[known->second]);
  }
}

void TrackRecorder::sample(const simulation::Simulation& simulation) {
  for (std::size_t i = 0; i < simulation.robots(); ++i) {
    Track& track = tracks_[i];
    if (track.path.empty()) {
      track.from_s = sampling_.last_s();
    }
    if (was_placed_[i]) {
      track.placed.push_back(track.path.size());
      was_placed_[i] = false;
    }
    const simulation::RobotView robot = simulation.robot(i);
    if (robot.description->localisation) track.believed.push_back(robot.state->pose);
    track.path.push_back(robot.pose);
  }
}

void TrackRecorder::note_placements(const simulation::Simulation& simulation) {
  see_placements(simulation, events_, [this](const simulation::EventRecord& event) {
    const auto moved = places_.find(event.robot);
    if (moved != places_.end() && !tracks_[moved->second].path.empty()) {
      was_placed_[moved->second] = true;
    }
  });
}

}  // namespace elsie::traces
