#include "robot/disturbed_reading.h"

#include <limits>
#include <optional>
#include <stdexcept>
#include <variant>

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
  std::vector<std::string> names;
  sensor.visit_fields(sensor.reading(), [&](const ReadingField& field) {
    const auto fault = fault_of(field);
    if (!fault) {
      if (field.item == 0) names.push_back(field.path());
    } else if (field.path() == noise.on) {
      throw std::invalid_argument("its <noise on=\"" + noise.on + "\"> names a field that " +
                                  *fault);
    }
  });
  Disturbances::check(noise, names, "its reading");
}

}  // namespace

void DisturbedReading::check(const Sensor& sensor) {
  for (const Disturbance& each : sensor.disturbances()) {
    if (const auto* noise = std::get_if<Noise>(&each)) check_noise(*noise, sensor);
  }
}

void DisturbedReading::fit(const Sensor& sensor, bool has_other_sizes) {
  disturbances_.fit(sensor.disturbances());
  fields_.clear();
  for (const Noise& noise : disturbances_.noises()) {
    std::vector<std::size_t>& fields = fields_.emplace_back();
    std::size_t place = 0;
    sensor.visit_fields(sensor.reading(), [&](const ReadingField& field) {
      if (field.path() == noise.on) fields.push_back(place);
      ++place;
    });
  }
  if (has_other_sizes) {
    samples_.clear();
    spare_.clear();
  }
}

void DisturbedReading::reset(std::uint64_t seed, const std::string& path) {
  disturbances_.reset(seed, path);
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
  const bool is_missed = disturbances_.misses_update();
  const double slack = 1e-6 * period_s;
  if (disturbances_.is_stuck(time_s + slack)) {
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
  while (!samples_.empty() &&
         samples_.front().time_s <= time_s - disturbances_.latency_s() + slack) {
    Sample& seen = samples_.front();
    sensor.copy_reading(seen.reading.get(), sensor.own_reading());
    age_s_ = time_s - seen.time_s;
    spare_.push_back(std::move(seen.reading));
    samples_.pop_front();
  }
}

void DisturbedReading::add_noise(Sensor& sensor, const void* reading) {
  for (std::size_t noise = 0; noise < fields_.size(); ++noise) {
    const std::vector<std::size_t>& fields = fields_[noise];
    std::size_t place = 0;
    std::size_t next = 0;
    sensor.visit_fields(reading, [&](const ReadingField& field) {
      if (next == fields.size() || place++ != fields[next]) return;
      ++next;
      for (std::size_t i = 0; i < field.count; ++i) {
        field.set_number(i, disturbances_.disturbed(noise, field.number(i)));
      }
    });
  }
}

}  // namespace elsie::simulation
