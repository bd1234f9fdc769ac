#include "measuring/rule_answers.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "edits/transaction.h"

namespace elsie::simulation {

void RuleAnswers::edit(std::string path, std::string value) {
  const world::PluginUse& use = *rule_->use;
  if (edits_.empty() || edits_.back().rule != use.id) {
    const base::Location& where = use.location;
    const std::string place =
        where.line > 0 ? where.file.text() + ":" + std::to_string(where.line) + ": " : "";
    edits_.push_back({use.id, place + "the rule '" + use.id + "'", {}});
  }
  edits_.back().edits.push_back({std::move(path), std::move(value)});
}

void RuleAnswers::place(std::string_view what, const Pose& pose) {
  const auto body = find(what);
  if (!body) {
    throw std::invalid_argument("it places '" + std::string(what) +
                                "', but this world has no such robot, resource or box that can be "
                                "pushed; expected one as in 'robot[r1]' or 'resource[food]'");
  }
  room().put(*body, pose);
  const std::string path = std::string(what) + "/@";
  set(path + "x", pose.x);
  set(path + "y", pose.y);
  set(path + "heading_deg", degrees(wrap_angle(pose.heading_rad)));
}

std::optional<physics::Body> RuleAnswers::find(std::string_view what) const {
  const std::size_t open = what.find('[');
  if (open != std::string_view::npos && what.ends_with(']')) {
    const std::string id(what.substr(open + 1, what.size() - open - 2));
    if (what.starts_with("robot[")) {
      const std::size_t robot = index_of(world_.robots, id, 0);
      if (robot < world_.robots.size()) return physics::Body{physics::BodyKind::robot, robot};
    } else if (const std::size_t box = index_of(world_.obstacles, id, 0);
               box < world_.obstacles.size() &&
               (world_.obstacles[box].kind == world::ObstacleKind::resource ||
                world_.obstacles[box].is_dynamic())) {
      return physics::Body{physics::BodyKind::obstacle, box};
    }
  }
  return std::nullopt;
}

void RuleAnswers::raise(const Event& event, std::string_view robot) {
  const std::vector<EventDeclaration>& declared = rule_->declaration->events;
  if (std::none_of(declared.begin(), declared.end(),
                   [&](const EventDeclaration& each) { return each.name == event.name; })) {
    throw std::invalid_argument(
        "it raised the event '" + event.name +
        "', which its declaration does not name; add elsie::raises() to it");
  }
  bool is_heard = robot.empty();
  for (const auto& each : robots_) {
    if (!robot.empty() && each->description().id != robot) continue;
    each->raise_by_rule(event);
    is_heard = true;
  }
  has_raised_ = true;
  if (!is_heard) {
    throw std::invalid_argument("it raised the event '" + event.name + "' for the robot '" +
                                std::string(robot) + "', which this world does not have");
  }
}

void RuleAnswers::end(Outcome outcome, const std::string& reason) {
  if (!verdict_ || (outcome == Outcome::failure && verdict_->outcome == Outcome::success)) {
    verdict_ = {outcome, "the rule '" + rule_->use->id + "' says: " + reason};
  }
}

void RuleAnswers::decide(Judgement& judgement) const {
  const bool is_open =
      judgement.outcome == Outcome::running || judgement.outcome == Outcome::time_limit ||
      (judgement.outcome == Outcome::success && verdict_ && verdict_->outcome == Outcome::failure);
  if (verdict_ && is_open) judgement = *verdict_;
}

}  // namespace elsie::simulation
