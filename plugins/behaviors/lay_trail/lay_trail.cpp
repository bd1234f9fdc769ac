// Lays a trail with a pen, always or between two events: ants lay one on their way home from food.
#include <string>

#include <elsie/api/behavior.h>
#include <elsie/api/remember.h>
#include <elsie/commands/pen.h>

namespace {

class LayTrail final : public elsie::Behavior, public elsie::Remembers {
 public:
  std::string pen;
  double flow = 1.0;
  std::string from;
  std::string until;

  void reset(elsie::Random&) override {
    lays_ = from.empty();
    is_down_ = false;
  }

  elsie::Response respond(const elsie::Perception& now) override {
    for (const elsie::Event& event : now.events()) {
      if (event.name == until) lays_ = false;
      if (event.name == from) lays_ = true;
    }
    elsie::Response response;
    // It lifts the pen once: in other periods, another behaviour may use it.
    if (lays_ || is_down_) response.act(pen, elsie::PenCommand{lays_ ? flow : 0.0});
    is_down_ = lays_;
    return response;
  }

  void remember(elsie::Memory& memory) override {
    memory("lays", lays_);
    memory("is_down", is_down_);
  }

 private:
  bool lays_ = true;
  bool is_down_ = false;  // the pen, by its last command
};

}  // namespace

ELSIE_BEHAVIOR(LayTrail, "lay_trail", "Lays a trail with a pen", elsie::only_acts(),
               elsie::commands<elsie::PenCommand>(), elsie::names_event("from"),
               elsie::names_event("until"),
               elsie::parameter("pen", &LayTrail::pen,
                                {.meaning = "the id of the pen; by default the robot's first"}),
               elsie::parameter("flow", &LayTrail::flow,
                                {.min = 0, .max = 1, .meaning = "part of the pen's rate"}),
               elsie::parameter("from", &LayTrail::from,
                                {.meaning = "the event on which it begins; by default at the start",
                                 .live = false}),
               elsie::parameter("until", &LayTrail::until,
                                {.meaning = "the event on which it ends; by default never"}));
