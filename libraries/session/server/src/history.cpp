#include "history.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace elsie::server {

void History::begin(std::vector<std::string> names, double period_s) {
  samples_.begin(period_s);
  names_ = share(std::move(names));
}

void History::rename(std::vector<std::string> names) {
  if (!names_ || names != names_->names()) {
    names_ = share(std::move(names));
  }
}

void History::add(double time_s, std::uint64_t steps, std::vector<snapshots::BodyState> bodies) {
  bodies.shrink_to_fit();
  samples_.add({time_s, steps, names_, std::move(bodies)});
}

History::Sample History::at(double time_s) const {
  const std::vector<Sample>& all = samples_.all();
  auto found =
      std::lower_bound(all.begin(), all.end(), time_s,
                       [](const Sample& sample, double time) { return sample.time_s < time; });
  if (found == all.end() ||
      (found != all.begin() && time_s - (found - 1)->time_s < found->time_s - time_s)) {
    --found;
  }
  if (found->names == names_) {
    return *found;
  }
  Sample sample{found->time_s, found->steps, names_, {}};
  for (const std::size_t place : found->names->places_of(names_->names())) {
    snapshots::BodyState gone = snapshots::BodyState::of({});
    gone.present = 0.0F;
    sample.bodies.push_back(place < found->bodies.size() ? found->bodies[place] : gone);
  }
  return sample;
}

std::vector<History::Path> History::paths(std::span<const std::string> names,
                                          std::span<const Sample> samples) {
  constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();
  const std::vector<float> nowhere(samples.size(), kNowhere);
  std::vector<Path> paths(names.size(), {nowhere, nowhere});
  visit_places(names, samples, [&](std::size_t i, std::size_t k, std::size_t place) {
    const std::vector<snapshots::BodyState>& bodies = samples[k].bodies;
    if (place < bodies.size() && bodies[place].present != 0.0F) {
      paths[i].x[k] = bodies[place].origin[0];
      paths[i].y[k] = bodies[place].origin[1];
    }
  });
  return paths;
}

}  // namespace elsie::server
