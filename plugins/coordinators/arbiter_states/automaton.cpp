#include "automaton.h"

#include <algorithm>
#include <functional>
#include <stdexcept>

#include <elsie/base/near_name.h>
#include <elsie/base/number_text.h>

#include "member_names.h"

namespace {

std::string quoted(const std::string& name) { return "'" + name + "'"; }

/// "transition[2] of the state 'dig'": the second of its transitions.
std::string in_words(const Transition& transition, const State& of) {
  const std::size_t number = static_cast<std::size_t>(&transition - of.transitions.data()) + 1;
  return "transition[" + std::to_string(number) + "] of the state " + quoted(of.name);
}

/// When a transition is taken, for a drawing.
std::string words(const Way& way) {
  const Transition& transition = *way.described;
  std::string text = transition.event;
  const auto add = [&](bool is_given, const std::string& words) {
    if (is_given) text += (text.empty() ? "" : " ") + words;
  };
  const auto number = [](double value) { return elsie::base::number_text(value); };
  add(!transition.when.empty(), "[" + transition.when + "]");
  add(transition.after > 0.0, "after " + number(transition.after) + " s");
  add(transition.chance < 1.0, "chance " + number(transition.chance));
  return text;
}

}  // namespace

Automaton::Automaton(const std::vector<State>& states) {
  if (states.empty()) throw std::invalid_argument("it has no states; expected <state> inside it");
  add(states, kNowhere);
  for (Place& place : places_) resolve(place);
}

void Automaton::add(const std::vector<State>& held, std::size_t within) {
  for (const State& state : held) {
    if (state.name.empty()) {
      throw std::invalid_argument(
          "state[" + std::to_string(&state - held.data() + 1) + "]" +
          (within == kNowhere ? "" : " in " + quoted(places_[within].described->name)) +
          " has an empty name");
    }
    for (const Place& other : places_) {
      if (other.described->name == state.name) {
        throw std::invalid_argument("two states are called " + quoted(state.name) +
                                    "; expected names that differ, also of states in states");
      }
    }
    if (!state.behavior.empty() && !state.states.empty()) {
      throw std::invalid_argument("the state " + quoted(state.name) +
                                  " has a behavior and states in it; expected one of them");
    }
    const std::size_t own = places_.size();
    places_.push_back({&state, "state " + state.name, within, {}, {}, {}});
    if (!state.states.empty()) places_[own].first_inside = own + 1;
    add(state.states, own);
  }
}

void Automaton::resolve(Place& place) {
  for (const Transition& transition : place.described->transitions) {
    const std::string it = in_words(transition, *place.described);
    Way way{&transition, 0, {}};
    const auto to = std::find_if(places_.begin(), places_.end(), [&](const Place& other) {
      return other.described->name == transition.to;
    });
    if (to == places_.end()) {
      std::vector<std::string> names;
      for (const Place& other : places_) names.push_back(other.described->name);
      throw std::invalid_argument(it + " leads to " + quoted(transition.to) +
                                  ", which is no state" +
                                  elsie::base::near_or_all(transition.to, names, "there are"));
    }
    if (transition.event.empty() && transition.when.empty() && transition.after == 0.0 &&
        transition.chance == 1.0) {
      throw std::invalid_argument(it + " to " + quoted(transition.to) +
                                  " says not when; expected event, when, after or chance");
    }
    way.to = static_cast<std::size_t>(to - places_.begin());
    if (!transition.when.empty()) {
      try {
        way.when.emplace(transition.when);
      } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(it + ", when=\"" + transition.when + "\": " + error.what());
      }
    }
    place.ways.push_back(std::move(way));
  }
}

void Automaton::equip(std::span<const elsie::Member> members, const elsie::Perception& example) {
  unused_.clear();
  for (const elsie::Member& member : members) unused_.emplace_back(member.name());
  MemberNames names;
  names.read(members);
  for (Place& place : places_) {
    const std::string& behavior = place.described->behavior;
    if (!behavior.empty()) {
      place.member = names.find("state", "behavior", behavior);
      std::erase(unused_, behavior);
    }
  }
  names.throw_problems();
  for (Place& place : places_) {
    for (Way& way : place.ways) {
      if (!way.when) continue;
      try {
        way.when->equip(members, example);
      } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(in_words(*way.described, *place.described) + ": " +
                                    error.what());
      }
    }
  }
}

std::vector<std::string> Automaton::notes() const {
  std::vector<std::string> notes;
  const std::vector<bool> reached = reachable();
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const State& state = *places_[i].described;
    if (!reached[i]) {
      notes.push_back("the state " + quoted(state.name) + " is never reached from the first one");
    } else if (state.ends == "no" && places_.size() > 1 && !has_exit(i)) {
      notes.push_back("the state " + quoted(state.name) +
                      " is never left: neither it nor a state around it has a transition "
                      "elsewhere; write ends=\"success\" or \"failure\" if this is meant");
    }
  }
  for (const std::string& name : unused_) {
    notes.push_back("the behavior " + quoted(name) + " is in no state, and never runs");
  }
  return notes;
}

elsie::Graph Automaton::graph() const {
  elsie::Graph graph;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    graph.nodes.push_back({places_[i].described->name, static_cast<int>(places_[i].within)});
    for (const Way& way : places_[i].ways) graph.edges.push_back({i, way.to, words(way)});
  }
  return graph;
}

std::vector<bool> Automaton::reachable() const {
  std::vector<bool> reached(places_.size(), false);
  const std::function<void(std::size_t)> visit = [&](std::size_t place) {
    place = innermost(place);
    for (std::size_t i = place; i != kNowhere; i = places_[i].within) {
      if (reached[i]) continue;
      reached[i] = true;
      for (const Way& way : places_[i].ways) {
        if (way.described->chance > 0.0) visit(way.to);
      }
    }
  };
  visit(0);
  return reached;
}

bool Automaton::has_exit(std::size_t place) const {
  if (places_[place].first_inside) return true;  // its inner states are asked
  for (std::size_t i = place; i != kNowhere; i = places_[i].within) {
    for (const Way& way : places_[i].ways) {
      if (way.described->chance > 0.0 && innermost(way.to) != place) return true;
    }
  }
  return false;
}
