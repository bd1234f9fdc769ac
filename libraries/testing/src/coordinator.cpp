#include "elsie/testing/coordinator.h"

#include "made.h"

namespace elsie::testing {

Coordinator::Coordinator(const std::string& name, Team& team, const Settings& settings,
                         const Elements& elements)
    : Coordinator(Plugins::found(), name, team, settings, elements) {}

Coordinator::Coordinator(const Plugins& plugins, const std::string& name, Team& team,
                         const Settings& settings, const Elements& elements)
    : plugins_(plugins),
      declaration_(&plugins_.declaration(PluginKind::coordinator, name)),
      team_(team),
      random_(1),
      object_(make<elsie::Coordinator>(plugins_, *declaration_, settings, elements,
                                       [](elsie::Coordinator&) {})) {}

Motion Coordinator::decide() {
  if (!equipped_) {
    equip(now);
  }
  if (!reset_) {
    reset();
  }
  team_.perceive(now).next_step();
  return given_ = object_->coordinate(team_.members(), now.perception().with_random(random_));
}

Motion Coordinator::decide(const Situation& situation) {
  now = situation;
  return decide();
}

Motion Coordinator::decide_at(double time_s) {
  now.time(time_s);
  return decide();
}

std::vector<Motion> Coordinator::decide(const Sequence& sequence) {
  std::vector<Motion> commands;
  for (const Situation& instant : sequence.instants()) {
    commands.push_back(decide(instant));
  }
  return commands;
}

std::size_t Coordinator::resolve(const std::string& actuator, const std::vector<Wish>& wishes) {
  std::vector<ActuatorWish> rivals;
  for (const Wish& wish : wishes) {
    rivals.push_back({&team_.member(wish.member), &wish.act});
  }
  return object_->resolve(actuator, rivals);
}

std::vector<double> Coordinator::rate(const std::vector<Motion>& candidates) {
  std::vector<double> desirability(candidates.size());
  object_->rate(team_.members(), now.perception().with_random(random_), given_, candidates,
                desirability);
  return desirability;
}

CommandSets Coordinator::sets() {
  return object_->command_sets(team_.members(), now.perception().with_random(random_), given_);
}

void Coordinator::reset(std::uint64_t seed) {
  seed_ = seed;
  random_ = Random(seed);
  object_->reset(random_);
  reset_ = true;
}

bool Coordinator::take_over(Coordinator& before) {
  reset(before.seed_);
  random_ = before.random_;
  given_ = before.given_;
  return hand_over(*before.object_, *object_);
}

void Coordinator::equip(const Situation& example) {
  object_->equipped(team_.members(), example.perception());
  equipped_ = true;
}

}  // namespace elsie::testing
