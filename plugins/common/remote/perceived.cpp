#include "perceived.h"

#include <cmath>
#include <string>

namespace remote {
namespace {

using elsie::FieldType;
using elsie::ReadingField;

Json number(const ReadingField& field, std::size_t i) {
  const double value = field.number(i);
  switch (field.type) {
    case FieldType::boolean:
      return value != 0.0;
    case FieldType::real32:
    case FieldType::real64:
    case FieldType::picture:
      return value;
    default:
      return static_cast<std::int64_t>(value);
  }
}

/// The numbers of a reading or a message by their names. Pictures are left out.
void add_numbers(Json& to, const ReadingField& field) {
  if (!field.is_number()) return;
  Json* at = &to;
  if (!field.group.empty()) {
    Json& list = to[std::string(field.group)];
    if (list.is_null()) list = Json::array();
    if (!field.in_list) return;
    while (list.size() <= field.item) list.push_back(Json::object());
    at = &list[field.item];
  }
  Json& value = (*at)[std::string(field.name)];
  if (!field.is_array) {
    value = number(field, 0);
    return;
  }
  value = Json::array();
  for (std::size_t i = 0; i < field.count; ++i) value.push_back(number(field, i));
}

Json place(const elsie::Vector2& at) { return {{"x", at.x}, {"y", at.y}}; }

Json fields_of(const elsie::ReadingGroup& group, const elsie::SensedReading& sensed) {
  Json fields = Json::array();
  if (!group.declaration || !group.declaration->visit) return fields;
  group.declaration->visit(sensed.value, [&](const ReadingField& field) {
    if (!field.is_number() || field.item > 0) return;
    Json one{{"name", field.path()}};
    if (!field.unit.empty()) one["unit"] = std::string(field.unit);
    if (field.is_array) one[field.varies ? "most" : "size"] = field.size;
    fields.push_back(std::move(one));
  });
  return fields;
}

Json sensors(const elsie::Perception& now) {
  Json all = Json::array();
  for (const elsie::ReadingGroup& group : now.all_readings()) {
    for (const elsie::SensedReading& sensed : group.readings) {
      const elsie::Mounting& at = *sensed.mounting;
      all.push_back({{"id", sensed.sensor},
                     {"kind", group.kind.name},
                     {"x", at.position.x},
                     {"y", at.position.y},
                     {"z", at.position.z},
                     {"azimuth", at.azimuth_rad},
                     {"pitch", at.pitch_rad},
                     {"segment", at.segment},
                     {"fields", fields_of(group, sensed)}});
    }
  }
  return all;
}

Json self(const elsie::OwnState& own) {
  Json held = Json::array();
  for (const elsie::HeldThing& thing : own.held) {
    held.push_back({{"id", std::string(thing.id)},
                    {"actuator", std::string(thing.actuator)},
                    {"moves", thing.moves}});
  }
  return {{"x", own.pose.x},
          {"y", own.pose.y},
          {"heading", own.pose.heading_rad},
          {"moving", motion(own.moving)},
          {"odometry", motion(own.odometry)},
          {"commanded", motion(own.commanded)},
          {"energy", own.energy},
          {"charging", own.charging},
          {"held", std::move(held)}};
}

Json team(const elsie::TeamState& state) {
  Json mates = Json::array();
  for (const elsie::TeamMate& mate : state.mates) {
    mates.push_back({{"id", std::string(mate.id)},
                     {"x", mate.pose.x},
                     {"y", mate.pose.y},
                     {"heading", mate.pose.heading_rad},
                     {"distance", mate.distance_m},
                     {"bearing", mate.bearing_rad},
                     {"leader", mate.is_leader},
                     {"index", mate.team_index}});
  }
  Json all{{"mates", std::move(mates)}};
  if (state.charger) all["charger"] = place(*state.charger);
  if (state.nest) {
    all["nest"] = place(state.nest->place);
    all["nest"]["radius"] = state.nest->radius_m;
  }
  return all;
}

Json heard(const elsie::Perception& now) {
  Json all = Json::array();
  for (const elsie::HeardMessage& each : now.all_heard()) {
    Json one{{"kind", each.message->kind().name}, {"device", std::string(each.device)}};
    if (!each.from.empty()) one["from"] = std::string(each.from);
    one["age"] = each.age_s;
    const auto add = [&](const char* name, double value) {
      if (std::isfinite(value)) one[name] = value;
    };
    add("distance", each.distance_m);
    add("bearing", each.bearing_rad);
    add("elevation", each.elevation_rad);
    Json& numbers = one["numbers"] = Json::object();
    each.message->visit_fields([&](const ReadingField& field) { add_numbers(numbers, field); });
    all.push_back(std::move(one));
  }
  return all;
}

Json readings(const elsie::Perception& now) {
  Json all = Json::object();
  for (const elsie::ReadingGroup& group : now.all_readings()) {
    for (const elsie::SensedReading& sensed : group.readings) {
      Json& one = all[sensed.sensor] = {{"kind", group.kind.name}, {"age", sensed.age_s}};
      if (!group.declaration || !group.declaration->visit) continue;
      group.declaration->visit(sensed.value,
                               [&](const ReadingField& field) { add_numbers(one, field); });
    }
  }
  return all;
}

}  // namespace

Json motion(const elsie::Motion& motion) {
  return {{"forward", motion.forward}, {"lateral", motion.lateral}, {"turn", motion.turn}};
}

Json facts(const elsie::Perception& now, const char* role) {
  const elsie::OwnState& own = now.self();
  Json channels = Json::array();
  if (own.channels.forward) channels.push_back("forward");
  if (own.channels.lateral) channels.push_back("lateral");
  if (own.channels.turn) channels.push_back("turn");
  return {{"protocol", kProtocol},
          {"role", role},
          {"robot", std::string(own.id)},
          {"team", std::string(now.team().name)},
          {"index", own.team_index},
          {"leader", own.is_leader},
          {"period", now.period_s()},
          {"wheels", {{"radius", own.wheels.radius}, {"half_axle", own.wheels.half_axle}}},
          {"channels", std::move(channels)},
          {"max_speed", own.max_speed_m_s},
          {"length", own.length_m},
          {"width", own.width_m},
          {"coverage", own.coverage_m},
          {"capacity", own.capacity},
          {"sensors", sensors(now)}};
}

Json perceived(const elsie::Perception& now) {
  Json events = Json::array();
  for (const elsie::Event& event : now.events()) events.push_back(event.name);
  return {{"time", now.time_s()},        {"self", self(now.self())}, {"team", team(now.team())},
          {"events", std::move(events)}, {"heard", heard(now)},      {"readings", readings(now)}};
}

}  // namespace remote
