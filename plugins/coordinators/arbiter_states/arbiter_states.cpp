// A finite-state automaton over behaviours: temporal sequencing, after Arkin and MacKenzie,
// "Temporal coordination of perceptual algorithms for mobile robot navigation", IEEE Transactions
// on Robotics and Automation 10(3), 1994. States may hold states, as in Harel's statecharts (1987);
// transitions by chance are those of AutoMoDe (Francesca and others, 2014).
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <elsie/api/remember.h>
#include <elsie/base/near_name.h>
#include <elsie/base/number_text.h>

#include "condition.h"
#include "winner.h"

namespace {

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
  std::size_t within;  // the index of the state around it
  std::optional<std::size_t> first_inside;
  std::vector<Way> ways;
  std::optional<std::size_t> member;
};

constexpr auto kNowhere = static_cast<std::size_t>(-1);  // around the outermost states

std::string quoted(const std::string& name) { return "'" + name + "'"; }

class ArbiterStates final : public WinnerTakesAll, public elsie::Remembers {
 public:
  std::vector<State> states;

  void configured() override {
    places_.clear();
    if (states.empty()) throw std::invalid_argument("it has no states; expected <state> inside it");
    add(states, kNowhere);
    for (Place& place : places_) resolve(place);
    restore();
  }

  void equipped(std::span<const elsie::Member> members, const elsie::Perception& example) override {
    unused_.clear();
    for (const elsie::Member& member : members) unused_.emplace_back(member.name());
    for (Place& place : places_) {
      const std::string& behavior = place.described->behavior;
      if (!behavior.empty()) {
        place.member = index_of(members, behavior);
        std::erase(unused_, behavior);
      }
      for (Way& way : place.ways) {
        if (way.when) way.when->equip(members, example);
      }
    }
  }

  void reset(elsie::Random&) override {
    active_.clear();
    restore();
  }

  void remember(elsie::Memory& memory) override {
    std::string names;
    std::vector<double> since_s;
    for (const Active& each : active_) {
      names += each.name + "\n";
      since_s.push_back(each.since_s);
    }
    memory("states", names);
    memory("since", since_s);
    if (!memory.recalls()) return;
    active_.clear();
    std::istringstream lines(names);
    for (const double since : since_s) {
      std::string name;
      std::getline(lines, name);
      active_.push_back({name, since});
    }
    restore();
  }

  elsie::Motion coordinate(std::span<elsie::Member> members,
                           const elsie::Perception& now) override {
    if (active_.empty()) {
      enter(0, now.time_s());
    } else {
      leave(members, now);
    }
    const Place& place = places_[now_];
    if (!place.member) return nobody(members, "no behavior in this state");
    const elsie::Motion command = let_decide(members, *place.member, "", "other state");
    members[*place.member].trace.reason = "state " + place.described->name;
    return command;
  }

  elsie::Status status() const override {
    for (std::size_t i = now_; i != kNowhere; i = places_[i].within) {
      const std::string& ends = places_[i].described->ends;
      if (ends != "no") return ends == "success" ? elsie::Status::success : elsie::Status::failure;
    }
    return elsie::Status::running;
  }

  std::vector<std::string> notes() const override {
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

  elsie::Graph graph() const override {
    elsie::Graph graph;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      graph.nodes.push_back({places_[i].described->name, static_cast<int>(places_[i].within)});
      for (const Way& way : places_[i].ways) graph.edges.push_back({i, way.to, words(way)});
    }
    return graph;
  }
  void light(std::span<elsie::NodeState> nodes) const override {
    for (std::size_t i = now_; i != kNowhere; i = places_[i].within) {
      nodes[i] = elsie::NodeState::running;
    }
  }

  /// The number of the present state, from 1, in the order of the file.
  double number() const { return static_cast<double>(now_ + 1); }

 private:
  void add(const std::vector<State>& held, std::size_t within) {
    for (const State& state : held) {
      if (state.name.empty()) throw std::invalid_argument("a state has an empty name");
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
      places_.push_back({&state, within, {}, {}, {}});
      if (!state.states.empty()) places_[own].first_inside = own + 1;
      add(state.states, own);
    }
  }

  void resolve(Place& place) {
    const std::string of = " of the state " + quoted(place.described->name);
    for (const Transition& transition : place.described->transitions) {
      Way way{&transition, 0, {}};
      const auto to = std::find_if(places_.begin(), places_.end(), [&](const Place& other) {
        return other.described->name == transition.to;
      });
      if (to == places_.end()) {
        std::vector<std::string> names;
        for (const Place& other : places_) names.push_back(other.described->name);
        throw std::invalid_argument("a transition" + of + " leads to " + quoted(transition.to) +
                                    ", which is no state" +
                                    elsie::base::near_or_all(transition.to, names, "there are"));
      }
      if (transition.event.empty() && transition.when.empty() && transition.after == 0.0 &&
          transition.chance == 1.0) {
        throw std::invalid_argument("the transition" + of + " to " + quoted(transition.to) +
                                    " says not when; expected event, when, after or chance");
      }
      way.to = static_cast<std::size_t>(to - places_.begin());
      if (!transition.when.empty()) {
        try {
          way.when.emplace(transition.when);
        } catch (const std::invalid_argument& error) {
          throw std::invalid_argument("when=\"" + transition.when + "\"" + of + ": " +
                                      error.what());
        }
      }
      place.ways.push_back(std::move(way));
    }
  }

