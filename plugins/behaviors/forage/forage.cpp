// Foraging to a nest (Goss and Deneubourg, 1992): drives to a resource that the camera sees, grips
// it, and carries it to the nest of the team.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <elsie/api/behavior.h>
#include <elsie/api/remember.h>
#include <elsie/commands/gripper.h>
#include <elsie/messages/say.h>
#include <elsie/readings/omnidirectional_camera.h>

#include "colour_text.h"

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kPause = 1.0;    // s, after it has opened the hand
constexpr double kGrasp = 1.0;    // s, in which something comes into the closed hand, or never
constexpr double kNearer = 0.05;  // m, which is progress
constexpr double kThere = 0.4;    // m, from the place that it heard of
constexpr double kDeaf = 30.0;    // s, after it has found nothing there
constexpr double kArm = 0.15;     // m, to the middle of what it holds

class Forage final : public elsie::Behavior, public elsie::Remembers {
 public:
  std::string colour = "#2e9e4f";
  double speed = 0.2;
  double gain = 3.0;
  double grip_within = 0.12;
  double release_within = 0.7;
  double patience = 10.0;

  void configured() override { wanted_ = colour_of(colour); }
  void equipped(const elsie::Perception& example) override {
    has_nest_ = example.team().nest.has_value();
  }
  std::vector<std::string> notes() const override {
    if (has_nest_) return {};
    return {
        "the world has no nest for this robot's team: it keeps what it has gripped and wants "
        "nothing more; give it a <nest>"};
  }
  void reset(elsie::Random&) override {
    bearing_rad_ = distance_m_ = kNone;
    aim_ = Aim::nothing;
    acts_from_s_ = hears_from_s_ = -1.0;
    heard_x_.reset();
    heard_y_.reset();
  }
  void remember(elsie::Memory& memory) override {
    int aim = static_cast<int>(aim_);
    memory("aim", aim);
    aim_ = static_cast<Aim>(aim);
    memory("nearest_m", nearest_m_);
    memory("since_s", since_s_);
    memory("acts_from_s", acts_from_s_);
    memory("hears_from_s", hears_from_s_);
    memory("heard_x", heard_x_);
    memory("heard_y", heard_y_);
  }

  elsie::Response respond(const elsie::Perception& now) override {
    bearing_rad_ = distance_m_ = kNone;
    hear(now);
    Aim aim = Aim::nothing;
    if (now.time_s() >= acts_from_s_) aim = now.self().held.empty() ? search(now) : carry(now);
    if (is_in_vain(aim, now.time_s())) {
      // Other behaviours bring it elsewhere.
      aim = Aim::nothing;
      bearing_rad_ = distance_m_ = kNone;
      heard_x_.reset();
      acts_from_s_ = now.time_s() + patience;
    }
    elsie::Response response;
    response.act(elsie::GripCommand{aim == Aim::grip || aim == Aim::keep || aim == Aim::help ||
                                    aim == Aim::nest});
    if (std::isnan(bearing_rad_)) {
      response.activation = response.strength = 0.0;
    } else {
      response.command = {speed * std::max(0.0, std::cos(bearing_rad_)), 0.0, gain * bearing_rad_};
    }
    return response;
  }

  void sketch(elsie::Sketch& sketch) const override {
    if (std::isnan(bearing_rad_)) return;
    sketch.arrow(elsie::SketchRole::target, {},
                 {0.2 * std::cos(bearing_rad_), 0.2 * std::sin(bearing_rad_), 0.0});
  }

  double bearing_rad_ = kNone;  // of the resource or the nest; none: it wants nothing
  double distance_m_ = kNone;

 private:
  /// What it wants: help with what does not move, and the nest with what does.
  enum class Aim { nothing, keep, resource, grip, place, help, nest };

  /// Whether it has come no nearer to what it wants for too long: others are in the way, hold it,
  /// or do not come to help.
  bool is_in_vain(Aim aim, double time_s) {
    if (aim != aim_ || distance_m_ < nearest_m_ - kNearer) {
      aim_ = aim;
      nearest_m_ = distance_m_;
      since_s_ = time_s;
    }
    const bool wants = aim != Aim::nothing && aim != Aim::keep;
    return wants && time_s - since_s_ >= (aim == Aim::grip ? kGrasp : patience);
  }

