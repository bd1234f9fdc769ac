// Visits places in turn, again and again or once, or in a random order.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "arrival.h"
#include "going.h"
#include "inactive.h"

namespace {

struct Place {
  double x = 0.0;
  double y = 0.0;
  double wait = 0.0;
};

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

class Patrol final : public elsie::Behavior, public Going, public elsie::Remembers {
 public:
  std::vector<Place> places{{}};  // where a world gives none
  std::string order = "round";
  double tolerance = 0.05;

  void configured() override {
    if (places.empty()) throw std::invalid_argument("it has no place; expected <place> inside it");
    is_random_ = order == "random";
    is_once_ = order == "once";
  }
  void reset(elsie::Random&) override {
    next_ = -1;
    arrival_.reset();
    is_done_ = false;
  }
  void remember(elsie::Memory& memory) override {
    memory("next", next_);
    arrival_.remember(memory);
    memory("leaves_s", leaves_s_);
    memory("is_done", is_done_);
  }

  elsie::Response respond(const elsie::Perception& now) override {
    if (next_ < 0) next_ = is_random_ ? draw(places.size(), now) : 0;
    elsie::Response response;
    const elsie::Pose& here = now.self().pose;
    if (is_done_) {
      // It returns to an only place from which it was pushed.
      const bool stays = places.size() == 1 && away(here) <= tolerance;
      if (is_once_ || stays) {
        response = inactive();
        response.status = elsie::Status::success;
        return response;
      }
      is_done_ = false;
    }
    if (arrival_.step(away(here) <= tolerance, true)) {  // it waits, even if it is pushed away
      leaves_s_ = now.time_s() + places[index()].wait;
      response.events.push_back({"at_place"});
    }
    if (arrival_.is_there() && now.time_s() >= leaves_s_) leave(now, response);
    if (is_done_) {
      response.activation = response.strength = 0.0;
      response.status = elsie::Status::success;
    } else if (!arrival_.is_there()) {
      response.command = towards(here, places[index()].x, places[index()].y, away(here));
    }
    return response;
  }

  double place() const { return next_ < 0 || is_done_ ? kNone : static_cast<double>(index() + 1); }

 private:
  /// There may be fewer places after a change.
  std::size_t index() const { return static_cast<std::size_t>(next_) % places.size(); }

  double away(const elsie::Pose& here) const {
    return std::hypot(places[index()].x - here.x, places[index()].y - here.y);
  }

  void leave(const elsie::Perception& now, elsie::Response& response) {
    arrival_.reset();
    const int count = static_cast<int>(places.size()), last = static_cast<int>(index());
    const bool is_last = last + 1 == count;
    is_done_ = count == 1 || (is_once_ && is_last);
    if (is_last && !is_random_) response.events.push_back({"patrolled"});
    if (is_random_ && count > 1) {
      // Any of the others.
      next_ = draw(places.size() - 1, now);
      if (next_ >= last) ++next_;
    } else {
      next_ = is_last ? 0 : last + 1;
    }
  }

  static int draw(std::size_t count, const elsie::Perception& now) {
    return static_cast<int>(now.random().uniform() * static_cast<double>(count));
  }

  bool is_random_ = false;
  bool is_once_ = false;
  int next_ = -1;          // the place that it drives to or waits at; -1: not chosen yet
  Arrival arrival_;        // at that place
  double leaves_s_ = 0.0;  // when it has waited there for long enough
  bool is_done_ = false;
};

}  // namespace

ELSIE_BEHAVIOR(
    Patrol, "patrol", "Visits places in turn, or in a random order, and may wait at each",
    elsie::elements(
        &Patrol::places,
        elsie::element<Place>(
            "place", "a place to visit",
            elsie::parameter("x", &Place::x, {.unit = "m", .meaning = "where it is, east"}),
            elsie::parameter("y", &Place::y, {.unit = "m", .meaning = "where it is, north"}),
            elsie::parameter(
                "wait", &Place::wait,
                {.unit = "s", .min = 0, .max = 1e9, .meaning = "how long it stands there"}))),
    elsie::parameter(
        "order", &Patrol::order,
        {.choices = {"round", "once", "random"},
         .meaning = "`round`: as in the file, again and again; `once`: the same, once; "
                    "`random`: each time any other place"}),
    speed_of_going(), gain_of_going(), slow_down_of_going(),
    elsie::parameter("tolerance", &Patrol::tolerance,
                     {.unit = "m", .above = 0, .meaning = "nearer than this, it is at a place"}),
    elsie::raises("at_place", "it has come to the next place"),
    elsie::raises("patrolled", "it leaves the last place, not in a random order"),
    elsie::publishes(
        "place", &Patrol::place,
        {.meaning =
             "number of the place that it drives to or waits at, from 1; none: it is done"}));
