#include "measuring/lookout.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "elsie/simulation/measures.h"

namespace elsie::simulation {
namespace {

ObservedObstacle::Kind kind_of(world::ObstacleKind kind) {
  switch (kind) {
    case world::ObstacleKind::fixed:
      break;
    case world::ObstacleKind::dynamic:
      return ObservedObstacle::Kind::dynamic;
    case world::ObstacleKind::moving:
      return ObservedObstacle::Kind::moving;
    case world::ObstacleKind::resource:
      return ObservedObstacle::Kind::resource;
  }
  return ObservedObstacle::Kind::fixed;
}

bool stays(const world::Obstacle& obstacle) {
  return !obstacle.is_dynamic() && obstacle.kind != world::ObstacleKind::moving;
}

void take_over(const Robot& robot, ObservedRobot& seen, std::span<ObservedBehavior> behaviors) {
  const OwnState& state = robot.state();
  seen.pose = robot.truth().pose;
  seen.believed = {state.pose, state.moving};
  seen.asked = robot.asked();
  seen.command = state.commanded;
  seen.moving = robot.truth().moving;
  seen.odometry = state.odometry;
  seen.wheels = state.wheels;
  seen.distance_m = robot.tally().distance_m;
  seen.energy = state.energy;
  seen.energy_used = robot.tally().energy_used;
  seen.collisions = robot.tally().collisions;
  seen.collected = robot.tally().collected;
  seen.talk = robot.tally().talk;
  seen.is_leader = state.is_leader;
  seen.charging = state.charging;
  seen.empty = robot.empty();
  const std::span<const TracedMember> members = robot.trace();
  for (std::size_t i = 0; i < behaviors.size(); ++i) {
    const TraceRow& trace = members[i].member->trace;
    ObservedBehavior& behavior = behaviors[i];
    behavior.asked = trace.asked;
    behavior.command = trace.command;
    behavior.activation = trace.activation;
    behavior.share = trace.share;
    behavior.robot_share = share_in_robot(
        trace.share, behavior.parent < 0
                         ? 1.0
                         : behaviors[static_cast<std::size_t>(behavior.parent)].robot_share);
  }
}

}  // namespace

std::span<const double> Lookout::Numbers::now() const {
  if (!is_read) {
    std::fill(values.begin(), values.end(), std::numeric_limits<double>::quiet_NaN());
    std::size_t next = 0;  // they are mostly in this order
    visit_published([&](const PublishedValue& published) {
      const auto is_it = [&](const ObservedNumber& each) {
        const std::string_view path = published.path, name = published.number.name;
        return each.name.size() == path.size() + 1 + name.size() && each.name.starts_with(path) &&
               each.name.ends_with(name);
      };
      for (std::size_t tried = 0; tried < names.size(); ++tried, ++next) {
        if (next >= names.size()) next = 0;
        if (!is_it(names[next])) continue;
        values[next++] = published.value;
        break;
      }
    });
    is_read = true;
  }
  return values;
}

Lookout::Lookout(const world::World& world, const plugin::Host& host,
                 std::function<void(const VisitPublished&)> visit_published)
    : host_(host) {
  for (const world::Team& team : world.teams) {
    add_team(team.id);
  }
  behaviors_.reserve(world.robots.size());
  for (const world::Robot& robot : world.robots) {
    describe(robot);
  }
  Numbers& numbers = numbers_.emplace_back();
  numbers.visit_published = std::move(visit_published);
  for (const auto& use : world.measures) list_published(PluginKind::measure, use, "");
  for (const auto& use : world.rules) list_published(PluginKind::rule, use, "");
  numbers.values.resize(numbers.names.size());
  now_.published = numbers.names;
  for (const world::Obstacle& obstacle : world.obstacles) {
    stay_in_place_.push_back(stays(obstacle));
    all_obstacles_.push_back({obstacle.id,
                              kind_of(obstacle.kind),
                              obstacle.team,
                              {obstacle.x, obstacle.y, wrap_angle(radians(obstacle.heading_deg))}});
    add_team(obstacle.team);
  }
  for (const world::ScalarField& field : world.fields) fields_.push_back({.id = field.id});
  now_.fields = fields_;
  obstacles_ = all_obstacles_;
  now_.step_s = world.physics.step;
  now_.period_s = world.physics.step * static_cast<double>(world.physics.control_steps);
  now_.arena_length_m = world.arena.length;
  now_.arena_width_m = world.arena.width;
  now_.is_start = true;
  now_.robots = robots_;
  now_.obstacles = obstacles_;
  now_.teams = teams_;
}

// A world that was not read from a file may not list all its teams.
void Lookout::add_team(std::string_view team) {
  if (!team.empty() && std::find(teams_.begin(), teams_.end(), team) == teams_.end()) {
    teams_.push_back(team);
  }
}

void Lookout::describe(const world::Robot& robot) {
  add_team(robot.team);
  std::vector<ObservedBehavior>& behaviors = behaviors_.emplace_back();
  Numbers& numbers = numbers_.emplace_back();
  for (const world::MountedUse& sensor : robot.sensors) {
    list_published(PluginKind::sensor, sensor, "");
  }
  for (const world::MountedUse& actuator : robot.actuators) {
    list_published(PluginKind::actuator, actuator, "");
  }
  if (robot.drive) list_published(PluginKind::drive, *robot.drive, "");
  if (robot.localisation) list_published(PluginKind::localisation, *robot.localisation, "");
  describe(robot, "", -1, behaviors);
  numbers.values.resize(numbers.names.size());
  ObservedRobot& seen = robots_.emplace_back();
  seen.id = robot.id;
  seen.team = robot.team;
  seen.pose = {robot.x, robot.y, wrap_angle(radians(robot.heading_deg))};
  seen.energy = robot.energy.value_or(robot.battery);
  seen.capacity = robot.battery;
  seen.is_leader = robot.leader;
  seen.empty = seen.energy <= 0.0;
  seen.behaviors = behaviors;
  seen.published = numbers.names;
}

// Of a plugin of the last robot.
void Lookout::list_published(PluginKind kind, const world::PluginUse& use,
                             const std::string& within) {
  const Declaration* const declaration = host_.find(kind, use.plugin);
  if (!declaration) return;
  for (const PublishedNumber& number : declaration->published) {
    numbers_.back().names.push_back(
        {paths_.emplace_back(within + use.id + "." + number.name), number.facts.unit});
  }
}

// In the order of Robot::trace(): each behaviour before those inside it.
void Lookout::describe(const world::Coordination& coordination, const std::string& path, int parent,
                       std::vector<ObservedBehavior>& behaviors) {
  for (const world::BehaviorUse& use : coordination.behaviors) {
    const std::string& own = paths_.emplace_back(path + use.id);
    ObservedBehavior& behavior = behaviors.emplace_back();
    behavior.path = own;
    behavior.plugin = use.plugin;
    behavior.parent = parent;
    const int own_index = static_cast<int>(behaviors.size()) - 1;
    list_published(PluginKind::behavior, use, path);
    for (const world::Coordination& inside : use.inside) {
      describe(inside, own + "/", own_index, behaviors);
    }
  }
  if (coordination.coordinator) {
    list_published(PluginKind::coordinator, *coordination.coordinator, path);
  }
}

bool Lookout::has_cast_of(const Lookout& other) const {
  const auto same = [](const auto& all, const auto& others, auto is_same) {
    return std::equal(all.begin(), all.end(), others.begin(), others.end(), is_same);
  };
  const auto same_behavior = [](const ObservedBehavior& a, const ObservedBehavior& b) {
    return a.path == b.path && a.plugin == b.plugin;
  };
  const auto same_name = [](const ObservedNumber& a, const ObservedNumber& b) {
    return a.name == b.name;
  };
  const auto same_robot = [&](const ObservedRobot& a, const ObservedRobot& b) {
    return a.id == b.id && a.team == b.team && same(a.behaviors, b.behaviors, same_behavior) &&
           same(a.published, b.published, same_name);
  };
  return same(robots_, other.robots_, same_robot) &&
         same(now_.published, other.now_.published, same_name) &&
         same(all_obstacles_, other.all_obstacles_,
              [](const ObservedObstacle& a, const ObservedObstacle& b) {
                return a.id == b.id && a.team == b.team;
              });
}

void Lookout::look(Robots robots, const physics::Engine& engine, const Fields& fields,
                   std::span<const EventRecord> events, double time_s, bool decided,
                   bool is_start) {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    take_over(*robots[i], robots_[i], behaviors_[i]);
    numbers_[i].visit_published = [robot = robots[i].get()](const VisitPublished& visit) {
      robot->visit_published(visit);
    };
    numbers_[i].is_read = false;
    robots_[i].numbers = &numbers_[i];
  }
  numbers_.back().is_read = false;
  now_.numbers = &numbers_.back();
  obstacles_.clear();
  for (std::size_t i = 0; i < all_obstacles_.size(); ++i) {
    if (engine.has_obstacle(i)) {
      ObservedObstacle& obstacle = obstacles_.emplace_back(all_obstacles_[i]);
      if (!stay_in_place_[i]) {
        const Frame frame = engine.obstacle(i);
        obstacle.pose = {frame.origin.x, frame.origin.y,
                         std::atan2(frame.forward.y, frame.forward.x)};
      }
    }
  }
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const RunningField& field = fields[i];
    fields_[i] = {field.id(), field.cells().columns, field.cells().rows, field.grid(),
                  field.scale()};
  }
  events_.clear();
  for (const EventRecord& event : events) {
    events_.push_back({events::name_of(event.event), event.robot});
  }
  now_.events = events_;
  now_.obstacles = obstacles_;
  now_.time_s = time_s;
  now_.decided = decided;
  now_.is_start = is_start;
}

}  // namespace elsie::simulation
