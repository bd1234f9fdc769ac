#include "robot/controller.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "elsie/base/number_text.h"

namespace elsie::simulation {
namespace {

std::string text(const Motion& motion) {
  return "forward " + base::number_text(motion.forward) + " m/s, lateral " +
         base::number_text(motion.lateral) + " m/s, turn " + base::number_text(motion.turn) +
         " rad/s";
}

/// Faults the plugin if these are not fuzzy sets.
void require_sets(const CommandSets& sets, const world::PluginUse& use, Guard& guard) {
  for (const FuzzySet* set : {&sets.left, &sets.right, &sets.lateral}) {
    double last = -std::numeric_limits<double>::infinity();
    for (const FuzzySet::Point& point : set->points) {
      if (!std::isfinite(point.x) || point.x < last ||
          !(point.degree >= 0.0 && point.degree <= 1.0)) {
        guard.fail(
            use, "the points of its fuzzy sets are not in ascending order with degrees in [0, 1]");
      }
      last = point.x;
    }
  }
}

/// What is said may still be under way when a newer library replaces the speaker's.
void keep_message(const PluginObject& speaker, Act& act) {
  if (!(act.kind() == ReadingKind::of<SayCommand>())) return;
  SayCommand said = *static_cast<const SayCommand*>(act.command());
  if (!said.message) return;
  said.message = speaker.lasting(said.message);
  act = Act(act.actuator(), std::move(said));
}

void require_degrees(std::span<const double> desirability, const world::PluginUse& use,
                     Guard& guard) {
  for (const double degree : desirability) {
    if (!(degree >= 0.0 && degree <= 1.0)) {
      guard.fail(use,
                 "it rates a command " + base::number_text(degree) + ", which is not in [0, 1]");
    }
  }
}

}  // namespace

Controller::Controller(const world::Coordination& description, const plugin::Host& host,
                       const Setting& setting, std::vector<base::Problem>& problems)
    : description_(&description), setting_(setting) {
  slots_.reserve(description.behaviors.size());
  for (const world::BehaviorUse& use : description.behaviors) {
    slots_.push_back(make_slot(use, host, problems));
    slots_.back()->place = slots_.size() - 1;
  }
  sort_slots();
  list_slots();
  make_coordinator(host, problems);
}

std::shared_ptr<Controller::Slot> Controller::make_slot(const world::BehaviorUse& use,
                                                        const plugin::Host& host,
                                                        std::vector<base::Problem>& problems) {
  auto slot = std::make_shared<Slot>(use, host);
  if (slot->declaration && slot->declaration->hold) {
    slot->inside = std::make_unique<Controller>(inside_of(use), host, setting_, problems);
  }
  slot->make(host, problems);
  return slot;
}

const world::Coordination& Controller::inside_of(const world::BehaviorUse& use) {
  static const world::Coordination kNothing;
  return use.inside.empty() ? kNothing : use.inside.front();
}

void Controller::sort_slots() {
  const auto actors = std::stable_partition(slots_.begin(), slots_.end(),
                                            [](const auto& slot) { return !slot->only_acts(); });
  movers_ = static_cast<std::size_t>(actors - slots_.begin());
}

void Controller::list_slots() {
  Member::Runner& runner = *this;
  std::vector<Member> members;
  members.reserve(slots_.size());
  for (const auto& slot : slots_) {
    members.emplace_back(use_of(*slot).id, use_of(*slot).priority, runner);
  }
  take_members(std::move(members));
}

void Controller::make_coordinator(const plugin::Host& host, std::vector<base::Problem>& problems) {
  coordinator_.reset();
  if (description_->coordinator) {
    coordinator_ = std::make_shared<CoordinatorSlot>(*description_->coordinator, host, *this);
    coordinator_->make(host, problems);
  }
}

void Controller::for_each(Order order, const std::string& path, const std::string& within,
                          const Visit& visit) const {
  for (const auto& slot : slots_) {
    const std::string name = path + "behavior[" + slot->use->id + "]";
    if (order == Order::outer_first) visit(*slot, name, within);
    if (slot->inside) {
      slot->inside->for_each(order, name + "/", within + slot->use->id + "/", visit);
    }
    if (order == Order::inner_first) visit(*slot, name, within);
  }
  if (coordinator_) visit(*coordinator_, path + "coordinator", within);
}

void Controller::begin_run() {
  list_slots();
  for (const auto& slot : slots_) {
    if (slot->inside) slot->inside->begin_run();
  }
  command_ = {};
}

void Controller::give(Member& member, double priority) {
  if (member.priority() == priority) return;
  Member changed(member.name(), priority, *this);
  changed.trace = member.trace;
  member = std::move(changed);
}

void Controller::take_priorities() {
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    give(members_[i], use_of(*slots_[i]).priority);
    if (slots_[i]->inside) slots_[i]->inside->take_priorities();
  }
}

