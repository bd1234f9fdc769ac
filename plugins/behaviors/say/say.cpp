// Tells other robots where something has happened, or which way it looks.
#include <algorithm>
#include <stdexcept>
#include <string>

#include <elsie/api/behavior.h>
#include <elsie/api/remember.h>
#include <elsie/messages/heading.h>
#include <elsie/messages/say.h>

namespace {

class Say final : public elsie::Behavior, public elsie::Remembers {
 public:
  std::string what = "place";
  std::string event;
  double lasts = 5.0;
  std::string to;

  void configured() override { says_heading_ = what == "heading"; }
  void equipped(const elsie::Perception& example) override {
    if (!to.empty() && to == example.self().id) {
      throw std::invalid_argument("it speaks to its own robot '" + to + "'; expected another one");
    }
  }
  void reset(elsie::Random&) override {
    place_ = {};
    until_s_ = -1.0;
    says_ = false;
  }
  void remember(elsie::Memory& memory) override {
    memory("x", place_.x);
    memory("y", place_.y);
    memory("until_s", until_s_);
    memory("says", says_);
  }

  elsie::Response respond(const elsie::Perception& now) override {
    const auto& events = now.events();
    if (event.empty() || std::any_of(events.begin(), events.end(), [&](const elsie::Event& each) {
          return each.name == event;
        })) {
      place_ = {static_cast<float>(now.self().pose.x), static_cast<float>(now.self().pose.y)};
      until_s_ = now.time_s() + lasts;
    }
    elsie::Response response;
    if (now.time_s() <= until_s_) {
      if (says_heading_) {
        response.say(elsie::HeadingMessage{static_cast<float>(now.self().pose.heading_rad)}, to);
      } else {
        response.say(place_, to);
      }
      says_ = true;
    } else if (says_) {
      // Once: in other periods, another behaviour may speak.
      response.act(elsie::SayCommand{});  // silence
      says_ = false;
    }
    return response;
  }

 private:
  bool says_heading_ = false;
  elsie::PlaceMessage place_;
  double until_s_ = -1.0;
  bool says_ = false;
};

}  // namespace

ELSIE_BEHAVIOR(
    Say, "say", "Tells other robots where it was when an event happened, or which way it looks",
    elsie::only_acts(), elsie::commands<elsie::SayCommand>(), elsie::names_event("event"),
    elsie::parameter("what", &Say::what,
                     {.choices = {"place", "heading"},
                      .meaning = "`place`: where it was at the event; `heading`: its heading now"}),
    elsie::parameter("event", &Say::event,
                     {.meaning = "of the robot: its own behaviours' or the simulator's; without "
                                 "one it always speaks"}),
    elsie::parameter("lasts", &Say::lasts,
                     {.unit = "s", .min = 0, .max = 1e9, .meaning = "how long it repeats this"}),
    elsie::parameter("to", &Say::to,
                     {.meaning = "the id of a robot; without one, all that hear it"}));
