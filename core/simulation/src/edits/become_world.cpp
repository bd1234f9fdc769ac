// A running world becomes another one: its edited description. What an edit costs follows from
// comparing the two descriptions along the vocabulary.
#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "elsie/base/number_text.h"
#include "elsie/world/same.h"

#include "edits/differences.h"
#include "edits/room.h"
#include "simulation_impl.h"

namespace elsie::simulation {
namespace {

/// The chargers that are obstacles, in the order of the engine, which has them after all other
/// obstacles.
std::vector<const world::Charger*> charger_boxes(const world::World& world) {
  std::vector<const world::Charger*> obstacles;
  for (const world::Charger& charger : world.chargers) {
    if (charger.seen_by_range_sensors) obstacles.push_back(&charger);
  }
  return obstacles;
}

Pose pose_of(const world::Robot& robot) {
  return {robot.x, robot.y, wrap_angle(radians(robot.heading_deg))};
}

/// The coordinates of a robot or an obstacle that an edit sets.
struct NewPlace {
  bool x, y, z, heading;

  explicit operator bool() const { return x || y || z || heading; }
  Pose pose(const Pose& here, const Pose& asked) const {
    return {x ? asked.x : here.x, y ? asked.y : here.y,
            heading ? asked.heading_rad : here.heading_rad};
  }
};

template <class Described>
NewPlace new_place(const Described& was, const Described& next,
                   const EditTransaction& transaction) {
  const auto is_new = [&](const char* name, double before, double now) {
    return before != now || transaction.asks(next, name);
  };
  return {is_new("x", was.x, next.x), is_new("y", was.y, next.y), is_new("z", was.z, next.z),
          is_new("heading_deg", was.heading_deg, next.heading_deg)};
}

}  // namespace

void Simulation::Impl::become(world::World next, EditTransaction& transaction) {
  Undo& undo = transaction.undo();
  const auto before = std::make_shared<world::World>(std::exchange(own_world_, std::move(next)));
  const world::World& was = *before;
  const auto renew = [this] {
    in_place_.emplace(world_, *host_, options_);
    neighbours_.emplace(world_.arena);
  };
  undo.add([this, before, renew] {
    std::swap(own_world_, *before);  // what the old objects look at has its place again
    past_.pop_back();
    renew();
  });
  undo.keep(start_, time_limit_s_, base_time_s_, base_steps_, new_schedules_);
  undo.keep(cameras_, measuring_, engine_, fields_, moving_, touches_, robots_, departed_,
            goal_progress_);
  const Pairs pairs(was, world_);
  past_.push_back(before);
  transaction.settling([this, before, gone = pairs.gone()] {
    if (start_ != before) before->robots = gone;  // the others are in the new world
  });
  if (!start_) start_ = before;
  renew();
  time_limit_s_ = options_.time_limit_s.value_or(world_.limits.time);
  if (options_.time_limit_s && was.limits.time != world_.limits.time) {
    transaction.said().notes.push_back({"", "limits",
                                        "An edit at " + transaction.time() +
                                            " gives limits/@time another value, but this run ends "
                                            "after " +
                                            base::number_text(time_limit_s_) +
                                            " s at the latest: it was given that duration."});
  }
  if (was.physics.step != world_.physics.step ||
      was.physics.control_steps != world_.physics.control_steps) {
    base_time_s_ += static_cast<double>(steps_ - base_steps_) * was.physics.step;
    base_steps_ = steps_;
  }
  become_schedule(was);
  if (!world::same(world::vocabulary(), &was, &world_, world::Cost::object)) ++rebuilds_;
  become_robots(pairs, transaction);
  if (!transaction.problems().empty()) return;
  const bool has_new_bodies = !world::same(world::vocabulary(), &was, &world_, world::Cost::body);
  bool is_placed = false;
  transaction.may_cause_warnings = has_new_bodies;
  for (std::size_t i = 0; i < robots_.size() && !has_new_bodies; ++i) {
    if (pairs.stays(i)) continue;
    const world::Robot &old = was.robots[pairs.former(i)], &robot = world_.robots[i];
    is_placed = is_placed || new_place(old, robot, transaction);
    transaction.may_cause_warnings |= old.max_speed != robot.max_speed;
  }
  for (std::size_t i = 0; i < world_.obstacles.size() && !has_new_bodies && !is_placed; ++i) {
    is_placed = bool(new_place(was.obstacles[i], world_.obstacles[i], transaction));
  }
  if (has_new_bodies || is_placed) check_room(was, become_bodies(pairs, transaction));
  if (!same_part("fields", was, world_) || !same_part("arena", was, world_)) {
    fields_ = std::make_shared<Fields>(world_, *fields_);
  }
  become_measures(was, transaction);
  become_goals(was);
  bool has_cameras = !cameras_->empty();
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (pairs.stays(i)) continue;
    robots_[i]->take_segments(*engine_, i);
    has_cameras = has_cameras || robots_[i]->has_camera();
  }
  if (has_cameras) {
    cameras_ = std::make_shared<Cameras>(world_, robots_, options_.cameras, transaction.problems());
  }
}

