#include "elsie/testing/sensor.h"

#include <algorithm>
#include <cmath>

#include "made.h"

namespace elsie::testing {
namespace {

constexpr double kSensorPeriod = 0.01;  // s

}  // namespace

Sensor::Sensor(const std::string& name, const Settings& settings, const Elements& elements)
    : Sensor(Plugins::found(), name, settings, elements) {}

Sensor::Sensor(const Plugins& plugins, const std::string& name, const Settings& settings,
               const Elements& elements)
    : plugins_(plugins),
      declaration_(&plugins_.declaration(PluginKind::sensor, name)),
      random_(1),
      object_(make<elsie::Sensor>(plugins_, *declaration_, settings, elements,
                                  [](elsie::Sensor&) {})) {}

Sensor& Sensor::mounted(const Mounting& mounting) {
  mounting_ = mounting;
  return *this;
}

Sensor& Sensor::turned(double yaw_deg, double pitch_deg) {
  mounting_.azimuth_rad = wrap_angle(radians(yaw_deg));
  mounting_.pitch_rad = radians(pitch_deg);
  return *this;
}

Frame Sensor::frame_at(const Pose& pose) const {
  const Frame robot = Frame::turned({pose.x, pose.y, 0.0}, pose.heading_rad, 0.0);
  return robot.frame(Frame::turned(mounting_.position, mounting_.azimuth_rad, mounting_.pitch_rad));
}

void Sensor::update(const Surroundings& surroundings, const Image* picture) {
  const auto camera = object_->camera();
  if (camera && !picture) {
    picture_ = surroundings.photograph(frame_at(surroundings.pose()), *camera);
    picture = &picture_;
  }
  update(static_cast<const elsie::Surroundings&>(surroundings), picture);
}

void Sensor::update(const elsie::Surroundings& surroundings, const Image* picture) {
  const auto colours = surroundings.resource_colours();
  if (!colours_ ||
      !std::equal(colours_->begin(), colours_->end(), colours.begin(), colours.end())) {
    equip(surroundings);
  }
  if (!reset_) {
    reset();
  }
  SensorContext now;
  now.time_s = time_s_;
  now.period_s = kSensorPeriod;
  now.frame = frame_at(surroundings.pose());
  now.mounting = &mounting_;
  now.world = &surroundings;
  now.random = &random_;
  now.image = picture;
  object_->update(now);
  time_s_ += kSensorPeriod;
}

void Sensor::equip(const elsie::Surroundings& surroundings) {
  const auto colours = surroundings.resource_colours();
  colours_.emplace(colours.begin(), colours.end());
  object_->equipped({&mounting_, *colours_});
  object_->fit_value();
}

std::vector<NamedValue> Sensor::values() const {
  std::vector<NamedValue> values;
  object_->visit_fields(object_->reading(), [&](const ReadingField& field) {
    for (std::size_t i = 0; field.is_number() && i < field.count; ++i) {
      values.push_back({field.column(i), field.number(i)});
    }
  });
  return values;
}

void Sensor::reset(std::uint64_t seed) {
  seed_ = seed;
  random_ = Random(seed);
  time_s_ = 0.0;
  object_->forget();
  object_->reset(random_);
  reset_ = true;
}

bool Sensor::take_over(Sensor& before) {
  reset(before.seed_);
  random_ = before.random_;
  time_s_ = before.time_s_;
  return hand_over(*before.object_, *object_);
}

void Sensor::require(const ReadingKind& kind) const {
  require_kind(object_->kind(), kind, "sensor '" + declaration_->name + "' makes readings");
}

}  // namespace elsie::testing
