// Edits of a running world: in place, or by an edited description that the world becomes; and their
// check before a run.
#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <utility>

#include "elsie/base/number_text.h"
#include "elsie/base/thrown.h"
#include "elsie/base/words.h"
#include "elsie/world/attributes.h"
#include "elsie/world/edited_worlds.h"
#include "elsie/world/reader.h"

#include "edits/differences.h"
#include "simulation_impl.h"

namespace elsie::simulation {
namespace {

std::vector<std::string> texts_of(std::span<const Edit> edits) {
  std::vector<std::string> texts(edits.size());
  std::transform(edits.begin(), edits.end(), texts.begin(), std::mem_fn(&Edit::text));
  return texts;
}
std::string text_of(std::span<const Edit> edits) { return base::joined(texts_of(edits)); }

/// The refusal of edits that make a description wrong.
EditRefused refusal(std::span<const Edit> edits, const world::WorldError& error) {
  const std::size_t more = error.problems().size() - 1;
  return EditRefused(text_of(edits) + ": " + error.problems().front().message +
                     (more == 0 ? ""
                                : "; there " + std::string(more == 1 ? "is " : "are ") +
                                      base::counted(more, "more such problem")));
}

}  // namespace

void Simulation::Impl::edit(std::span<const Edit> edits) {
  if (std::all_of(edits.begin(), edits.end(),
                  [&](const Edit& one) { return in_place_->is_live(one); })) {
    set_in_place(edits);
    return;
  }
  EditTransaction transaction(*host_, seed_, time_s());
  try {
    become(edits, transaction);
  } catch (const EditRefused&) {
    throw;
  } catch (const PluginFault&) {
    throw;  // from a running plugin; it ends the run
  } catch (const world::WorldError& error) {
    throw refusal(edits, error);
  } catch (...) {
    throw EditRefused(text_of(edits) + ": " + base::what_was_thrown());
  }
  settle(transaction);
  take_stock();
  log_events();
}

/// The fast case: all attributes change in place, and no other objects are needed.
void Simulation::Impl::set_in_place(std::span<const Edit> edits) {
  const std::vector<InPlaceEdits::Placed> places = in_place_->make(edits, stage(), events_);
  if (!start_) start_ = std::make_shared<const world::World>(world_);
  std::map<std::size_t, bool> robots;  // true: its energy is set
  for (const Edit& edit : edits) {
    const std::vector<world::AttributeTarget> targets = in_place_->targets(edit);
    if (targets.empty()) {
      said_.notes.push_back(no_effect(edit.text()));
    }
    for (const world::AttributeTarget& target : targets) {
      if (!target.robot) continue;
      robots[target.robot_index] |= target.attribute && target.field.name == "energy";
      own_robot(target.robot_index);
    }
  }
  in_place_->describe(edits);
  for (const auto& [robot, has_new_energy] : robots) {
    robots_[robot]->take_live(false, has_new_energy);
  }
  std::vector<physics::Body> bodies;
  for (const InPlaceEdits::Placed& placed : places) {
    bodies.push_back(placed.body);
    const std::size_t i = placed.body.index;
    if (placed.body.kind == physics::BodyKind::obstacle) {
      engine_->place_obstacle(i, placed.pose);
      measuring_->place_box(i, placed.pose);
      continue;
    }
    engine_->place_robot(i, placed.pose, placed.z);
    robots_[i]->set_body(engine_->robot(i), engine_->joints(i), Arrival::placed);
    robots_[i]->take_segments(*engine_, i);
  }
  if (!places.empty()) hands_.follow(world_, robots_, engine_, bodies);
  take_stock();
  log_events();
  // Of edits in place, only those of speeds can cause warnings of the physics.
  if (std::any_of(edits.begin(), edits.end(),
                  [](const Edit& one) { return one.path.ends_with("@max_speed"); })) {
    note_new_warnings(world_, time_s(), said_.notes);
  }
}

Note Simulation::Impl::no_effect(const std::string& edit) const {
  return {"", "changes",
          "The edit " + edit + " at " + base::seconds_text(time_s()) +
              " leads to nothing in this world, and has no effect."};
}

/// Copies the description of a robot, which may then change, if another world shares it.
void Simulation::Impl::own_robot(std::size_t index) {
  if (!world_.robots.is_shared(index)) return;
  past_.push_back(world_.robots.kept(index));
  robots_[index]->describe(own_world_.robots[index]);
  in_place_->renew_robot(index);
}

std::vector<DueEdits> Simulation::Impl::checked(std::span<const TimedEdit> edits,
                                                std::span<const TimedEdit> given,
                                                std::vector<UnmadeEdits>& unmade) {
  std::vector<DueEdits> made;
  std::vector<EditRefused> refused;
  std::vector<Edit> in_place;         // all edits before the first that needs a new world
  bool needs_world = false;           // that edit has come
  std::optional<world::World> ahead;  // the world after it
  const auto refuse_live = [&] {
    std::vector<EditRefused> live = in_place_->refused(made, stage());
    std::move(live.begin(), live.end(), std::back_inserter(refused));
  };
  std::vector<DueEdits> coming = by_time(edits);
  for (std::size_t i = 0; i < coming.size(); ++i) {
    const DueEdits due = coming[i];
    const world::World& then = ahead ? *ahead : world_;
    const double end_s = options_.time_limit_s.value_or(then.limits.time);
    if (!due.come_before(end_s, then.physics.step)) {
      const std::string time = base::number_text(due.time_s) + " s";
      const std::string end = base::number_text(end_s) + " s at the latest";
      if (!due.given.empty()) {
        refused.emplace_back(due.given + ": its time is " + time +
                             ", but the run begins at 0 and ends after " + end +
                             "; expected a time in between, before the last step begins");
      } else {
        unmade.push_back(
            {due.from, "The edits at " + time + " are not made: the run ends after " + end + "."});
      }
      continue;
    }
    const auto is_live = [&](const Edit& one) { return in_place_->is_live(one); };
    if (!needs_world && std::all_of(due.edits.begin(), due.edits.end(), is_live)) {
      in_place.insert(in_place.end(), due.edits.begin(), due.edits.end());
      made.push_back(due);
      continue;
    }
    if (!std::exchange(needs_world, true)) {
      refuse_live();
      if (!refused.empty()) in_place.clear();  // the others are checked without them
    }
    try {
      world::World next =
          tried(ahead ? *ahead : edited(world::WorldTree(world_), in_place, false), due.edits);
      if (!same_schedule(then, next)) {
        coming.resize(i + 1);
        const auto others = by_time(still_to_come(next, given, due.time_s));
        coming.insert(coming.end(), others.begin(), others.end());
      }
      ahead = std::move(next);
      made.push_back(due);
    } catch (const EditRefused& why) {
      refused.push_back(why.at(due.time_s, due.from));
    } catch (const world::WorldError& error) {
      refused.push_back(refusal(due.edits, error).at(due.time_s, due.from));
    }
  }
  if (!needs_world) refuse_live();
  EditRefused::raise(std::move(refused));
  return made;
}

/// The world after these edits. Makes the objects that they concern once, because a plugin may not
/// fit its robot. Throws EditRefused or WorldError.
world::World Simulation::Impl::tried(const world::World& from, std::span<const Edit> edits) {
  world::World next = edited(world::WorldTree(from), edits, true);
  world::World concerned = next;
  concerned.robots.clear();
  concerned.measures.clear();
  concerned.rules.clear();
  const Pairs pairs(from, next);
  for (std::size_t i = 0; i < next.robots.size(); ++i) {
    if (!pairs.stays(i)) concerned.robots.share(next.robots, i);
  }
  std::vector<base::Problem> problems;
  try {
    const Impl made(std::move(concerned), *host_, options_);
  } catch (const world::WorldError& error) {
    problems = error.problems();
  }
  const Measuring measuring(next, *host_, options_.budget, problems);
  if (!problems.empty()) throw world::WorldError(std::move(problems));
  return next;
}

/// The world after these edits, checked like a file. Throws EditRefused.
world::World Simulation::Impl::edited(world::WorldTree&& from, std::span<const Edit> edits,
                                      bool check_plugins) {
  const world::World& was = from.world();
  world::ReadOptions options;
  options.data_directories = options_.data_directories;
  options.files = options_.files;
  options.check_plugins = check_plugins;
  options.edits = texts_of(edits);
  options.seed = seed_;
  options.time_limit_s = options_.time_limit_s;
  try {
    world::World next = world::edited(std::move(from), *host_, options);
    if (next.physics.engine == was.physics.engine) return next;
  } catch (const world::WorldError& error) {
    throw refusal(edits, error);
  }
  throw EditRefused(text_of(edits) + ": " + world::kEngineStays);
}

void Simulation::Impl::become(std::span<const Edit> edits, EditTransaction& transaction) {
  in_place_->take_tree();  // its values are stale since edits in place
  std::vector<EventRecord> events;
  for (const Edit& edit : edits) {
    for (const world::AttributeTarget& target : in_place_->targets(edit)) {
      transaction.ask(target);
      if (const auto box = placed_box(world_, target)) {
        transaction.ask(world_.obstacles[*box], target.field.name);
      }
      if (target.field.name == "id") {
        transaction.said().notes.push_back({"", "changes",
                                            "An edit at " + transaction.time() + " sets " +
                                                edit.text() +
                                                ": an object with another id is a new object and "
                                                "starts again."});
      }
    }
    std::vector<std::string> robots = in_place_->robots(edit);
    if (robots.empty()) {
      robots.emplace_back();  // an edit of the world
    }
    for (std::string& robot : robots) {
      events.push_back({time_s(), std::move(robot), events::Changed::of(edit.path, edit.value)});
    }
  }
  world::World next = edited(std::move(*in_place_->take_tree()), edits, false);
  for (const base::Problem& remark : next.remarks) {
    constexpr std::string_view kBefore = "--set ";
    transaction.said().notes.push_back(no_effect(remark.file.substr(kBefore.size())));
  }
  transaction.undo().add([this, count = events_.size()] { events_.resize(count); });
  events_.insert(events_.end(), events.begin(), events.end());
  become(std::move(next), transaction);
  for (base::Problem& problem : transaction.problems()) {
    throw EditRefused(text_of(edits) + ": " + problem.message);
  }
}

/// Asks rules that have not begun, once before a step, and makes the edits of all.
void Simulation::Impl::obey_rules() {
  if (!measuring_->has_rules() || std::exchange(obeyed_at_, steps_) == steps_) return;
  if (!measuring_->has_begun(PluginKind::rule)) {
    look(false, true);
    ask_rules(judgement_.outcome == Outcome::running, true);
  }
  for (const RuleEdits& due : std::exchange(by_rules_, {})) {
    const std::uint64_t rebuilds = rebuilds_;
    std::size_t event = events_.size();
    try {
      edit(due.edits);
    } catch (const EditRefused& refused) {
      throw refused.at(time_s(), due.from);
    }
    for (; event < events_.size(); ++event) {
      if (auto* const changed = std::get_if<events::Changed>(&events_[event].event)) {
        changed->rule = due.rule;
      }
    }
    if (rebuilds_ != rebuilds) measuring_->note_rebuilt(due.rule);
  }
}

}  // namespace elsie::simulation