/// Schedules the world's own edits that are still due.
void Simulation::Impl::become_schedule(const world::World& was) {
  if (same_schedule(was, world_)) return;
  ++new_schedules_;
  std::set<std::pair<double, std::string>> known;
  for (const world::TimedEdit& edit : was.edits) {
    known.emplace(edit.time, edit.text());
  }
  std::vector<TimedEdit> added;
  for (const world::TimedEdit& edit : world_.edits) {
    if (!known.contains({edit.time, edit.text()})) added.push_back(timed(edit));
  }
  for (const DueEdits& due : by_time(added)) {
    const std::string time = "the time of a change is " + base::number_text(due.time_s) + " s";
    if (due.time_s <= time_s()) {
      throw std::invalid_argument(time + ", but the run is at " + base::number_text(time_s()) +
                                  " s already; expected a later time");
    }
    if (!due.come_before(time_limit_s_, world_.physics.step)) {
      throw std::invalid_argument(time + ", but the run ends after " +
                                  base::number_text(time_limit_s_) +
                                  " s at the latest; expected an earlier time");
    }
  }
}

void Simulation::Impl::become_robots(const Pairs& pairs, EditTransaction& transaction) {
  std::vector<std::shared_ptr<Robot>> gone = std::move(robots_);
  robots_.clear();
  const auto common = std::make_shared<CommonData>(world_, robot_ids_);
  for (std::size_t i = 0; i < world_.robots.size(); ++i) {
    if (pairs.is_new(i)) {
      robots_.push_back(std::make_shared<Robot>(world_, i, common, *host_, options_));
      robots_.back()->reset(seed_);
      robots_.back()->ask(transaction.said());
      continue;
    }
    const std::size_t former = pairs.former(i);
    robots_.push_back(std::move(gone[former]));
    if (pairs.stays(i)) continue;
    robots_.back()->become(pairs.was().robots[former], world_, i, *common, transaction);
  }
  for (const auto& robot : gone) {
    if (robot) {
      departed_.distance_m += robot->tally().distance_m;
      departed_.collected += robot->tally().collected;
      departed_.collisions += robot->tally().collisions;
    }
  }
}

/// Returns the robots and obstacles that are new, have a new body, or are at a new place.
std::vector<physics::Body> Simulation::Impl::become_bodies(const Pairs& pairs,
                                                           EditTransaction& transaction) {
  const world::World& was = pairs.was();
  std::vector<physics::Body> fresh;
  std::map<physics::Body, physics::Body> now;  // new bodies by the old ones
  const auto before = engine_;
  const auto moving = std::exchange(moving_, {});
  engine_ = physics::make_engine(world_.arena, world_.physics);
  engine_->work_with(loop_.pool());
  engine_->go_on_from(*before);
  using enum physics::BodyKind;
  for (std::size_t i = 0; i < world_.obstacles.size(); ++i) {
    const world::Obstacle& next = world_.obstacles[i];
    const std::size_t former = index_of(was.obstacles, next.id, i);
    if (former == was.obstacles.size() ||
        !world::same(was.obstacles[former], next, world::Cost::body)) {
      add_obstacle(i);
      fresh.push_back({obstacle, i});
      continue;
    }
    engine_->add_obstacle_of(*before, former, next);
    if (const NewPlace asked = new_place(was.obstacles[former], next, transaction)) {
      engine_->place_obstacle(i, asked.pose(pose_of_box(*before, was, former), pose_of(next)));
      transaction.placed.push_back({obstacle, i});
      fresh.push_back({obstacle, i});
    }
    now[{obstacle, former}] = {obstacle, i};
    for (const MovingObstacle& known : moving) {
      if (known.index == former) {
        moving_.push_back({i, known.path, known.since_s});
      }
    }
  }
  add_charger_boxes();
  const auto chargers = charger_boxes(was), new_chargers = charger_boxes(world_);
  for (std::size_t i = 0; i < new_chargers.size(); ++i) {
    const auto known = std::find_if(chargers.begin(), chargers.end(), [&](const auto* charger) {
      return charger->x == new_chargers[i]->x && charger->y == new_chargers[i]->y;
    });
    if (known != chargers.end()) {
      const auto former = static_cast<std::size_t>(known - chargers.begin());
      now[{obstacle, was.obstacles.size() + former}] = {obstacle, world_.obstacles.size() + i};
    }
  }
  for (std::size_t i = 0; i < world_.robots.size(); ++i) {
    const world::Robot& next = world_.robots[i];
    const std::size_t former = pairs.former(i);
    const BodyPlan plan = world::plan_of(next);
    Arrival arrival = Arrival::stayed;
    if (pairs.is_new(i)) {
      arrival = Arrival::started;
      engine_->add_robot(plan, pose_of(next), next.z);
      fresh.push_back({robot, i});
    } else {
      const world::Robot& old = was.robots[former];
      const bool is_same = world::same(world::robot_spec(), &old, &next, world::Cost::body);
      if (is_same) {
        engine_->add_robot_of(*before, former);
      } else {
        engine_->add_robot_of(*before, former, plan, robots_[i]->truth().pose);
      }
      now[{robot, former}] = {robot, i};
      if (const NewPlace asked = new_place(old, next, transaction)) {
        arrival = Arrival::placed;
        transaction.placed.push_back({robot, i});
        engine_->place_robot(i, asked.pose(robots_[i]->truth().pose, pose_of(next)),
                             asked.z ? next.z : height(engine_->robot(i).frame));
      } else if (is_same) {
        continue;
      }
      fresh.push_back({robot, i});
    }
    robots_[i]->set_body(engine_->robot(i), engine_->joints(i), arrival);
  }
  touches_.renumber([&](const physics::Body& body) -> std::optional<physics::Body> {
    const auto known = now.find(body);
    return known != now.end()  ? std::optional(known->second)
           : body.kind == wall ? std::optional(body)
                               : std::nullopt;
  });
  return fresh;
}

