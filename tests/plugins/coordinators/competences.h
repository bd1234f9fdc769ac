// Competences, propositions and members for the tests of spreading activation.
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "support.h"

namespace elsie::test::maes {

using std::string;

inline ElementValue competence(const char* of, const char* needs, const char* adds,
                               const char* deletes = "") {
  return {"competence",
          {{"of", string(of)},
           {"needs", string(needs)},
           {"adds", string(adds)},
           {"deletes", string(deletes)}}};
}
inline ElementValue recalls(const char* name, const char* event, const char* until = "",
                            bool initially = false) {
  return {"recalls",
          {{"name", string(name)},
           {"event", string(event)},
           {"until", string(until)},
           {"initially", initially}}};
}
inline ElementValue place(const char* name, double x, bool keeps = false, double radius = 0.1) {
  return {"place", {{"name", string(name)}, {"x", x}, {"radius", radius}, {"keeps", keeps}}};
}
inline ElementValue perceives(const char* name, const char* when) {
  return {"perceives", {{"name", string(name)}, {"when", string(when)}}};
}

inline Motion forwards(double speed) { return {speed, 0.0, 0.0}; }

/// Members that all drive, by these names, with a coordinator. Each decision is a step of the
/// network unless the interval says otherwise.
class Society {
 public:
  Society(const std::vector<const char*>& names, const char* goals,
          const std::vector<ElementValue>& elements, Parameters parameters = {})
      : robot_(make(names, team_), team_, with(goals, std::move(parameters)), elements) {
    robot_.now.period(0.1);
  }

  /// The name of the one that decides in the next step; "": nobody.
  string step() {
    now().time(0.1 * steps_++);
    robot_.decide();
    for (const Member& member : team_.members()) {
      if (member.trace.share == 1.0) {
        return string(member.name());
      }
    }
    return "";
  }
  /// The first one that decides.
  string first() {
    for (int tries = 0; tries < 200; ++tries) {
      if (const string name = step(); !name.empty()) {
        return name;
      }
    }
    return "";
  }
  double level(const char* name) { return team_.trace(name).weight; }  // its part of all
  string reason(const char* name) { return team_.trace(name).reason; }
  double published(const string& name) {
    for (const PublishedNumber& number : robot_.declaration().published) {
      if (number.name == name) {
        return number.get(*robot_);
      }
    }
    return std::numeric_limits<double>::quiet_NaN();
  }
  Situation& now() { return robot_.now; }
  Coordinated& robot() { return robot_; }
  Team& team() { return team_; }

 private:
  static const char* make(const std::vector<const char*>& names, Team& team) {
    double speed = 0.1;
    for (const char* name : names) {
      team.member(name, 1, forwards(speed));
      speed += 0.1;
    }
    return "arbiter_spreading_activation";
  }
  static Parameters with(const char* goals, Parameters parameters) {
    parameters["goals"] = string(goals);
    return parameters;
  }

  Team team_;
  Coordinated robot_;
  int steps_ = 0;
};

/// Fetch a key, open a door with it, go through: nothing is true at first.
inline std::vector<ElementValue> errand() {
  return {competence("fetch", "", "key"),      competence("open", "key", "door"),
          competence("enter", "door", "home"), recalls("key", "fetched"),
          recalls("door", "opened"),           recalls("home", "entered")};
}

}  // namespace elsie::test::maes