  /// After a change: the state in which it was, if there still is one of that name; else it begins
  /// anew. States around it that are new are as old as it is.
  void restore() {
    const auto was = std::find_if(places_.begin(), places_.end(), [&](const Place& place) {
      return !active_.empty() && place.described->name == active_[0].name && !place.first_inside;
    });
    now_ = was == places_.end() ? innermost(0) : static_cast<std::size_t>(was - places_.begin());
    const std::vector<Active> before = std::exchange(active_, {});
    if (was == places_.end()) return;
    for (std::size_t i = now_; i != kNowhere; i = places_[i].within) {
      const std::string& name = places_[i].described->name;
      const auto known = std::find_if(before.begin(), before.end(),
                                      [&](const Active& each) { return each.name == name; });
      active_.push_back({name, known == before.end() ? before[0].since_s : known->since_s});
    }
  }

  /// The state in which one is who enters this one.
  std::size_t innermost(std::size_t place) const {
    while (places_[place].first_inside) place = *places_[place].first_inside;
    return place;
  }

  /// Takes the first transition whose time has come: those of the present state before those of the
  /// states around it.
  void leave(std::span<const elsie::Member> members, const elsie::Perception& now) {
    std::size_t around = 0;
    for (std::size_t i = now_; i != kNowhere; i = places_[i].within, ++around) {
      for (Way& way : places_[i].ways) {
        if (is_due(way, now.time_s() - active_[around].since_s, members, now)) {
          return enter(way.to, now.time_s());
        }
      }
    }
  }

  bool is_due(Way& way, double time_in_state_s, std::span<const elsie::Member> members,
              const elsie::Perception& now) const {
    constexpr double kRounding = 1e-9;  // s
    const Transition& transition = *way.described;
    if (time_in_state_s + kRounding < transition.after) return false;
    if (!transition.event.empty() && !perceives(now, transition.event)) return false;
    if (way.when && !way.when->holds(members, now)) return false;
    if (transition.chance >= 1.0) return true;
    // Of an event, each time; else in a second, however long the control period is.
    const double chance = transition.event.empty()
                              ? -std::expm1(now.period_s() * std::log1p(-transition.chance))
                              : transition.chance;
    return now.random().chance(chance);
  }

  /// States around both the old and the new one are not entered again.
  void enter(std::size_t place, double time_s) {
    const std::vector<Active> before = std::exchange(active_, {});
    bool is_new = true;  // what is at the place, or inside
    now_ = innermost(place);
    for (std::size_t i = now_; i != kNowhere; i = places_[i].within) {
      const std::string& name = places_[i].described->name;
      const auto known = std::find_if(before.begin(), before.end(),
                                      [&](const Active& each) { return each.name == name; });
      active_.push_back({name, is_new || known == before.end() ? time_s : known->since_s});
      is_new &= i != place;
    }
  }

  std::vector<bool> reachable() const {
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

  bool has_exit(std::size_t place) const {
    if (places_[place].first_inside) return true;  // its inner states are asked
    for (std::size_t i = place; i != kNowhere; i = places_[i].within) {
      for (const Way& way : places_[i].ways) {
        if (way.described->chance > 0.0 && innermost(way.to) != place) return true;
      }
    }
    return false;
  }

  static std::string words(const Way& way) {
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

  std::vector<Place> places_;
  std::size_t now_ = 0;  // the present state, which has no states in it
  /// It and the states around it, from inside outwards, by their names: they outlive changes.
  /// Empty: no decision was made.
  struct Active {
    std::string name;
    double since_s;  // when it was entered
  };
  std::vector<Active> active_;
  std::vector<std::string> unused_;
};

}  // namespace

ELSIE_COORDINATOR(
    ArbiterStates, "arbiter_states",
    "A finite-state automaton: the behaviour of the present state decides",
    elsie::elements(
        &ArbiterStates::states,
        elsie::element<State>(
            "state", "a state; the first one is where it begins", elsie::nests(&State::states),
            elsie::parameter("name", &State::name,
                             {.meaning = "what transitions call it", .required = true}),
            elsie::parameter("behavior", &State::behavior,
                             {.meaning = "who decides in it; empty: the robot stands, or states "
                                         "in it say who"}),
            elsie::parameter("ends", &State::ends,
                             {.choices = {"no", "success", "failure"},
                              .meaning = "how the whole ends in it, for who waits for that"}),
            elsie::elements(
                &State::transitions,
                elsie::element<Transition>(
                    "transition",
                    "a way to another state, when all that it says holds; the first one is taken",
                    elsie::parameter("to", &Transition::to,
                                     {.meaning = "the name of a state", .required = true}),
                    elsie::parameter("event", &Transition::event,
                                     {.meaning = "an event that the robot perceives"}),
                    elsie::parameter("when", &Transition::when,
                                     {.meaning = "a condition over what the robot perceives"}),
                    elsie::parameter(
                        "after", &Transition::after,
                        {.unit = "s", .min = 0, .meaning = "so long after the state was entered"}),
                    elsie::parameter("chance", &Transition::chance,
                                     {.min = 0,
                                      .max = 1,
                                      .meaning = "probability to take it, at each event; without "
                                                 "an event, in a second"}))))),
    elsie::names_event("transition/event"),
    elsie::publishes("state", &ArbiterStates::number,
                     {.meaning = "the number of the present state, in the order of the file"}));