bool Controller::set_priority(std::size_t& index, double priority) {
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    if (index-- == 0) {
      give(members_[i], priority);
      return true;
    }
    if (slots_[i]->inside && slots_[i]->inside->set_priority(index, priority)) return true;
  }
  return false;
}

void Controller::begin_step() {
  for (std::size_t i = 0; i < members_.size(); ++i) {
    members_[i].begin_step();
    if (slots_[i]->inside) slots_[i]->inside->begin_step();
  }
}

Motion Controller::decide(const Perception& now) {
  now_ = now;
  if (!coordinator_) {
    choose_acts();
    return {};
  }
  command_ = setting_.guard.step(*coordinator_, [&] {
    return coordinator_->object().coordinate(movers(), now.with_random(coordinator_->random));
  });
  setting_.guard.check();
  if (!command_.is_finite()) {
    setting_.guard.fail(*coordinator_->use,
                        "its command is not a finite number: " + text(command_));
  }
  check_trace();
  choose_acts();
  return command_;
}

void Controller::choose_acts() {
  acts_.clear();
  for (Member& member : std::span(members_).subspan(movers_)) {
    member.respond();
    member.trace.reason = "only acts";
  }
  struct Wish : ActuatorWish {
    std::size_t actuator;
  };
  std::vector<Wish> wishes;
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const TraceRow& trace = members_[i].trace;
    if (!trace.asked || trace.inhibited_by >= 0) continue;
    const Slot& slot = *slots_[i];
    for (std::size_t k = 0; k < slot.response.acts.size(); ++k) {
      wishes.push_back({{&members_[i], &slot.response.acts[k]}, slot.actuators[k]});
    }
  }
  std::stable_sort(wishes.begin(), wishes.end(),
                   [](const Wish& a, const Wish& b) { return a.actuator < b.actuator; });
  std::vector<ActuatorWish> rivals;
  for (auto first = wishes.begin(); first != wishes.end();) {
    const std::size_t actuator = first->actuator;
    rivals.clear();
    for (; first != wishes.end() && first->actuator == actuator; ++first) {
      // Of one behaviour, the last holds.
      if (!rivals.empty() && rivals.back().member == first->member) rivals.pop_back();
      rivals.push_back(*first);
    }
    const std::size_t chosen =
        rivals.size() == 1 ? 0
        : !coordinator_
            ? greatest_priority(rivals)
            : setting_.guard.step(*coordinator_, [&] {
                return coordinator_->object().resolve(setting_.requests.actuator(actuator), rivals);
              });
    if (chosen > rivals.size()) {
      setting_.guard.fail(*coordinator_->use, "resolve() chooses wish " + std::to_string(chosen) +
                                                  " of " + std::to_string(rivals.size()));
    }
    if (chosen < rivals.size()) {
      acts_.push_back({actuator, rivals[chosen].act->within(rivals[chosen].member->name())});
    }
  }
}

void Controller::forget_acts() {
  acts_.clear();
  for (const auto& slot : slots_) {
    slot->response.acts.clear();
    if (slot->inside) slot->inside->forget_acts();
  }
}

