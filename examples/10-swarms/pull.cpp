// Stick pulling (Ijspeert, Martinoli, Billard and Gambardella 2001): a stick is too long for one
// robot. A robot that finds one grips it and waits for another one to help; after a while it gives
// up and looks elsewhere, because all might wait at sticks of their own.
#include <algorithm>
#include <cmath>

#include <elsie/api/behavior.h>
#include <elsie/commands/gripper.h>
#include <elsie/readings/omnidirectional_camera.h>

constexpr elsie::Colour kStick{150, 90, 30};

class Pull final : public elsie::Behavior {
 public:
  double patience = 15.0;  // s
  double rest = 5.0;       // s

  void reset(elsie::Random&) override {
    lets_go_s_ = -1.0;
    is_helped_ = false;
    looks_from_s_ = 0.0;
  }

  elsie::Response respond(const elsie::Perception& now) override {
    elsie::Response response;
    bool closed = false;
    if (!now.self().held.empty()) {
      if (lets_go_s_ < 0.0) lets_go_s_ = now.time_s() + patience;
      if (now.self().held.front().moves && !is_helped_) {
        is_helped_ = true;
        lets_go_s_ = now.time_s() + 0.5;
        response.events.push_back({"pulled"});
      }
      closed = now.time_s() < lets_go_s_;
      if (!closed) looks_from_s_ = now.time_s() + rest;
    } else {
      lets_go_s_ = -1.0;
      is_helped_ = false;
      if (now.time_s() < looks_from_s_) {
        // Away from it: back first, then with a turn.
        const bool backs = looks_from_s_ - now.time_s() > rest - 1.0;
        response.command = {backs ? -0.15 : 0.1, 0.0, backs ? 0.0 : 1.0};
        response.activation = looks_from_s_ - now.time_s() > rest - 2.5 ? 1.0 : 0.0;
      } else {
        closed = approach(now, response);
      }
    }
    response.act(elsie::GripCommand{closed});
    return response;
  }

 private:
  /// Drives to the nearest stick. Returns whether it is there.
  static bool approach(const elsie::Perception& now, elsie::Response& response) {
    response.activation = 0.0;
    for (const auto& blob : now.readings<elsie::OmnidirectionalReading>()[0]->blobs) {
      if (blob.colour() != kStick) continue;  // the nearest come first
      response.activation = 1.0;
      response.command = {0.2 * std::max(0.0, std::cos(blob.bearing_rad)), 0.0,
                          3.0 * blob.bearing_rad};
      return blob.distance_m < 0.12;
    }
    return false;
  }

  double lets_go_s_ = -1.0;  // below 0: it holds nothing
  bool is_helped_ = false;
  double looks_from_s_ = 0.0;
};

ELSIE_BEHAVIOR(
    Pull, "pull", "Grips sticks, and waits for others to help",
    elsie::needs<elsie::OmnidirectionalReading>(), elsie::commands<elsie::GripCommand>(),
    elsie::raises("pulled", "another robot helps, and the stick comes out"),
    elsie::parameter("patience", &Pull::patience,
                     {.unit = "s", .min = 0, .meaning = "how long it waits for help"}),
    elsie::parameter("rest", &Pull::rest,
                     {.unit = "s", .min = 2, .meaning = "how long it then looks elsewhere"}));
