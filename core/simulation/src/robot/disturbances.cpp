#include "robot/disturbances.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <variant>

#include "elsie/base/error.h"
#include "elsie/base/near_name.h"

namespace elsie::simulation {

void Disturbances::check(const Noise& noise, const std::vector<std::string>& names,
                         const std::string& owner) {
  const std::string what = "its <noise on=\"" + noise.on + "\"> ";
  if (std::find(names.begin(), names.end(), noise.on) == names.end()) {
    throw std::invalid_argument(what + "names no number of " + owner +
                                (names.empty()
                                     ? "; there are none"
                                     : base::near_or_all("'" + noise.on + "'", names, "it has")));
  }
  const bool is_limited = noise.clamp.size() == 2 && noise.clamp[0] <= noise.clamp[1];
  if (!noise.clamp.empty() && !is_limited) {
    throw std::invalid_argument(
        what + "has a clamp that is no range; expected two numbers, the lower one first");
  }
}

void Disturbances::fit(std::span<const Disturbance> all) {
  noises_.clear();
  failures_.clear();
  latency_s_ = 0.0;
  stuck_from_s_ = std::numeric_limits<double>::infinity();
  for (const Disturbance& each : all) {
    if (const auto* noise = std::get_if<Noise>(&each)) {
      noises_.push_back(*noise);
    } else {
      const auto& failure = failures_.emplace_back(std::get<UpdateFailure>(each));
      latency_s_ += failure.latency;
      if (failure.stuck_from >= 0.0) stuck_from_s_ = std::min(stuck_from_s_, failure.stuck_from);
    }
  }
  begin_all();
}

void Disturbances::reset(std::uint64_t seed, const std::string& path) {
  seed_ = seed;
  path_ = path;
  noise_streams_.clear();
  failure_streams_.clear();
  begin_all();
}

void Disturbances::begin_all() {
  begin(noise_streams_, "noise", noises_.size());
  begin(failure_streams_, "failure", failures_.size());
}

void Disturbances::begin(std::vector<Random>& streams, const char* element,
                         std::size_t count) const {
  while (streams.size() < count) {
    streams.emplace_back(seed_,
                         path_ + "/" + element + "[" + std::to_string(streams.size() + 1) + "]");
  }
}

double Disturbances::disturbed(std::size_t index, double value) {
  const Noise& noise = noises_[index];
  Random& random = noise_streams_[index];
  value = value * noise.scale + noise.bias;
  if (noise.proportional > 0.0 || noise.gaussian > 0.0 || noise.uniform > 0.0) {
    // All are drawn, so that one of them more does not change the others.
    const double part = random.normal(), normal = random.normal(), even = random.uniform(-1.0, 1.0);
    value += value * noise.proportional * part + noise.gaussian * normal + noise.uniform * even;
  }
  if (noise.resolution > 0.0) value = std::round(value / noise.resolution) * noise.resolution;
  if (!noise.clamp.empty()) value = std::clamp(value, noise.clamp[0], noise.clamp[1]);
  if (!std::isfinite(value)) {
    throw base::Error("its <noise on=\"" + noise.on + "\"> makes a number that is not finite");
  }
  return value;
}

bool Disturbances::misses_update() {
  bool is_missed = false;
  for (std::size_t i = 0; i < failures_.size(); ++i) {
    // Always drawn, so that one update missed more does not change the others.
    is_missed |= failure_streams_[i].chance(failures_[i].dropout);
  }
  return is_missed;
}

}  // namespace elsie::simulation