  /// Heads for the nest, and opens the hand there.
  Aim carry(const elsie::Perception& now) {
    const auto& nest = now.team().nest;
    if (!nest) return Aim::keep;
    const elsie::Pose& here = now.self().pose;
    bearing_rad_ = elsie::bearing(here, nest->place.x, nest->place.y);
    distance_m_ = std::hypot(nest->place.x - here.x, nest->place.y - here.y);
    const bool moves = now.self().held.front().moves;
    if (distance_m_ > (moves ? release_within * nest->radius_m : nest->radius_m + kArm)) {
      return moves ? Aim::nest : Aim::help;
    }
    acts_from_s_ = now.time_s() + kPause;  // whoever helped to carry it lets go, too
    return Aim::nothing;
  }

  /// Heads for the nearest resource or, without one, for the place that it heard of.
  Aim search(const elsie::Perception& now) {
    for (const auto& view : now.readings<elsie::OmnidirectionalReading>()) {
      for (const auto& blob : view->blobs) {
        if (blob.colour() != wanted_ || distance_m_ <= blob.distance_m) continue;
        distance_m_ = blob.distance_m;
        bearing_rad_ = elsie::wrap_angle(view.azimuth_rad() + blob.bearing_rad);
      }
    }
    if (!std::isnan(bearing_rad_)) {
      heard_x_.reset();
      return distance_m_ <= grip_within ? Aim::grip : Aim::resource;
    }
    if (!heard_x_ || !heard_y_) return Aim::nothing;
    const elsie::Pose& here = now.self().pose;
    const double away = std::hypot(*heard_x_ - here.x, *heard_y_ - here.y);
    if (away < kThere) {
      heard_x_.reset();
      hears_from_s_ = now.time_s() + kDeaf;
      return Aim::nothing;
    }
    distance_m_ = away;
    bearing_rad_ = elsie::bearing(here, *heard_x_, *heard_y_);
    return Aim::place;
  }

  /// Notes a place that it hears of, unless it is on its way to one.
  void hear(const elsie::Perception& now) {
    for (const auto& place : now.heard<elsie::PlaceMessage>()) {
      if (heard_x_ || now.time_s() < hears_from_s_) return;
      heard_x_ = place->x;
      heard_y_ = place->y;
    }
  }

  elsie::Colour wanted_;
  std::optional<double> heard_x_, heard_y_;  // m, the place that it heard of
  bool has_nest_ = true;
  Aim aim_ = Aim::nothing;
  double nearest_m_ = 0.0, since_s_ = 0.0;  // how near it came to that, and when
  double acts_from_s_ = -1.0;               // when it wants something again
  double hears_from_s_ = -1.0;              // when it believes others again
};

}  // namespace

ELSIE_BEHAVIOR(
    Forage, "forage", "Drives to a resource, grips it, and carries it to the nest",
    elsie::needs<elsie::OmnidirectionalReading>(), elsie::commands<elsie::GripCommand>(),
    elsie::hears<elsie::PlaceMessage>(),
    elsie::parameter("colour", &Forage::colour,
                     {.meaning = "of the resources, in full light; by default that of resources "
                                 "without a team"}),
    elsie::parameter("speed", &Forage::speed,
                     {.unit = "m/s", .min = 0, .max = 10, .meaning = "how fast, straight on"}),
    elsie::parameter(
        "gain", &Forage::gain,
        {.unit = "1/s", .min = 0, .max = 100, .meaning = "turn rate for each radian off"}),
    elsie::parameter("grip_within", &Forage::grip_within,
                     {.unit = "m",
                      .above = 0,
                      .max = 10,
                      .meaning = "it closes the gripper when the camera has the middle of a "
                                 "resource so near"}),
    elsie::parameter("release_within", &Forage::release_within,
                     {.above = 0,
                      .max = 1,
                      .meaning = "it opens the gripper so near to the middle of the nest, as a "
                                 "fraction of its radius"}),
    elsie::parameter(
        "patience", &Forage::patience,
        {.unit = "s",
         .min = 0,
         .max = 1e9,
         .meaning = "how long it goes on without coming nearer to what it wants, or holds "
                    "what needs more hands; for as long it wants nothing then"}),
    elsie::publishes("bearing", &Forage::bearing_rad_,
                     {.unit = "rad",
                      .meaning = "of what it drives to, to the left; none: it wants nothing"}),
    elsie::publishes("distance", &Forage::distance_m_,
                     {.unit = "m", .meaning = "to what it drives to; none: it wants nothing"}));
