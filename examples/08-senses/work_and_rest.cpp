// Works in a circle, and rests at a charger when its battery sensor says so.
#include <cmath>

#include <elsie/api/behavior.h>
#include <elsie/readings/battery.h>

class WorkAndRest final : public elsie::Behavior {
 public:
  double low = 0.4;

  elsie::Response respond(const elsie::Perception& now) override {
    const double charge = now.readings<elsie::BatteryReading>()[0]->charge;
    rests_ = charge < (rests_ ? 0.99 : low);
    const auto& charger = now.team().charger;
    if (!rests_ || !charger) return elsie::Motion{0.3, 0.0, 0.5};
    const elsie::Pose& here = now.self().pose;
    const double way_m = std::hypot(charger->x - here.x, charger->y - here.y);
    const double off = elsie::bearing(here, charger->x, charger->y);
    elsie::Response response =
        elsie::Motion{way_m < 0.05 ? 0.0 : 0.3 * std::max(0.0, std::cos(off)), 0.0,
                      way_m < 0.05 ? 0.0 : 2.0 * off};
    response.charge = way_m < 0.1;
    return response;
  }
  void reset(elsie::Random&) override { rests_ = false; }

 private:
  bool rests_ = false;
};

ELSIE_BEHAVIOR(WorkAndRest, "work_and_rest", "Works, and rests at a charger in time",
               elsie::needs<elsie::BatteryReading>(),
               elsie::parameter("low", &WorkAndRest::low,
                                {.min = 0, .max = 1, .meaning = "the charge at which it rests"}));
