#include "robot/disturbed_reading.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <variant>

#include "elsie/base/near_name.h"
#include "elsie/base/number_text.h"
#include "elsie/base/words.h"

namespace elsie::simulation {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Why a noise cannot apply to this field; none: it can.
std::optional<std::string> fault_of(const ReadingField& field) {
  if (field.type == FieldType::boolean) return "is true or false, and no number";
  if (!field.is_number()) return "is a picture, and no number";
  if (!field.is_stored) return "is computed by visit(), and not stored in the reading";
  return std::nullopt;
}

void check_noise(const Noise& noise, const Sensor& sensor) {
  const std::string what = "its <noise on=\"" + noise.on + "\"> ";
  std::vector<std::string> names;
  bool found = false;
  sensor.visit_fields(sensor.reading(), [&](const ReadingField& field) {
    const std::string path = field.path();
    const auto fault = fault_of(field);
    if (path == noise.on) {
      found = true;
      if (fault) throw std::invalid_argument(what + "names a field that " + *fault);
    } else if (!fault && field.item == 0) {
      names.push_back(path);
    }
  });
  if (!found) {
    throw std::invalid_argument(what + "names no field of its reading" +
                                (names.empty()
                                     ? "; its reading lists no numbers"
                                     : base::near_or_all("'" + noise.on + "'", names, "it has")));
  }
  const bool is_limited = noise.clamp.size() == 2 && noise.clamp[0] <= noise.clamp[1];
  if (!noise.clamp.empty() && !is_limited) {
    throw std::invalid_argument(
        what + "has a clamp that is no range; expected two numbers, the lower one first");
  }
}

}  // namespace

void DisturbedReading::check(const Sensor& sensor) {
  for (const Disturbance& each : sensor.disturbances()) {
    if (const auto* noise = std::get_if<Noise>(&each)) check_noise(*noise, sensor);
  }
}

void DisturbedReading::fit(const Sensor& sensor, bool has_other_sizes) {
  noises_.clear();
  failures_.clear();
  latency_s_ = 0.0;
  stuck_from_s_ = kNever;
  for (const Disturbance& each : sensor.disturbances()) {
    if (const auto* noise = std::get_if<Noise>(&each)) {
      Target& target = noises_.emplace_back(Target{*noise, {}});
      std::size_t place = 0;
      sensor.visit_fields(sensor.reading(), [&](const ReadingField& field) {
        if (field.path() == noise->on) target.fields.push_back(place);
        ++place;
      });
    } else {
      const auto& failure = failures_.emplace_back(std::get<UpdateFailure>(each));
      latency_s_ += failure.latency;
      if (failure.stuck_from >= 0.0) stuck_from_s_ = std::min(stuck_from_s_, failure.stuck_from);
    }
  }
  begin(noise_streams_, "noise", noises_.size());
  begin(failure_streams_, "failure", failures_.size());
  if (has_other_sizes) {
    samples_.clear();
    spare_.clear();
  }
}

void DisturbedReading::begin(std::vector<Random>& streams, const char* element,
                             std::size_t count) const {
  while (streams.size() < count) {
    streams.emplace_back(seed_,
                         path_ + "/" + element + "[" + std::to_string(streams.size() + 1) + "]");
  }
}

void DisturbedReading::reset(std::uint64_t seed, const std::string& path) {
  seed_ = seed;
  path_ = path;
  noise_streams_.clear();
  failure_streams_.clear();
  begin(noise_streams_, "noise", noises_.size());
  begin(failure_streams_, "failure", failures_.size());
  samples_.clear();
  age_s_ = kNever;
}

std::shared_ptr<void> DisturbedReading::memory(const Sensor& sensor) {
  if (spare_.empty()) return sensor.new_reading();
  auto taken = std::move(spare_.back());
  spare_.pop_back();
  return taken;
}

void DisturbedReading::update(Sensor& sensor, double time_s, double period_s) {
  bool is_missed = false;
  for (std::size_t i = 0; i < failures_.size(); ++i) {
    // Always drawn, so that one update missed more does not change the others.
    is_missed |= failure_streams_[i].chance(failures_[i].dropout);
  }
  const double slack = 1e-6 * period_s;
  if (time_s >= stuck_from_s_ - slack) {
    age_s_ += period_s;
    return;
  }
  samples_.push_back({time_s, memory(sensor)});
  sensor.copy_reading(sensor.measured(), samples_.back().reading.get());
  add_noise(sensor, samples_.back().reading.get());
  if (is_missed) {
    spare_.push_back(std::move(samples_.back().reading));
    samples_.pop_back();
  }
  age_s_ += period_s;
  while (!samples_.empty() && samples_.front().time_s <= time_s - latency_s_ + slack) {
    Sample& seen = samples_.front();
    sensor.copy_reading(seen.reading.get(), sensor.own_reading());
    age_s_ = time_s - seen.time_s;
    spare_.push_back(std::move(seen.reading));
    samples_.pop_front();
  }
}

void DisturbedReading::add_noise(Sensor& sensor, const void* reading) {
  for (std::size_t k = 0; k < noises_.size(); ++k) {
    const Noise& noise = noises_[k].noise;
    const std::vector<std::size_t>& fields = noises_[k].fields;
    Random& random = noise_streams_[k];
    std::size_t place = 0;
    std::size_t next = 0;
    sensor.visit_fields(reading, [&](const ReadingField& field) {
      if (next == fields.size() || place++ != fields[next]) return;
      ++next;
      for (std::size_t i = 0; i < field.count; ++i) {
        double value = field.number(i) * noise.scale + noise.bias;
        if (noise.proportional > 0.0) value += value * random.normal(0.0, noise.proportional);
        if (noise.gaussian > 0.0) value += random.normal(0.0, noise.gaussian);
        if (noise.uniform > 0.0) value += random.uniform(-noise.uniform, noise.uniform);
        if (noise.resolution > 0.0) {
          value = std::round(value / noise.resolution) * noise.resolution;
        }
        if (!noise.clamp.empty()) value = std::clamp(value, noise.clamp[0], noise.clamp[1]);
        field.set_number(i, value);
      }
    });
  }
}

}  // namespace elsie::simulation
