// Trials of behaviours, and the checks that behaviours and coordinators share.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "elsie/testing/behavior.h"

#include "text.h"
#include "trial.h"

namespace elsie::testing {

void Answer::add(const CommandSets& sets) {
  for (const FuzzySet* set : {&sets.left, &sets.right, &sets.lateral}) {
    for (const FuzzySet::Point& point : set->points) {
      add("a point of its fuzzy sets", point.x);
      add("a degree in its fuzzy sets", point.degree);
    }
  }
}

void Answer::add(const Motion& command) {
  add("its forward speed", command.forward);
  add("its lateral speed", command.lateral);
  add("its turn", command.turn);
}

std::optional<std::string> difference(const Answer& one, const Answer& other) {
  for (std::size_t i = 0; i < std::min(one.numbers.size(), other.numbers.size()); ++i) {
    const auto& [name, a] = one.numbers[i];
    const double b = other.numbers[i].value;
    if (a != b) {
      return std::string(name) + " is " + number_text(b) + ", and was " + number_text(a);
    }
  }
  if (one.numbers.size() != other.numbers.size()) {
    return "it has " + std::to_string(other.numbers.size()) + " numbers, and had " +
           std::to_string(one.numbers.size());
  }
  if (one.events != other.events) {
    return "its events, commands or messages, or the reasons in its trace, differ";
  }
  return std::nullopt;
}

void require_finite(const char* what, double value) {
  if (!std::isfinite(value)) {
    throw Wrong(std::string(what) + " is " + number_text(value) + ", which is no finite number");
  }
}

void require_finite(const Motion& command) {
  require_finite("its forward speed", command.forward);
  require_finite("its lateral speed", command.lateral);
  require_finite("its turn", command.turn);
}

void require_degree(const char* what, double value) {
  if (!(value >= 0.0 && value <= 1.0)) {
    throw Wrong(std::string(what) + " is " + number_text(value) + ", which is not in [0, 1]");
  }
}

void require_rating(std::span<const double> desirability) {
  for (const double degree : desirability) {
    require_degree("its rating of a candidate command", degree);
  }
}

void require_sets(const CommandSets& sets) {
  for (const FuzzySet* set : {&sets.left, &sets.right, &sets.lateral}) {
    double last = -std::numeric_limits<double>::infinity();
    for (const FuzzySet::Point& point : set->points) {
      require_finite("a point of its fuzzy sets", point.x);
      require_degree("a degree in its fuzzy sets", point.degree);
      if (point.x < last) {
        throw Wrong("the points of its fuzzy sets are not in ascending order: " +
                    number_text(point.x) + " comes after " + number_text(last));
      }
      last = point.x;
    }
  }
}

void require_declared(const Declaration& declaration, const std::vector<ReadingKind>& listened) {
  for (const ReadingKind& kind : listened) {
    if (std::none_of(declaration.hears.begin(), declaration.hears.end(),
                     [&](const HeardDeclaration& heard) { return heard.kind == kind.name; })) {
      throw Wrong("it reads messages of the kind '" + std::string(kind.name) +
                  "', which its declaration does not name; add elsie::hears<...>() to it");
    }
  }
}

std::span<const Motion> candidates() {
  static constexpr std::array<Motion, 6> kCandidates{Motion{},        {0.2, 0, 0}, {0, 0, 2.2},
                                                     {0.17, 0, -5.1}, {0, 0.1, 0}, {0, 0, 444}};
  return kCandidates;
}

namespace {

class BehaviorTrial final : public Trial {
 public:
  explicit BehaviorTrial(const TrialSetting& setting)
      : declaration_(setting.declaration),
        input_(setting.input),
        instants_(setting.input.instants),
        settings_(setting.settings),
        behavior_(setting.plugins, declaration_.name, setting.settings, setting.elements) {
    equipping([&] { behavior_.equip(instants_.front()); });
  }

  Component& object() override { return *behavior_; }
  void reset(std::uint64_t seed) override {
    behavior_.reset(seed);
    behavior_->notes();
  }
  void configure_again() override { behavior_.set(settings_); }

  bool take_over(Trial& before) override {
    return behavior_.take_over(static_cast<BehaviorTrial&>(before).behavior_);
  }

  void step(std::size_t step, Answer& answer) override {
    const std::size_t at = step % instants_.size();
    Situation& now = instants_[at];
    now.time(static_cast<double>(step) * now.period_s());
    behavior_.inside().answer = input_.wishes[at].front();
    const Response response = behavior_.respond(now);
    require_declared(declaration_, now.listened());
    answer.clear();
    tell(response, answer);
    std::vector<double> desirability(candidates().size());
    const Perception perceived = now.perception();
    behavior_->rate(perceived, response, candidates(), desirability);
    require_rating(desirability);
    for (const double degree : desirability) {
      answer.add("its rating of a candidate command", degree);
    }
    const CommandSets sets = behavior_->command_sets(perceived, response);
    require_sets(sets);
    answer.add(sets);
  }

 private:
  void tell(const Response& response, Answer& answer) const {
    require_finite(response.command);
    answer.add(response.command);
    const auto degree = [&](const char* what, double value) {
      require_degree(what, value);
      answer.add(what, value);
    };
    degree("its activation", response.activation);
    degree("its strength", response.strength);
    degree("its speed_strength", response.speed_strength);
    degree("its lateral_strength", response.lateral_strength);
    degree("its turn_strength", response.turn_strength);
    answer.add("whether it asks to be charged", response.charge);
    for (const Event& event : response.events) {
      const auto& declared = declaration_.events;
      if (std::none_of(declared.begin(), declared.end(),
                       [&](const EventDeclaration& other) { return other.name == event.name; })) {
        throw Wrong("it raises the event '" + std::string(event.name) +
                    "', which its declaration does not name; add elsie::raises() to it");
      }
      answer.events.emplace_back(event.name);
    }
    for (const Act& act : response.acts) {
      const auto& declared = declaration_.commands;
      if (act.by().empty() &&  // not of a behaviour inside it
          std::none_of(declared.begin(), declared.end(), [&](const ReadingDeclaration& other) {
            return other.kind == act.kind().name;
          })) {
        throw Wrong("it gives a command of the kind '" + std::string(act.kind().name) +
                    "', which its declaration does not name; add elsie::commands<...>() to it");
      }
      answer.events.push_back("command of the kind '" + std::string(act.kind().name) + "' to '" +
                              act.actuator() + "'");
    }
  }

  const Declaration& declaration_;
  const Input& input_;
  std::vector<Situation> instants_;
  Settings settings_;
  Behavior behavior_;
};

}  // namespace

std::unique_ptr<Trial> make_behavior_trial(const TrialSetting& setting) {
  return std::make_unique<BehaviorTrial>(setting);
}

std::unique_ptr<Trial> make_trial(const TrialSetting& setting) {
  switch (setting.declaration.kind) {
    case PluginKind::behavior:
      return make_behavior_trial(setting);
    case PluginKind::coordinator:
      return make_coordinator_trial(setting);
    case PluginKind::measure:
      return make_measure_trial(setting);
    case PluginKind::rule:
      return make_rule_trial(setting);
    case PluginKind::drive:
      return make_drive_trial(setting);
    case PluginKind::localisation:
      return make_localisation_trial(setting);
    case PluginKind::actuator:
      return make_actuator_trial(setting);
    case PluginKind::sensor:
      break;
  }
  return make_sensor_trial(setting);
}

}  // namespace elsie::testing