Response Controller::respond(const Perception& now) {
  Response response = decide(now);
  if (coordinator_) {
    response.status =
        setting_.guard.step(*coordinator_, [&] { return coordinator_->object().status(); });
  }
  for (const ChosenAct& chosen : acts_) response.acts.push_back(chosen.act);
  double shares = 0.0, activation = 0.0, strength = 0.0, speed = 0.0, lateral = 0.0, turn = 0.0;
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const TraceRow& trace = members_[i].trace;
    const Response& answer = slots_[i]->response;  // of an earlier step if not asked now; harmless:
    const double share = std::max(0.0, trace.share);
    const double share_of_strength = share * trace.strength;  // zero then
    shares += share;
    activation += share * trace.activation;
    strength += share_of_strength;
    speed += share_of_strength * answer.speed_strength;
    lateral += share_of_strength * answer.lateral_strength;
    turn += share_of_strength * answer.turn_strength;
  }
  const auto ratio = [](double part, double whole) {
    return whole > 0.0 ? std::clamp(part / whole, 0.0, 1.0) : 0.0;
  };
  response.activation = ratio(activation, shares);
  response.strength = ratio(strength, shares);
  if (strength > 0.0) {  // factors: strength times factor is the mean of such products
    response.speed_strength = ratio(speed, strength);
    response.lateral_strength = ratio(lateral, strength);
    response.turn_strength = ratio(turn, strength);
  }
  return response;
}

void Controller::rate(std::span<const Motion> candidates, std::span<double> desirability) {
  if (!coordinator_) {
    std::fill(desirability.begin(), desirability.end(), 0.0);
    return;
  }
  setting_.guard.step(*coordinator_, [&] {
    coordinator_->object().rate(movers(), now_->with_random(coordinator_->random), command_,
                                candidates, desirability);
  });
  setting_.guard.check();
  require_degrees(desirability, *coordinator_->use, setting_.guard);
}

CommandSets Controller::command_sets() {
  if (!coordinator_) return {};
  CommandSets sets = setting_.guard.step(*coordinator_, [&] {
    return coordinator_->object().command_sets(movers(), now_->with_random(coordinator_->random),
                                               command_);
  });
  setting_.guard.check();
  require_sets(sets, *coordinator_->use, setting_.guard);
  return sets;
}

const Response& Controller::run(Member& member) {
  Slot& slot = slot_of(member);
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = setting_.measure_time ? Clock::now() : Clock::time_point();
  setting_.guard.step(slot, [&] {
    // Assigned here, so that memory of the last answer counts as freed.
    slot.response = slot.object().respond(now_->with_random(slot.random));
  });
  if (setting_.measure_time) {
    member.trace.time_s = std::chrono::duration<double>(Clock::now() - start).count();
  }
  check(slot, slot.response);
  for (const Event& event : slot.response.events) setting_.requests.raise(event);
  if (slot.response.charge) setting_.requests.ask_for_charge();
  slot.actuators.clear();
  for (Act& act : slot.response.acts) {
    if (act.by().empty()) keep_message(slot, act);  // not of one inside
    slot.actuators.push_back(
        setting_.guard.run(*slot.use, [&] { return setting_.requests.actuator_for(act); }));
  }
  return slot.response;
}

void Controller::rate(Member& member, std::span<const Motion> candidates,
                      std::span<double> desirability) {
  Slot& slot = slot_of(member);
  setting_.guard.step(slot, [&] {
    slot.object().rate(now_->with_random(slot.random), slot.response, candidates, desirability);
  });
  require_degrees(desirability, *slot.use, setting_.guard);
}

CommandSets Controller::command_sets(Member& member) {
  Slot& slot = slot_of(member);
  CommandSets sets = setting_.guard.step(slot, [&] {
    return slot.object().command_sets(now_->with_random(slot.random), slot.response);
  });
  require_sets(sets, *slot.use, setting_.guard);
  return sets;
}

double Controller::published(const Member& member, std::size_t number) const {
  const Slot& slot = slot_of(member);
  const double value = setting_.guard.run(
      *slot.use, [&] { return slot.declaration->published.at(number).get(slot.object()); });
  return std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN();
}

