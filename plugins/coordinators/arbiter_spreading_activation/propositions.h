// Propositions about the robot's situation: what it perceives, what happened, and where it is.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include <elsie/api/perception.h>
#include <elsie/api/remember.h>

#include "perception_inputs.h"

/// A bound that was not given.
inline constexpr double kOpen = 1e9;

/// True while an input is within bounds.
struct Perceives {
  std::string name;
  std::string input;
  double above = -kOpen;
  double below = kOpen;
};
/// True from an event on: until another, or for a time.
struct Recalls {
  std::string name;
  std::string event;
  std::string until;
  double for_s = 0.0;  // 0: for ever
  bool initially = false;
};
/// True at a place; or from then on.
struct Place {
  std::string name;
  double x = 0.0;
  double y = 0.0;
  double radius = 0.2;
  bool keeps = false;
};
using Proposition = std::variant<Perceives, Recalls, Place>;

inline const std::string& name_of(const Proposition& proposition) {
  return std::visit([](const auto& each) -> const std::string& { return each.name; }, proposition);
}

class Situation {
 public:
  /// What is wrong with one of them, as a sentence; "": nothing.
  static std::string problem_of(const Proposition& proposition, const elsie::Perception& example) {
    if (const auto* recalled = std::get_if<Recalls>(&proposition);
        recalled && recalled->event == recalled->until) {
      return "<recalls name=\"" + recalled->name + "\"> has the same event and 'until'; it would " +
             "never be false again";
    }
    const auto* perceived = std::get_if<Perceives>(&proposition);
    if (!perceived) return "";
    const std::string text = "<perceives name=\"" + perceived->name + "\">";
    const PerceptionInput* input = find_perception_input(perceived->input);
    if (!input) {
      return text + " has the input '" + perceived->input + "', which no robot perceives" +
             perception_input_hint(perceived->input);
    }
    if (!input->available(example)) {
      return text + " has the input '" + perceived->input + "', which needs " + input->needs +
             ", and there is none";
    }
    if (perceived->above <= -kOpen && perceived->below >= kOpen) {
      return text + " is always true; give it 'above' or 'below'";
    }
    return perceived->above < perceived->below
               ? ""
               : text + " is never true: 'above' must be less than 'below'";
  }

  void use(const std::vector<Proposition>& propositions) {
    propositions_ = propositions;
    states_.assign(propositions_.size(), {});
    for (std::size_t i = 0; i < propositions_.size(); ++i) {
      const auto* perceived = std::get_if<Perceives>(&propositions_[i]);
      states_[i].input = perceived ? find_perception_input(perceived->input) : nullptr;
    }
    reset();
  }
  void reset() {
    for (std::size_t i = 0; i < propositions_.size(); ++i) {
      const auto* recalled = std::get_if<Recalls>(&propositions_[i]);
      states_[i].is_true = recalled && recalled->initially;
      states_[i].since_s = 0.0;
    }
  }
  void remember(elsie::Memory& memory) {
    for (std::size_t i = 0; i < propositions_.size(); ++i) {
      memory("is " + name_of(propositions_[i]), states_[i].is_true);
      memory("since " + name_of(propositions_[i]), states_[i].since_s);
    }
  }

  /// The true ones, a bit each. To be called in every step: events last for one.
  std::uint64_t update(const elsie::Perception& now) {
    std::uint64_t all = 0;
    for (std::size_t i = 0; i < propositions_.size(); ++i) {
      State& state = states_[i];
      state.is_true =
          std::visit([&](const auto& each) { return holds(each, state, now); }, propositions_[i]);
      all |= state.is_true ? std::uint64_t{1} << i : 0;
    }
    return all;
  }

 private:
  struct State {
    bool is_true = false;
    double since_s = 0.0;
    const PerceptionInput* input = nullptr;
  };

  static bool holds(const Perceives& what, State& state, const elsie::Perception& now) {
    const double value = state.input->value(now);
    return value > what.above && value < what.below;
  }
  static bool holds(const Recalls& what, State& state, const elsie::Perception& now) {
    bool is_true = state.is_true;
    if (what.for_s > 0.0 && now.time_s() - state.since_s > what.for_s + 1e-9) {
      is_true = false;
    }
    for (const elsie::Event& event : now.events()) {
      if (event.name == what.event) {
        is_true = true;
        state.since_s = now.time_s();
      } else if (event.name == what.until) {
        is_true = false;
      }
    }
    return is_true;
  }
  static bool holds(const Place& what, State& state, const elsie::Perception& now) {
    const elsie::Pose& here = now.self().pose;
    return (what.keeps && state.is_true) ||
           std::hypot(what.x - here.x, what.y - here.y) <= what.radius;
  }

  std::vector<Proposition> propositions_;
  std::vector<State> states_;
};
