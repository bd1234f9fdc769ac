#include "perception_inputs.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <vector>

#include <elsie/api/vision.h>
#include <elsie/base/near_name.h>

namespace {

using elsie::Perception;
using Sector = bool (*)(double azimuth_rad);

// Sectors overlap: a beam at half left is both ahead and to the left.
constexpr double kFront = elsie::radians(45.0);
constexpr double kRear = elsie::radians(135.0);
bool anywhere(double) { return true; }
bool ahead(double azimuth) { return std::abs(azimuth) <= kFront; }
bool behind(double azimuth) { return std::abs(azimuth) >= kRear; }
bool to_left(double azimuth) { return azimuth > 0.0 && azimuth < elsie::radians(180.0); }
bool to_right(double azimuth) { return azimuth < 0.0; }
bool left_side(double azimuth) { return azimuth >= kFront && azimuth <= kRear; }
bool right_side(double azimuth) { return azimuth <= -kFront && azimuth >= -kRear; }

template <class Reading, Sector sector>
bool looks(const Perception& example) {
  for (const auto& sensor : example.readings<Reading>()) {
    if (sector(sensor.azimuth_rad())) {
      return true;
    }
  }
  return false;
}

/// The shortest reading in the sector; a beam that hits nothing reads its maximum range.
template <Sector sector>
double range(const Perception& now) {
  double nearest = 0.0;
  bool first = true;
  for (const auto& beam : now.readings<elsie::RangeReading>()) {
    if (sector(beam.azimuth_rad())) {
      nearest = first ? beam->distance_m : std::min(nearest, beam->distance_m);
      first = false;
    }
  }
  return nearest;
}

template <Sector sector>
double proximity(const Perception& now) {
  for (const auto& sensor : now.readings<elsie::ProximityReading>()) {
    if (sector(sensor.azimuth_rad()) && sensor->detected) {
      return 1.0;
    }
  }
  return 0.0;
}

bool has_camera(const Perception& example) {
  return !example.readings<elsie::VisionReading>().empty();
}

// With several cameras, all three inputs are about the same resource, the one that find_resource
// takes.
double resource_seen(const Perception& now) { return elsie::most_nearly_ahead(now) ? 1.0 : 0.0; }

double resource_bearing(const Perception& now) {
  const auto view = elsie::most_nearly_ahead(now);
  return view ? elsie::degrees(elsie::blob_bearing_rad(*view)) : 0.0;
}

double resource_area(const Perception& now) {
  const auto view = elsie::most_nearly_ahead(now);
  return view && (*view)->height > 0 ? (*view)->area_px / (*view)->width / (*view)->height : 0.0;
}

bool always(const Perception&) { return true; }

bool has_charger(const Perception& example) { return example.team().charger.has_value(); }

double leader_distance(const Perception& now) {
  const elsie::TeamMate* leader = now.team().leader();
  return leader ? leader->distance_m : now.self().coverage_m;
}

double leader_bearing(const Perception& now) {
  const elsie::TeamMate* leader = now.team().leader();
  return leader ? elsie::degrees(leader->bearing_rad) : 0.0;
}

double mate_distance(const Perception& now) {
  const auto mates = now.team().mates;
  const auto nearest =
      std::min_element(mates.begin(), mates.end(),
                       [](const auto& a, const auto& b) { return a.distance_m < b.distance_m; });
  return nearest == mates.end() ? now.self().coverage_m : nearest->distance_m;
}

double charger_distance(const Perception& now) {
  const auto& charger = now.team().charger;
  return charger ? std::hypot(charger->x - now.self().pose.x, charger->y - now.self().pose.y) : 0.0;
}

double charger_bearing(const Perception& now) {
  const auto& charger = now.team().charger;
  return charger ? elsie::degrees(elsie::bearing(now.self().pose, charger->x, charger->y)) : 0.0;
}

double battery(const Perception& now) {
  return now.self().capacity > 0.0 ? now.self().energy / now.self().capacity : 0.0;
}

constexpr const char* kBeam = "a beam-range sensor";
constexpr const char* kSwitch = "a proximity sensor";
constexpr const char* kCamera = "a vision sensor";
constexpr const char* kCharger = "a charger of the robot's team in the world";

template <Sector sector>
constexpr PerceptionInput range_input(const char* name, const char* needs) {
  return {name, range<sector>, needs, looks<elsie::RangeReading, sector>};
}
template <Sector sector>
constexpr PerceptionInput proximity_input(const char* name, const char* needs) {
  return {name, proximity<sector>, needs, looks<elsie::ProximityReading, sector>};
}

const std::array kInputs = {
    range_input<anywhere>("nearest_range", kBeam),
    range_input<ahead>("front_range", "a beam-range sensor within 45 degrees of straight ahead"),
    range_input<to_left>("left_range", "a beam-range sensor that looks to the left"),
    range_input<to_right>("right_range", "a beam-range sensor that looks to the right"),
    range_input<left_side>("left_side_range",
                           "a beam-range sensor between 45 and 135 degrees to the left"),
    range_input<right_side>("right_side_range",
                            "a beam-range sensor between 45 and 135 degrees to the right"),
    range_input<behind>("rear_range", "a beam-range sensor 135 degrees or more off straight ahead"),
    proximity_input<anywhere>("proximity", kSwitch),
    proximity_input<ahead>("front_proximity",
                           "a proximity sensor within 45 degrees of straight ahead"),
    proximity_input<to_left>("left_proximity", "a proximity sensor that looks to the left"),
    proximity_input<to_right>("right_proximity", "a proximity sensor that looks to the right"),
    proximity_input<behind>("rear_proximity",
                            "a proximity sensor 135 degrees or more off straight ahead"),
    PerceptionInput{"resource_seen", resource_seen, kCamera, has_camera},
    PerceptionInput{"resource_bearing", resource_bearing, kCamera, has_camera},
    PerceptionInput{"resource_area", resource_area, kCamera, has_camera},
    PerceptionInput{"energy", [](const Perception& now) { return now.self().energy; }, "", always},
    PerceptionInput{"battery", battery, "", always},
    PerceptionInput{"charging",
                    [](const Perception& now) { return now.self().charging ? 1.0 : 0.0; }, "",
                    always},
    PerceptionInput{"charger_distance", charger_distance, kCharger, has_charger},
    PerceptionInput{"charger_bearing", charger_bearing, kCharger, has_charger},
    PerceptionInput{"leader_seen",
                    [](const Perception& now) { return now.team().leader() ? 1.0 : 0.0; }, "",
                    always},
    PerceptionInput{"leader_distance", leader_distance, "", always},
    PerceptionInput{"leader_bearing", leader_bearing, "", always},
    PerceptionInput{
        "mates", [](const Perception& now) { return static_cast<double>(now.team().mates.size()); },
        "", always},
    PerceptionInput{"mate_distance", mate_distance, "", always},
    PerceptionInput{"x", [](const Perception& now) { return now.self().pose.x; }, "", always},
    PerceptionInput{"y", [](const Perception& now) { return now.self().pose.y; }, "", always},
    PerceptionInput{
        "heading",
        [](const Perception& now) { return elsie::degrees(now.self().pose.heading_rad); }, "",
        always},
    PerceptionInput{"speed", [](const Perception& now) { return now.self().moving.forward; }, "",
                    always},
    PerceptionInput{"turn_rate",
                    [](const Perception& now) { return elsie::degrees(now.self().moving.turn); },
                    "", always},
    PerceptionInput{"time", [](const Perception& now) { return now.time_s(); }, "", always},
};

}  // namespace

std::span<const PerceptionInput> perception_inputs() { return kInputs; }

const PerceptionInput* find_perception_input(std::string_view name) {
  for (const PerceptionInput& input : kInputs) {
    const std::string_view known = input.name;
    if (std::equal(name.begin(), name.end(), known.begin(), known.end(), [](char a, char b) {
          return std::tolower(static_cast<unsigned char>(a)) == b;
        })) {
      return &input;
    }
  }
  return nullptr;
}

std::string perception_input_hint(std::string_view name) {
  std::vector<std::string_view> names;
  for (const PerceptionInput& input : kInputs) {
    names.emplace_back(input.name);
  }
  return elsie::base::did_you_mean(name, names);
}