void Simulation::Impl::check_room(const world::World& was,
                                  std::span<const physics::Body> fresh) const {
  const auto require = [](const std::optional<std::string>& problem) {
    if (problem) {
      throw std::invalid_argument(*problem + "; expected a free place in the arena");
    }
  };
  const Room room(world_, *engine_);
  for (const physics::BodyKind kind : {physics::BodyKind::robot, physics::BodyKind::obstacle}) {
    for (const physics::Body& body : fresh) {
      if (body.kind == kind) require(room.problem_of(body));
    }
  }
  if (!same_part("chargers", was, world_)) {
    for (std::size_t i = 0; i < world_.chargers.size(); ++i) {
      require(room.problem_of_box(world_.obstacles.size() + i));
    }
  }
  if (!same_part("arena", was, world_)) require(room.problem_of_arena());
}

void Simulation::Impl::become_measures(const world::World& was, EditTransaction& transaction) {
  const auto before = measuring_;
  measuring_ = std::make_shared<Measuring>(world_, *host_, options_.budget, transaction.problems(),
                                           before.get());
  if (!transaction.problems().empty()) return;
  const bool same_stage = same_part("teams", was, world_) && same_part("physics", was, world_) &&
                          same_part("arena", was, world_);
  measuring_->take(*before, same_stage, transaction.undo());
  measuring_->reset_new(seed_, transaction.time(), transaction.said());
}

/// Goals that existed before keep their progress.
void Simulation::Impl::become_goals(const world::World& was) {
  GoalProgress none{.time_s = time_s(), .done = {}, .events_read = events_.size()};
  if (!same_part("goals", was, world_)) {  // otherwise none is new
    for (const auto& robot : robots_) {
      none.done[robot->description().id] = {robot->tally().distance_m, robot->tally().collisions};
    }
  }
  std::vector<const world::Goal*> before = single_goals(was.goals);
  std::vector<GoalProgress> progress;
  for (const world::Goal* goal : single_goals(world_.goals)) {
    const auto known = std::find_if(before.begin(), before.end(), [&](const world::Goal* other) {
      return other && same_goal(*goal, *other);
    });
    progress.push_back(known == before.end()
                           ? none
                           : goal_progress_[static_cast<std::size_t>(known - before.begin())]);
    if (known != before.end()) *known = nullptr;  // one goal goes on, not several
  }
  goal_progress_ = std::move(progress);
}

void Simulation::Impl::settle(EditTransaction& transaction) {
  const Statements& said = transaction.said();
  said_.notes.insert(said_.notes.end(), said.notes.begin(), said.notes.end());
  said_.curves.insert(said_.curves.end(), said.curves.begin(), said.curves.end());
  note_robot_ids();
  if (transaction.may_cause_warnings) note_new_warnings(world_, time_s(), said_.notes);
  ++renewals_;
  transaction.settle();
  hands_.follow(world_, robots_, engine_, transaction.placed);
}

}  // namespace elsie::simulation
