#include "elsie/testing/scene.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace elsie::testing {

Scene::Scene() : texts_(std::make_shared<std::deque<std::string>>()) {
  now_.arena_length_m = now_.arena_width_m = 10.0;
  now_.is_start = true;
  team("red").team("blue");
}

std::string_view Scene::keep(const std::string& text) {
  const auto known = std::find(texts_->begin(), texts_->end(), text);
  return known != texts_->end() ? *known : texts_->emplace_back(text);
}

Scene& Scene::arena(double length_m, double width_m) {
  now_.arena_length_m = length_m;
  now_.arena_width_m = width_m;
  return *this;
}

Scene& Scene::steps_of(double step_s, int control_steps) {
  now_.step_s = step_s;
  control_steps_ = control_steps;
  return *this;
}

Scene& Scene::team(const std::string& id) {
  if (std::find(teams_.begin(), teams_.end(), id) == teams_.end()) {
    teams_.push_back(keep(id));
  }
  return *this;
}

Scene& Scene::robot(const std::string& id, double x, double y, const std::string& team,
                    double heading_deg) {
  this->team(team);
  ObservedRobot& made = robots_.emplace_back();
  made.id = keep(id);
  made.team = keep(team);
  made.pose = {x, y, wrap_angle(radians(heading_deg))};
  made.energy = made.capacity = 5000.0;
  behaviors_.emplace_back();
  numbers_.emplace_back();
  return *this;
}

Scene& Scene::leads(bool is_leader) {
  robots_.at(robots_.size() - 1).is_leader = is_leader;
  return *this;
}

Scene& Scene::behaves(const std::string& path, const std::string& plugin) {
  std::vector<ObservedBehavior>& all = behaviors_.at(behaviors_.size() - 1);
  const std::size_t slash = path.rfind('/');
  ObservedBehavior made;
  if (slash != std::string::npos) {
    const auto holder = std::find_if(all.begin(), all.end(), [&](const ObservedBehavior& other) {
      return other.path == std::string_view(path).substr(0, slash);
    });
    if (holder == all.end()) {
      throw std::invalid_argument("the robot has no behaviour '" + path.substr(0, slash) +
                                  "' that '" + path + "' could be inside of; add that one first");
    }
    made.parent = static_cast<int>(holder - all.begin());
  }
  made.path = keep(path);
  made.plugin =
      plugin.empty() ? keep(path.substr(slash == std::string::npos ? 0 : slash + 1)) : keep(plugin);
  all.push_back(made);
  return *this;
}

Scene& Scene::publishes(const std::string& name, const std::string& unit) {
  Numbers& numbers = numbers_.empty() ? of_world_ : numbers_.back();
  numbers.names.push_back({keep(name), keep(unit)});
  numbers.values.push_back(std::numeric_limits<double>::quiet_NaN());
  return *this;
}

Scene& Scene::box(const std::string& id, ObservedObstacle::Kind kind, double x, double y,
                  const std::string& team) {
  boxes_.push_back({keep(id), kind, keep(team), {x, y, 0.0}});
  return *this;
}

Scene& Scene::resource(const std::string& id, double x, double y, const std::string& team) {
  return box(id, ObservedObstacle::Kind::resource, x, y, team);
}

Scene& Scene::field(const std::string& id, std::size_t columns, std::vector<double> cells) {
  const auto known = std::find_if(fields_.begin(), fields_.end(),
                                  [&](const ObservedField& each) { return each.id == id; });
  const auto i = static_cast<std::size_t>(known - fields_.begin());
  if (known == fields_.end()) {
    fields_.emplace_back();
    cells_.emplace_back();
  }
  fields_[i] = {keep(id), columns, cells.size() / columns, {}, 1.0};
  cells_[i] = std::move(cells);
  return *this;
}

Scene& Scene::remove_obstacle(const std::string& id) {
  std::erase_if(boxes_, [&](const ObservedObstacle& box) { return box.id == id; });
  return *this;
}

Scene& Scene::event(const std::string& name, const std::string& robot) {
  events_.push_back({keep(name), keep(robot)});
  return *this;
}

std::size_t Scene::index_of(const std::string& robot) const {
  const Observation& now = observation();
  return static_cast<std::size_t>(&now.robot(robot) - now.robots.data());
}

ObservedRobot& Scene::operator[](const std::string& id) { return robots_[index_of(id)]; }

ObservedBehavior& Scene::behavior(const std::string& robot, const std::string& path) {
  std::vector<ObservedBehavior>& all = behaviors_[index_of(robot)];
  const auto found = std::find_if(all.begin(), all.end(), [&](const ObservedBehavior& behavior) {
    return behavior.path == path;
  });
  if (found == all.end()) {
    throw std::invalid_argument("the robot '" + robot + "' has no behaviour '" + path + "'");
  }
  return *found;
}

double& Scene::number(const std::string& robot, const std::string& name) {
  Numbers& numbers = robot.empty() ? of_world_ : numbers_[index_of(robot)];
  for (std::size_t i = 0; i < numbers.names.size(); ++i) {
    if (numbers.names[i].name == name) return numbers.values[i];
  }
  throw std::invalid_argument((robot.empty() ? "the world" : "the robot '" + robot + "'") +
                              " publishes no '" + name + "'");
}

Scene& Scene::step() { return at_step(steps_ + 1); }

Scene& Scene::at_step(int steps) {
  steps_ = steps;
  events_.clear();
  now_.is_start = steps == 0;
  now_.decided = steps > 0 && (steps - 1) % control_steps_ == 0;
  now_.time_s = static_cast<double>(steps) * now_.step_s;
  return *this;
}

const Observation& Scene::observation() const {
  seen_ = robots_;
  seen_behaviors_ = behaviors_;
  seen_numbers_ = numbers_;
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    std::vector<ObservedBehavior>& behaviors = seen_behaviors_[i];
    for (ObservedBehavior& behavior : behaviors) {
      behavior.robot_share =
          behavior.share * (behavior.parent < 0
                                ? 1.0
                                : behaviors[static_cast<std::size_t>(behavior.parent)].robot_share);
    }
    seen_[i].behaviors = behaviors;
    seen_[i].published = seen_numbers_[i].names;
    seen_[i].numbers = &seen_numbers_[i];
  }
  view_ = now_;
  seen_of_world_ = of_world_;
  seen_fields_ = fields_;
  seen_cells_ = cells_;
  for (std::size_t i = 0; i < seen_fields_.size(); ++i) seen_fields_[i].cells = seen_cells_[i];
  view_.fields = seen_fields_;
  view_.published = seen_of_world_.names;
  view_.numbers = &seen_of_world_;
  view_.period_s = now_.step_s * static_cast<double>(control_steps_);
  view_.robots = seen_;
  view_.obstacles = boxes_;
  view_.teams = teams_;
  view_.events = events_;
  return view_;
}

}  // namespace elsie::testing
