#include "history.h"

#include <algorithm>
#include <map>
#include <utility>

namespace elsie::server {
namespace {

std::size_t bytes_of(const History::Sample& sample) {
  return sizeof(sample) + sample.bodies.size() * sizeof(snapshots::BodyState);
}

}  // namespace

void History::begin(std::vector<std::string> names) {
  samples_.clear();
  bytes_ = 0;
  sampling_ = traces::Sampling(kPeriod_s);
  sampling_.is_due(0.0);
  names_ = std::make_shared<const std::vector<std::string>>(std::move(names));
}

void History::rename(std::vector<std::string> names) {
  if (!names_ || names != *names_) {
    names_ = std::make_shared<const std::vector<std::string>>(std::move(names));
  }
}

void History::add(double time_s, std::uint64_t steps, std::vector<snapshots::BodyState> bodies) {
  bodies.shrink_to_fit();
  samples_.push_back({time_s, steps, names_, std::move(bodies)});
  bytes_ += bytes_of(samples_.back());
  if (bytes_ > most_ && samples_.size() > 2) {
    thin_out();
  }
}

void History::thin_out() {
  const double now_s = samples_.back().time_s;
  bytes_ = 0;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < samples_.size(); i += 2, ++kept) {
    if (i != kept) {
      samples_[kept] = std::move(samples_[i]);
    }
    bytes_ += bytes_of(samples_[kept]);
  }
  samples_.resize(kept);
  sampling_ = traces::Sampling(2.0 * sampling_.period_s());
  sampling_.is_due(now_s);
}

History::Sample History::at(double time_s) const {
  auto found =
      std::lower_bound(samples_.begin(), samples_.end(), time_s,
                       [](const Sample& sample, double time) { return sample.time_s < time; });
  if (found == samples_.end() ||
      (found != samples_.begin() && time_s - (found - 1)->time_s < found->time_s - time_s)) {
    --found;
  }
  if (found->names == names_) {
    return *found;
  }
  std::map<std::string, std::size_t> known;
  for (std::size_t i = 0; i < found->names->size(); ++i) {
    known.emplace((*found->names)[i], i);
  }
  Sample sample{found->time_s, found->steps, names_, {}};
  for (const std::string& name : *names_) {
    const auto place = known.find(name);
    snapshots::BodyState gone = snapshots::BodyState::of({});
    gone.present = 0.0F;
    sample.bodies.push_back(place != known.end() && place->second < found->bodies.size()
                                ? found->bodies[place->second]
                                : gone);
  }
  return sample;
}

}  // namespace elsie::server
