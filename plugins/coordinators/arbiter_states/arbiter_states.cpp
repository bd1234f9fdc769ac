// A finite-state automaton over behaviours: temporal sequencing, after Arkin and MacKenzie,
// "Temporal coordination of perceptual algorithms for mobile robot navigation", IEEE Transactions
// on Robotics and Automation 10(3), 1994. States may hold states, as in Harel's statecharts (1987);
// transitions by chance are those of AutoMoDe (Francesca and others, 2014).
#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <elsie/api/remember.h>

#include "automaton.h"
#include "winner.h"

namespace {

constexpr auto kNowhere = Automaton::kNowhere;

class ArbiterStates final : public WinnerTakesAll, public elsie::Remembers {
 public:
  std::vector<State> states;

  void configured() override {
    automaton_ = Automaton(states);
    restore();
  }

  void equipped(std::span<const elsie::Member> members, const elsie::Perception& example) override {
    automaton_.equip(members, example);
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
    const Place& place = places()[now_];
    if (!place.member) return nobody(members, "no behavior in this state");
    return let_decide(members, *place.member, place.reason.c_str(), "other state");
  }

  elsie::Status status() const override {
    for (std::size_t i = now_; i != kNowhere; i = places()[i].within) {
      const std::string& ends = places()[i].described->ends;
      if (ends != "no") return ends == "success" ? elsie::Status::success : elsie::Status::failure;
    }
    return elsie::Status::running;
  }

  std::vector<std::string> notes() const override { return automaton_.notes(); }
  elsie::Graph graph() const override { return automaton_.graph(); }
  void light(std::span<elsie::NodeState> nodes) const override {
    for (std::size_t i = now_; i != kNowhere; i = places()[i].within) {
      nodes[i] = elsie::NodeState::running;
    }
  }

  /// The number of the present state, from 1, in the order of the file.
  double number() const { return static_cast<double>(now_ + 1); }

 private:
  const std::vector<Place>& places() const { return automaton_.places(); }

  /// After a change: the state in which it was, if there still is one of that name; else it begins
  /// anew. States around it that are new are as old as it is.
  void restore() {
    const auto was = std::find_if(places().begin(), places().end(), [&](const Place& place) {
      return !active_.empty() && place.described->name == active_[0].name && !place.first_inside;
    });
    now_ = was == places().end() ? automaton_.innermost(0)
                                 : static_cast<std::size_t>(was - places().begin());
    const std::vector<Active> before = std::exchange(active_, {});
    if (was == places().end()) return;
    for (std::size_t i = now_; i != kNowhere; i = places()[i].within) {
      const std::string& name = places()[i].described->name;
      const auto known = std::find_if(before.begin(), before.end(),
                                      [&](const Active& each) { return each.name == name; });
      active_.push_back({name, known == before.end() ? before[0].since_s : known->since_s});
    }
  }

  /// Takes the first transition whose time has come: those of the present state before those of the
  /// states around it.
  void leave(std::span<const elsie::Member> members, const elsie::Perception& now) {
    std::size_t around = 0;
    for (std::size_t i = now_; i != kNowhere; i = places()[i].within, ++around) {
      for (Way& way : automaton_.places()[i].ways) {
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
    now_ = automaton_.innermost(place);
    for (std::size_t i = now_; i != kNowhere; i = places()[i].within) {
      const std::string& name = places()[i].described->name;
      const auto known = std::find_if(before.begin(), before.end(),
                                      [&](const Active& each) { return each.name == name; });
      active_.push_back({name, is_new || known == before.end() ? time_s : known->since_s});
      is_new &= i != place;
    }
  }

  Automaton automaton_;
  std::size_t now_ = 0;  // the present state, which has no states in it
  /// It and the states around it, from inside outwards, by their names: they outlive changes.
  /// Empty: no decision was made.
  struct Active {
    std::string name;
    double since_s;  // when it was entered
  };
  std::vector<Active> active_;
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
