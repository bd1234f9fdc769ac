// Foraging to a nest (Goss and Deneubourg, 1992): drives to a resource that the camera sees, grips
// it, and carries it to the nest of the team.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <elsie/api/behavior.h>
#include <elsie/api/remember.h>
#include <elsie/commands/gripper.h>
#include <elsie/messages/say.h>
#include <elsie/readings/omnidirectional_camera.h>

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kPause = 1.0;  // s
constexpr double kArm = 0.15;   // m, to the middle of what it holds

class Forage final : public elsie::Behavior, public elsie::Remembers {
 public:
  std::string colour = "#2e9e4f";
  double speed = 0.2;
  double gain = 3.0;
  double grip_within = 0.12;
  double release_within = 0.7;
  double patience = 30.0;

  void configured() override {
    unsigned rgb = 0;
    const char* const end = colour.data() + colour.size();
    if (colour.size() != 7 || colour[0] != '#' ||
        std::from_chars(colour.data() + 1, end, rgb, 16).ptr != end) {
      throw std::invalid_argument("colour is \"" + colour +
                                  "\"; expected six hexadecimal digits after #, as in \"#2e9e4f\"");
    }
    wanted_ = {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8),
               static_cast<std::uint8_t>(rgb)};
  }
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
    waits_since_s_ = looks_from_s_ = -1.0;
    heard_x_.reset();
    heard_y_.reset();
  }
  void remember(elsie::Memory& memory) override {
    memory("waits_since_s", waits_since_s_);
    memory("looks_from_s", looks_from_s_);
    memory("heard_x", heard_x_);
    memory("heard_y", heard_y_);
  }

  elsie::Response respond(const elsie::Perception& now) override {
    bearing_rad_ = distance_m_ = kNone;
    for (const auto& place : now.heard<elsie::PlaceMessage>()) {
      heard_x_ = place->x;
      heard_y_ = place->y;
    }
    bool closed = false;
    if (!now.self().held.empty()) {
      closed = !carry(now) && !gives_up(now);
      // Whoever helped to carry it lets go, too.
      if (!closed) looks_from_s_ = std::max(looks_from_s_, now.time_s() + kPause);
    } else if (now.time_s() >= looks_from_s_) {
      look(now);
      closed = distance_m_ <= grip_within;
      if (std::isnan(bearing_rad_)) go_where_called(now.self().pose);
    }
    elsie::Response response;
    response.act(elsie::GripCommand{closed});
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
  /// Whether it has held something for long enough that as many robots as it takes did not come. It
  /// then leaves it alone for as long.
  bool gives_up(const elsie::Perception& now) {
    if (now.self().held.front().moves) {
      waits_since_s_ = -1.0;
      return false;
    }
    if (waits_since_s_ < 0.0) waits_since_s_ = now.time_s();
    if (now.time_s() - waits_since_s_ < patience) return false;
    waits_since_s_ = -1.0;
    looks_from_s_ = now.time_s() + patience;
    return true;
  }

  /// Heads for the nest. Returns whether it is there.
  bool carry(const elsie::Perception& now) {
    const auto& nest = now.team().nest;
    if (!nest) return false;
    const elsie::Pose& here = now.self().pose;
    bearing_rad_ = elsie::bearing(here, nest->place.x, nest->place.y);
    distance_m_ = std::hypot(nest->place.x - here.x, nest->place.y - here.y);
    const bool is_stuck = !now.self().held.front().moves;
    return distance_m_ <= (is_stuck ? nest->radius_m + kArm : release_within * nest->radius_m);
  }

  /// Heads for the nearest resource.
  void look(const elsie::Perception& now) {
    for (const auto& view : now.readings<elsie::OmnidirectionalReading>()) {
      for (const auto& blob : view->blobs) {
        if (blob.colour() != wanted_ || distance_m_ <= blob.distance_m) continue;
        distance_m_ = blob.distance_m;
        bearing_rad_ = elsie::wrap_angle(view.azimuth_rad() + blob.bearing_rad);
      }
    }
  }

  /// Heads for the place that it heard of last. Forgets it on arrival, if nothing is there.
  void go_where_called(const elsie::Pose& here) {
    constexpr double kThere = 0.2;  // m
    if (!heard_x_ || !heard_y_) return;
    distance_m_ = std::hypot(*heard_x_ - here.x, *heard_y_ - here.y);
    bearing_rad_ = elsie::bearing(here, *heard_x_, *heard_y_);
    if (distance_m_ < kThere) heard_x_.reset();
  }

  elsie::Colour wanted_;
  std::optional<double> heard_x_, heard_y_;  // m, the place that it heard of last
  bool has_nest_ = true;
  double waits_since_s_ = -1.0;  // for others to help it; below 0: it does not wait
  double looks_from_s_ = -1.0;   // when it looks for resources again
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
    elsie::parameter("patience", &Forage::patience,
                     {.unit = "s",
                      .min = 0,
                      .max = 1e9,
                      .meaning = "how long it holds what needs more hands than are there; for as "
                                 "long it looks for nothing then"}),
    elsie::publishes("bearing", &Forage::bearing_rad_,
                     {.unit = "rad",
                      .meaning = "of what it drives to, to the left; none: it wants nothing"}),
    elsie::publishes("distance", &Forage::distance_m_,
                     {.unit = "m", .meaning = "to what it drives to; none: it wants nothing"}));
