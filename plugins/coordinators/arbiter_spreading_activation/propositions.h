// Propositions about the robot's situation: what it perceives, what happened, and where it is.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include <elsie/api/coordinator.h>
#include <elsie/api/remember.h>

#include "condition.h"

/// True while a condition holds.
struct Perceives {
  std::string name;
  std::string when;
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
  using Members = std::span<const elsie::Member>;

  /// Takes these, and finds what they mean on this robot. Calls refuse() with a sentence for each
  /// that means nothing there.
  template <class Refuse>
  void use(const std::vector<Proposition>& propositions, Members members,
           const elsie::Perception& example, Refuse refuse) {
    propositions_ = propositions;
    states_.clear();
    for (const Proposition& proposition : propositions_) {
      State& state = states_.emplace_back();
      if (const auto* recalled = std::get_if<Recalls>(&proposition)) {
        if (recalled->event == recalled->until) {
          refuse("<recalls name=\"" + recalled->name + "\"> has the same event and 'until'; it " +
                 "would never be false again");
        }
      } else if (const auto* perceived = std::get_if<Perceives>(&proposition)) {
        try {
          state.condition.emplace(perceived->when);
          state.condition->equip(members, example);
        } catch (const std::invalid_argument& error) {
          refuse("<perceives name=\"" + perceived->name + "\">: " + error.what());
        }
      }
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
  std::uint64_t update(Members members, const elsie::Perception& now) {
    std::uint64_t all = 0;
    for (std::size_t i = 0; i < propositions_.size(); ++i) {
      State& state = states_[i];
      state.is_true = std::visit([&](const auto& each) { return holds(each, state, members, now); },
                                 propositions_[i]);
      all |= state.is_true ? std::uint64_t{1} << i : 0;
    }
    return all;
  }

 private:
  struct State {
    bool is_true = false;
    double since_s = 0.0;
    std::optional<Condition> condition;
  };

  static bool holds(const Perceives&, State& state, Members members, const elsie::Perception& now) {
    return state.condition->holds(members, now);
  }
  static bool holds(const Recalls& what, State& state, Members, const elsie::Perception& now) {
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
  static bool holds(const Place& what, State& state, Members, const elsie::Perception& now) {
    const elsie::Pose& here = now.self().pose;
    return (what.keeps && state.is_true) ||
           std::hypot(what.x - here.x, what.y - here.y) <= what.radius;
  }

  std::vector<Proposition> propositions_;
  std::vector<State> states_;
};
