// The states of an automaton, and the ways between them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "condition.h"

struct Transition {
  std::string to;
  std::string event;
  std::string when;
  double after = 0.0;
  double chance = 1.0;
};

struct State {
  std::string name;
  std::string behavior;
  std::string ends = "no";
  std::vector<Transition> transitions;
  std::vector<State> states;
};

/// A transition whose names have been looked up.
struct Way {
  const Transition* described;
  std::size_t to = 0;
  std::optional<Condition> when;
};

/// A state whose names have been looked up. Inner states come after the one that holds them.
struct Place {
  const State* described;
  std::string reason;  // in the trace: "state search"
  std::size_t within;  // the index of the state around it
  std::optional<std::size_t> first_inside;
  std::vector<Way> ways;
  std::optional<std::size_t> member;
};

class Automaton {
 public:
  static constexpr auto kNowhere = static_cast<std::size_t>(-1);  // around the outermost states

  Automaton() = default;
  /// The states must outlive it. Throws std::invalid_argument with a sentence.
  explicit Automaton(const std::vector<State>& states);

  /// Finds behaviours and what conditions name. Throws std::invalid_argument with a sentence.
  void equip(std::span<const elsie::Member> members, const elsie::Perception& example);

  std::vector<Place>& places() { return places_; }
  const std::vector<Place>& places() const { return places_; }
  /// The state in which one is who enters this one.
  std::size_t innermost(std::size_t place) const {
    while (places_[place].first_inside) place = *places_[place].first_inside;
    return place;
  }
  /// What looks like a mistake: states that are never reached or left, behaviours of no state.
  std::vector<std::string> notes() const;
  elsie::Graph graph() const;

 private:
  void add(const std::vector<State>& held, std::size_t within);
  void resolve(Place& place);
  std::vector<bool> reachable() const;
  bool has_exit(std::size_t place) const;

  std::vector<Place> places_;
  std::vector<std::string> unused_;  // behaviours
};
