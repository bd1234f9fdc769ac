// Whether two worlds are the same but for the places where things stand in their files. Written out
// member by member, so that a member that is forgotten in the vocabulary shows.
#pragma once

#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include "elsie/world/description.h"

namespace elsie::test {

inline auto members(const world::Arena& a) {
  return std::tie(a.length, a.width, a.wall_height, a.wall_thickness, a.walls);
}
inline auto members(const world::Physics& p) {
  return std::tie(p.engine, p.gravity, p.step, p.control_steps, p.friction, p.wheel_slip, p.bounce,
                  p.parameters);
}
inline auto members(const world::Team& t) { return std::tie(t.id, t.colour); }
inline auto members(const world::Obstacle& b) {
  return std::tie(b.id, b.kind, b.shape, b.x, b.y, b.z, b.heading_deg, b.length, b.width, b.radius,
                  b.points, b.height, b.colour, b.seen_by_range_sensors, b.mass, b.waypoints,
                  b.speed, b.round_trip, b.team, b.energy);
}
inline auto members(const world::Charger& c) {
  return std::tie(c.id, c.team, c.x, c.y, c.radius, c.rate, c.seen_by_range_sensors);
}
inline auto members(const world::ElementUse& u) {
  return std::tie(u.element, u.parameters, u.file_names);
}
inline auto members(const world::PluginUse& u) {
  return std::tie(u.plugin, u.id, u.parameters, u.file_names);
}
inline auto members(const world::SensorUse& u) {
  return std::tuple_cat(members(static_cast<const world::PluginUse&>(u)),
                        std::tie(u.x, u.y, u.z, u.yaw_deg, u.pitch_deg, u.energy_cost));
}
inline auto members(const world::BehaviorUse& u) {
  return std::tuple_cat(members(static_cast<const world::PluginUse&>(u)), std::tie(u.priority));
}
inline auto members(const world::RobotBody& b) {
  return std::tie(b.round, b.length, b.width, b.height, b.clearance, b.wheel_radius, b.wheel_width,
                  b.axle, b.mass, b.wheel_mass, b.wheel_torque);
}
inline auto members(const world::Segment& s) {
  return std::tie(s.id, s.length, s.width, s.height, s.clearance, s.mass, s.wheel_radius,
                  s.wheel_width, s.gap, s.hitch, s.hitch_height, s.max_yaw_deg, s.max_pitch_deg);
}
inline auto members(const world::CollectGoal& g) { return std::tie(g.team); }
inline auto members(const world::ReachGoal& g) {
  return std::tie(g.robot, g.x, g.y, g.radius, g.of);
}
inline auto members(const world::PushGoal& g) { return std::tie(g.obstacle, g.x, g.y, g.radius); }
inline auto members(const world::GatherGoal& g) { return std::tie(g.team, g.distance); }
inline auto members(const world::TravelGoal& g) { return std::tie(g.robot, g.distance); }
inline auto members(const world::EndureGoal& g) { return std::tie(g.time); }
inline auto members(const world::NoCollisionGoal& g) { return std::tie(g.robot); }
inline auto members(const world::BatteryGoal& g) { return std::tie(g.robot); }
inline auto members(const world::TimedEdit& e) { return std::tuple(e.time, e.path, e.text()); }
inline auto members(const world::Limits& l) { return std::tie(l.time, l.wall_time); }

template <class T>
bool same(const T& a, const T& b) {
  return members(a) == members(b);
}
inline bool same(const world::Coordination& a, const world::Coordination& b);
inline bool same(const world::PluginUse& a, const world::PluginUse& b);
inline bool same(const world::SensorUse& a, const world::SensorUse& b);
inline bool same(const world::BehaviorUse& a, const world::BehaviorUse& b);
template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  if (a.size() != b.size()) {
    return false;
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!same(a[i], b[i])) {
      return false;
    }
  }
  return true;
}
inline bool same(const world::PluginUse& a, const world::PluginUse& b) {
  return members(a) == members(b) && same(a.elements, b.elements);
}
inline bool same(const world::SensorUse& a, const world::SensorUse& b) {
  return members(a) == members(b) && same(a.elements, b.elements);
}
inline bool same(const world::BehaviorUse& a, const world::BehaviorUse& b) {
  return members(a) == members(b) && same(a.elements, b.elements) && same(a.inside, b.inside);
}
inline bool same(const world::Coordination& a, const world::Coordination& b) {
  return same(a.behaviors, b.behaviors) && a.coordinator.has_value() == b.coordinator.has_value() &&
         (!a.coordinator || same(*a.coordinator, *b.coordinator));
}
inline bool same(const world::Goal& a, const world::Goal& b) {
  return a.index() == b.index() &&
         std::visit(
             [&](const auto& goal) {
               return same(goal, std::get<std::remove_cvref_t<decltype(goal)>>(b));
             },
             a);
}
inline bool same(const std::vector<world::Goal>& a, const std::vector<world::Goal>& b) {
  bool equal = a.size() == b.size();
  for (std::size_t i = 0; equal && i < a.size(); ++i) {
    equal = same(a[i], b[i]);
  }
  return equal;
}
inline bool same(const world::Robot& a, const world::Robot& b) {
  const auto own = [](const world::Robot& r) {
    return std::tie(r.id, r.team, r.x, r.y, r.z, r.heading_deg, r.max_speed, r.coverage, r.leader,
                    r.battery, r.energy);
  };
  return own(a) == own(b) && same(a.body, b.body) && same(a.segments, b.segments) &&
         same(a.sensors, b.sensors) && a.drive.has_value() == b.drive.has_value() &&
         (!a.drive || same(*a.drive, *b.drive)) &&
         same(static_cast<const world::Coordination&>(a),
              static_cast<const world::Coordination&>(b));
}
template <class T>
bool same(const base::List<T>& a, const base::List<T>& b) {
  bool equal = a.size() == b.size();
  for (std::size_t i = 0; equal && i < a.size(); ++i) {
    equal = same(a[i], b[i]);
  }
  return equal;
}
inline bool same(const world::World& a, const world::World& b) {
  return a.name == b.name && a.description == b.description && same(a.arena, b.arena) &&
         same(a.physics, b.physics) && same(a.teams, b.teams) && same(a.obstacles, b.obstacles) &&
         same(a.chargers, b.chargers) && same(a.robots, b.robots) && same(a.goals, b.goals) &&
         same(a.measures, b.measures) && same(a.edits, b.edits) && same(a.limits, b.limits);
}

}  // namespace elsie::test
