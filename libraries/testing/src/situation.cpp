#include "elsie/testing/situation.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

namespace elsie::testing {

Situation& Situation::beam(double azimuth_deg, double distance_m, double max_range_m) {
  return reading(RangeReading{distance_m, max_range_m, distance_m < max_range_m}, azimuth_deg);
}

Situation& Situation::proximity(double azimuth_deg, bool detected, double max_range_m) {
  return reading(ProximityReading{detected, max_range_m}, azimuth_deg);
}

Situation& Situation::blob(double column, double horizontal_fov_deg, double area_px,
                           double azimuth_deg, const Colour& colour) {
  VisionReading view;
  view.found = true;
  view.column = column;
  view.row = 50.0;
  view.area_px = area_px;
  view.horizontal_fov_rad = radians(horizontal_fov_deg);
  view.raw =
      Picture().disc(column, view.row, std::sqrt(area_px / std::numbers::pi), colour).image();
  view.processed = mask_of(view.raw, colour);
  return reading(std::move(view), azimuth_deg);
}

Situation& Situation::camera(double horizontal_fov_deg, double azimuth_deg) {
  VisionReading view;
  view.horizontal_fov_rad = radians(horizontal_fov_deg);
  view.raw = Picture().image();
  view.processed = mask_of(view.raw, kRed);
  return reading(std::move(view), azimuth_deg);
}

Situation& Situation::view(const VisionReading& reading, double azimuth_deg) {
  return this->reading(reading, azimuth_deg);
}

Situation& Situation::sensed(const ReadingKind& kind, std::shared_ptr<const void> value,
                             const Mounting& mounting, std::string sensor,
                             const ReadingDeclaration* declaration) {
  if (sensor.empty()) {
    const auto before = std::count_if(entries_.begin(), entries_.end(),
                                      [&](const Entry& entry) { return entry.kind == kind; });
    sensor = kind.name + std::to_string(before + 1);
  }
  Mounting at = mounting;
  at.azimuth_rad = wrap_angle(at.azimuth_rad);
  entries_.push_back({kind, std::move(value), at, std::move(sensor), declaration});
  return *this;
}

Situation& Situation::clear_readings() {
  entries_.clear();
  return *this;
}

Situation& Situation::at(double x, double y, double heading_deg) {
  self.pose = {x, y, wrap_angle(radians(heading_deg))};
  return *this;
}

Situation& Situation::moving(double speed_m_s, double turn_rate_rad_s) {
  self.moving = {speed_m_s, 0.0, turn_rate_rad_s};
  return *this;
}

Situation& Situation::battery(double part) {
  self.energy = part * self.capacity;
  return *this;
}

Situation& Situation::charging(bool is_charging) {
  self.charging = is_charging;
  return *this;
}

Situation& Situation::mate(const std::string& id, double x, double y, bool is_leader,
                           double heading_deg, int team_index) {
  mates_.push_back({id, {x, y, wrap_angle(radians(heading_deg))}, is_leader, team_index});
  return *this;
}

Situation& Situation::leader(double x, double y, double heading_deg) {
  return mate("leader", x, y, true, heading_deg);
}

Situation& Situation::nest(double x, double y, double radius_m) {
  team.nest = NestView{{x, y}, radius_m};
  return *this;
}

Situation& Situation::charger(double x, double y) {
  team.charger = Vector2{x, y};
  return *this;
}

Situation& Situation::hear(std::shared_ptr<const AnyMessage> message, const std::string& from,
                           double distance_m, double bearing_deg) {
  HeardMessage heard;
  heard.message = std::move(message);
  heard.from = from;
  heard.distance_m = distance_m;
  heard.bearing_rad = radians(bearing_deg);
  heard.elevation_rad = std::isnan(distance_m) ? kUnknown : 0.0;
  return hear(heard);
}

Situation& Situation::hear(const HeardMessage& heard) {
  said_.push_back({heard, std::string(heard.device), std::string(heard.from)});
  return *this;
}

Situation& Situation::event(const std::string& name) {
  events_.push_back(name);
  return *this;
}

Situation& Situation::time(double time_s) {
  data_.time_s = time_s;
  return *this;
}

Situation& Situation::period(double period_s) {
  data_.period_s = period_s;
  return *this;
}

Situation& Situation::seed(std::uint64_t seed) {
  random = Random(seed);
  return *this;
}

Perception Situation::perception() const {
  Views& v = views_;
  v.sensed.clear();
  v.groups.clear();
  v.mates.clear();
  v.events.clear();
  v.sensed.reserve(entries_.size());  // so that views of it remain valid
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const ReadingKind& kind = entries_[i].kind;
    const auto is_of_kind = [&](const Entry& entry) { return entry.kind == kind; };
    const auto here = entries_.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find_if(entries_.begin(), here, is_of_kind) != here) {
      continue;
    }
    const std::size_t first = v.sensed.size();
    for (auto entry = here; entry != entries_.end(); ++entry) {
      if (is_of_kind(*entry)) {
        v.sensed.push_back({entry->value.get(), &entry->mounting, entry->sensor.c_str()});
      }
    }
    v.groups.push_back({kind, std::span(v.sensed).subspan(first), here->declaration});
  }
  for (const Mate& mate : mates_) {
    v.mates.push_back({mate.id, mate.pose, distance(self.pose, mate.pose),
                       bearing(self.pose, mate.pose.x, mate.pose.y), mate.is_leader,
                       mate.team_index});
  }
  for (const std::string& event : events_) {
    v.events.push_back({event});
  }
  v.team = team;
  v.team.mates = v.mates;
  v.data = data_;
  v.data.events = v.events;
  v.heard.clear();
  for (const Said& said : said_) {
    v.heard.push_back(said.message);
    v.heard.back().device = said.device;
    v.heard.back().from = said.from;
  }
  v.data.heard = v.heard;
  std::sort(v.listened.begin(), v.listened.end(), [](const ReadingKind& a, const ReadingKind& b) {
    return std::strcmp(a.name, b.name) < 0;
  });
  const auto same = [](const ReadingKind& a, const ReadingKind& b) { return a.has_name_of(b); };
  v.listened.erase(std::unique(v.listened.begin(), v.listened.end(), same), v.listened.end());
  v.data.listened = &v.listened;
  v.data.groups = v.groups;
  v.data.self = &self;
  v.data.team = &v.team;
  return {v.data, random};
}

}  // namespace elsie::testing