void Controller::check(const Slot& slot, const Response& response) const {
  const auto fail = [&](const std::string& problem) { setting_.guard.fail(*slot.use, problem); };
  if (!response.command.is_finite()) {
    fail("its command is not a finite number: " + text(response.command));
  }
  if (!std::isfinite(response.matters_rad.value_or(0.0))) {
    fail("the direction that matters to it is not a finite number");
  }
  for (const auto& [what, value] :
       {std::pair("activation", response.activation), std::pair("strength", response.strength),
        std::pair("speed_strength", response.speed_strength),
        std::pair("lateral_strength", response.lateral_strength),
        std::pair("turn_strength", response.turn_strength)}) {
    if (!(value >= 0.0 && value <= 1.0)) [[unlikely]] {
      fail(std::string("its ") + what + " is " + base::number_text(value) +
           ", which is not in [0, 1]");
    }
  }
  for (const Event& event : response.events) {
    const auto& declared = slot.declaration->events;
    if (std::none_of(declared.begin(), declared.end(),
                     [&](const EventDeclaration& d) { return d.name == event.name; })) {
      fail("it raised the event '" + std::string(event.name) +
           "', which its declaration does not name; add elsie::raises() to it");
    }
  }
}

void Controller::check_trace() {
  const auto fail = [&](const std::string& problem) {
    setting_.guard.fail(*coordinator_->use, problem);
  };
  for (const Member& member : members_) {
    const TraceRow& trace = member.trace;
    if (trace.inhibited_by >= static_cast<int>(members_.size())) {
      fail("its trace says that member " + std::to_string(trace.inhibited_by) +
           " inhibits another, but there is no such member");
    }
    if (!std::isfinite(trace.weight) || !std::isfinite(trace.share)) {
      fail("a weight or share in its trace is not finite");
    }
    constexpr double kRounding = 1e-9;
    if (trace.share < -kRounding || trace.share > 1.0 + kRounding) {
      fail("the share of '" + std::string(member.name()) + "' in its trace is " +
           base::number_text(trace.share) + "; expected a part of the whole command, from 0 to 1");
    }
    if (trace.weight < 0.0 && member.priority() >= 0.0) {
      fail("the weight of '" + std::string(member.name()) + "' in its trace is " +
           base::number_text(trace.weight) +
           "; expected 0 or more, unless the user set a priority below 0");
    }
  }
}

void Controller::list_members(const std::string& path, int depth, int parent,
                              std::vector<TracedMember>& list) const {
  const std::string_view coordinator =
      coordinator_ ? std::string_view(coordinator_->use->plugin) : "";
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const std::string name = path + slots_[i]->use->id;
    list.push_back({name, slots_[i]->use->plugin, coordinator, depth, parent, &members_[i]});
    if (slots_[i]->inside) {
      slots_[i]->inside->list_members(name + "/", depth + 1, static_cast<int>(list.size()) - 1,
                                      list);
    }
  }
}

void Controller::list_graphs(const std::string& path, std::vector<LitGraph>& list) const {
  if (coordinator_) {
    const auto& object = coordinator_->object();
    LitGraph shown{path + coordinator_->use->id, coordinator_->use->plugin, {}, {}};
    setting_.guard.look(*coordinator_->use, [&] {
      shown.graph = object.graph();
      shown.lights.resize(shown.graph.nodes.size());
      object.light(shown.lights);
    });
    const std::size_t count = shown.graph.nodes.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (shown.graph.nodes[i].within >= static_cast<int>(i)) {
        setting_.guard.fail(*coordinator_->use,
                            "a node of its graph comes before the one around it");
      }
    }
    for (const Graph::Edge& edge : shown.graph.edges) {
      if (edge.from >= count || edge.to >= count) {
        setting_.guard.fail(*coordinator_->use, "an edge of its graph leads to no node");
      }
    }
    if (!shown.graph.empty()) list.push_back(std::move(shown));
  }
  for (const auto& slot : slots_) {
    if (slot->inside) slot->inside->list_graphs(path + slot->use->id + "/", list);
  }
}

void Controller::list_inferences(const std::string& path, std::vector<MadeInference>& list) const {
  const auto add = [&](const PluginObject& object) {
    const auto* infers = dynamic_cast<const Infers*>(object.held.get());
    if (!infers) return;
    std::vector<Inference> made;
    setting_.guard.look(*object.use, [&] { infers->list_inferences(made); });
    for (Inference& each : made) list.push_back({path + object.use->id, std::move(each)});
  };
  if (coordinator_) add(*coordinator_);
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    if (members_[i].trace.asked) {
      add(*slots_[i]);
      if (slots_[i]->inside) {
        slots_[i]->inside->list_inferences(path + slots_[i]->use->id + "/", list);
      }
    }
  }
}

}  // namespace elsie::simulation
