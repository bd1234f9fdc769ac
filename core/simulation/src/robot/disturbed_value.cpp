#include "robot/disturbed_value.h"

#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

namespace elsie::simulation {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Why a noise cannot apply to this field; none: it can.
std::optional<std::string> fault_of(const ReadingField& field, const std::string& what) {
  if (field.type == FieldType::boolean) return "is true or false, and no number";
  if (!field.is_number()) return "is a picture, and no number";
  if (!field.is_stored) return "is computed by visit(), and not stored in the " + what;
  return std::nullopt;
}

void check_noise(const Noise& noise, const Disturbable& object, std::vector<std::string> names) {
  const std::string what = object.value_name();
  const std::string owner = "its " + what + (names.empty() ? "" : " or of what it hears");
  object.visit_fields(object.value(), [&](const ReadingField& field) {
    const auto fault = fault_of(field, what);
    if (!fault) {
      if (field.item == 0) names.push_back(field.path());
    } else if (field.path() == noise.on) {
      throw std::invalid_argument("its <noise on=\"" + noise.on + "\"> names a field that " +
                                  *fault);
    }
  });
  Disturbances::check(noise, names, owner);
}

}  // namespace

void DisturbedValue::check(const Disturbable& object, const std::vector<std::string>& others) {
  for (const Disturbance& each : object.disturbances()) {
    if (const auto* noise = std::get_if<Noise>(&each)) check_noise(*noise, object, others);
  }
}

void DisturbedValue::fit(const Disturbable& object, bool has_other_sizes) {
  disturbances_.fit(object.disturbances());
  fields_.clear();
  for (const Noise& noise : disturbances_.noises()) {
    std::vector<std::size_t>& fields = fields_.emplace_back();
    std::size_t place = 0;
    object.visit_fields(object.value(), [&](const ReadingField& field) {
      if (field.path() == noise.on) fields.push_back(place);
      ++place;
    });
  }
  if (has_other_sizes) {
    samples_.clear();
    spare_.clear();
  }
}

void DisturbedValue::reset(std::uint64_t seed, const std::string& path) {
  disturbances_.reset(seed, path);
  samples_.clear();
  age_s_ = kNever;
}

double DisturbedValue::disturbed(std::string_view name, double value) {
  const std::vector<Noise>& noises = disturbances_.noises();
  for (std::size_t i = 0; i < noises.size(); ++i) {
    if (noises[i].on == name) value = disturbances_.disturbed(i, value);
  }
  return value;
}

std::shared_ptr<void> DisturbedValue::memory(const Disturbable& object) {
  if (spare_.empty()) return object.new_value();
  auto taken = std::move(spare_.back());
  spare_.pop_back();
  return taken;
}

void DisturbedValue::renew(const Disturbable& object, bool fits) {
  spare_.clear();
  if (!fits) samples_.clear();
  for (Sample& sample : samples_) {
    const auto before = std::exchange(sample.value, object.new_value());
    object.copy_value(before.get(), sample.value.get());
  }
}

bool DisturbedValue::update(Disturbable& object, double time_s, double period_s, bool is_new) {
  const bool is_missed = disturbances_.misses_update();
  const double slack = 1e-6 * period_s;
  if (disturbances_.is_stuck(time_s + slack)) {
    age_s_ += period_s;
    return false;
  }
  samples_.push_back({time_s, memory(object), is_new});
  object.copy_value(object.undisturbed(), samples_.back().value.get());
  add_noise(object, samples_.back().value.get());
  if (is_missed) {
    spare_.push_back(std::move(samples_.back().value));
    samples_.pop_back();
  }
  age_s_ += period_s;
  bool has_arrived = false;
  while (!samples_.empty() &&
         samples_.front().time_s <= time_s - disturbances_.latency_s() + slack) {
    Sample& seen = samples_.front();
    object.copy_value(seen.value.get(), object.own_value());
    age_s_ = time_s - seen.time_s;
    has_arrived = has_arrived || seen.is_new;
    spare_.push_back(std::move(seen.value));
    samples_.pop_front();
  }
  return has_arrived;
}

void DisturbedValue::add_noise(Disturbable& object, const void* value) {
  for (std::size_t noise = 0; noise < fields_.size(); ++noise) {
    const std::vector<std::size_t>& fields = fields_[noise];
    std::size_t place = 0;
    std::size_t next = 0;
    object.visit_fields(value, [&](const ReadingField& field) {
      if (next == fields.size() || place++ != fields[next]) return;
      ++next;
      for (std::size_t i = 0; i < field.count; ++i) {
        field.set_number(i, disturbances_.disturbed(noise, field.number(i)));
      }
    });
  }
}

}  // namespace elsie::simulation
