#include "elsie/testing/team.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "elsie/base/near_name.h"

namespace elsie::testing {

Response active(double activation, const Motion& command) {
  Response response(command);
  response.activation = activation;
  return response;
}

Team& Team::member(const std::string& name, double priority, Response answer) {
  Slot& slot = slots_.emplace_back();
  slot.name = name;
  slot.behavior.answer = std::move(answer);
  Member::Runner& runner = *this;
  members_.emplace_back(slot.name, priority, runner);
  return *this;
}

Team& Team::member(const std::string& name, double priority, Script script) {
  member(name, priority, Response());
  slots_.back().behavior.script = std::move(script);
  return *this;
}

Team& Team::rating(std::function<double(const Motion&)> rating) {
  slots_.at(slots_.size() - 1).behavior.rating = std::move(rating);
  return *this;
}

Team& Team::sets(CommandSets sets) {
  slots_.at(slots_.size() - 1).behavior.sets = std::move(sets);
  return *this;
}

Team& Team::publishes(const std::string& name, std::function<double()> value) {
  slots_.at(slots_.size() - 1)
      .published.push_back(
          {name, {}, [value = std::move(value)](const Component&) { return value(); }});
  return *this;
}

Team& Team::next_step() {
  for (Member& member : members_) {
    member.begin_step();
  }
  return *this;
}

Team& Team::perceive(const Situation& now) {
  now_ = &now;
  return *this;
}

std::size_t Team::index_of(const std::string& name) const {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    if (slots_[i].name == name) {
      return i;
    }
    names.emplace_back(slots_[i].name);
  }
  throw std::invalid_argument("there is no member '" + name + "' in the team" +
                              base::did_you_mean(name, names));
}

Response MadeUp::respond(const Perception& now) {
  ++asked;
  return script ? script(now) : answer;
}

void MadeUp::rate(const Perception& now, const Response& given, std::span<const Motion> candidates,
                  std::span<double> desirability) const {
  if (rating) {
    std::transform(candidates.begin(), candidates.end(), desirability.begin(), rating);
  } else {
    Behavior::rate(now, given, candidates, desirability);
  }
}

CommandSets MadeUp::command_sets(const Perception& now, const Response& given) const {
  return sets ? *sets : Behavior::command_sets(now, given);
}

const Response& Team::run(Member& member) {
  Slot& slot = slot_of(member);
  return slot.last = slot.behavior.respond(now_->perception());
}

void Team::rate(Member& member, std::span<const Motion> candidates,
                std::span<double> desirability) {
  slot_of(member).behavior.rate(now_->perception(), member.respond(), candidates, desirability);
}

CommandSets Team::command_sets(Member& member) {
  return slot_of(member).behavior.command_sets(now_->perception(), member.respond());
}

}  // namespace elsie::testing
