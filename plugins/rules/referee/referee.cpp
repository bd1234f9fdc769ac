// Ends the run when something has happened.
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <elsie/api/rule.h>
#include <elsie/base/number_text.h>

namespace {

struct AfterEvents {
  std::string event;
  int count = 1;
};
struct Outside {
  double x = 0.0, y = 0.0, radius = 1.0;
};
struct Closer {
  double distance = 0.1;
};
struct AfterTime {
  double time = 60.0;
};
using Condition = std::variant<AfterEvents, Outside, Closer, AfterTime>;

std::string number(double value) { return elsie::base::number_text(value, 6); }

class Referee final : public elsie::Rule {
 public:
  std::string outcome = "failure";
  std::string robot;
  std::string team;
  std::vector<Condition> conditions;

  void configured() override {
    if (conditions.empty()) {
      throw std::invalid_argument(
          "it never ends a run; expected <event>, <outside>, <closer> or <after> inside it");
    }
    if (!robot.empty() && !team.empty()) {
      throw std::invalid_argument("it names both a robot, '" + robot + "', and a team, '" + team +
                                  "'; expected one of them, or none for all robots");
    }
    counts_.resize(conditions.size());
  }
  void equipped(const elsie::Observation& start) override {
    if (!robot.empty()) start.robot(robot);
    if (!team.empty()) start.require_team(team);
  }
  void reset(elsie::Random&) override { counts_.assign(conditions.size(), 0); }

  void apply(const elsie::Observation& now, elsie::WorldChanges& world) override {
    for (std::size_t i = 0; i < conditions.size(); ++i) {
      const std::string reason = std::visit(
          [&](const auto& condition) { return holds(condition, now, counts_[i]); }, conditions[i]);
      if (reason.empty()) continue;
      outcome == "success" ? world.succeed(reason) : world.fail(reason);
      return;
    }
  }

 private:
  bool is_chosen(const elsie::ObservedRobot& each) const {
    return (robot.empty() || each.id == robot) && (team.empty() || each.team == team);
  }
  bool is_chosen(std::string_view id, const elsie::Observation& now) const {
    if (robot.empty() && team.empty()) return true;
    for (const elsie::ObservedRobot& each : now.robots) {
      if (each.id == id) return is_chosen(each);
    }
    return false;
  }

  // Each returns the reason if the condition holds, else "".

  std::string holds(const AfterEvents& after, const elsie::Observation& now, int& count) const {
    for (const elsie::ObservedEvent& event : now.events) {
      if (event.name == after.event && is_chosen(event.robot, now)) ++count;
    }
    if (count < after.count) return "";
    return "the event '" + after.event + "' was raised " +
           (count == 1 ? "once" : std::to_string(count) + " times");
  }
  std::string holds(const Outside& zone, const elsie::Observation& now, int&) const {
    for (const elsie::ObservedRobot& each : now.robots) {
      if (is_chosen(each) && std::hypot(each.pose.x - zone.x, each.pose.y - zone.y) > zone.radius) {
        return "the robot '" + std::string(each.id) + "' is more than " + number(zone.radius) +
               " m away from (" + number(zone.x) + ", " + number(zone.y) + ")";
      }
    }
    return "";
  }
  std::string holds(const Closer& limit, const elsie::Observation& now, int&) const {
    for (std::size_t i = 0; i < now.robots.size(); ++i) {
      for (std::size_t k = i + 1; k < now.robots.size(); ++k) {
        const elsie::ObservedRobot &a = now.robots[i], &b = now.robots[k];
        if ((is_chosen(a) || is_chosen(b)) && elsie::distance(a.pose, b.pose) < limit.distance) {
          return "the robots '" + std::string(a.id) + "' and '" + std::string(b.id) +
                 "' are closer than " + number(limit.distance) + " m";
        }
      }
    }
    return "";
  }
  std::string holds(const AfterTime& after, const elsie::Observation& now, int&) const {
    return now.time_s >= after.time - 0.5 * now.step_s ? number(after.time) + " s have passed" : "";
  }

  std::vector<int> counts_;  // of events, for each condition
};

}  // namespace

ELSIE_RULE(
    Referee, "referee", "Ends the run when one of several things has happened",
    elsie::names_event("event/name"),
    elsie::parameter("outcome", &Referee::outcome,
                     {.choices = {"success", "failure"}, .meaning = "how the run then ends"}),
    elsie::parameter("robot", &Referee::robot,
                     {.meaning = "only this one counts; by default all robots"}),
    elsie::parameter("team", &Referee::team, {.meaning = "only those of this team count"}),
    elsie::elements(
        &Referee::conditions,
        elsie::element<AfterEvents>(
            "event", "an event was raised so often",
            elsie::parameter("name", &AfterEvents::event,
                             {.meaning = "`collision`, `collected`...", .required = true}),
            elsie::parameter("count", &AfterEvents::count, {.min = 1, .meaning = "how often"})),
        elsie::element<Outside>(
            "outside", "the middle of a robot is outside of a circle",
            elsie::parameter("x", &Outside::x, {.unit = "m", .meaning = "its middle, east"}),
            elsie::parameter("y", &Outside::y, {.unit = "m", .meaning = "its middle, north"}),
            elsie::parameter("radius", &Outside::radius,
                             {.unit = "m", .above = 0, .meaning = "its radius"})),
        elsie::element<Closer>("closer", "the middles of two robots come closer",
                               elsie::parameter("distance", &Closer::distance,
                                                {.unit = "m", .above = 0, .meaning = "than this"})),
        elsie::element<AfterTime>(
            "after", "so much simulated time has passed",
            elsie::parameter("time", &AfterTime::time,
                             {.unit = "s", .min = 0, .meaning = "how much"}))));
