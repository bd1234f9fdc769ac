// The motor schema dodge (Arkin 1998): a sidestep across the way of something that approaches and
// would pass too near. Its way is measured from successive readings of a camera.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include <elsie/api/remember.h>
#include <elsie/readings/omnidirectional_camera.h>

#include "colour_text.h"
#include "inactive.h"
#include "motor_schema.h"

namespace {

using elsie::Vector2;

class Dodge final : public MotorSchema, public elsie::Remembers {
 public:
  std::string colour;
  double clearance = 0.4;
  double horizon = 3.0;
  double least_speed = 0.05;
  double speed = 0.3;

  void configured() override {
    wanted_.reset();
    if (!colour.empty()) wanted_ = colour_of(colour);
  }
  void reset(elsie::Random& random) override {
    MotorSchema::reset(random);
    place_ = {};
    velocity_ = {};
    seen_s_ = since_s_ = kNever;
    side_ = 0;
    miss_m_ = kNone;
  }
  void remember(elsie::Memory& memory) override {
    memory("place.x", place_.x);
    memory("place.y", place_.y);
    memory("velocity.x", velocity_.x);
    memory("velocity.y", velocity_.y);
    memory("seen_s", seen_s_);
    memory("since_s", since_s_);
    memory("side", side_);
  }

  elsie::Response respond(const elsie::Perception& now) override {
    miss_m_ = kNone;
    if (const std::optional<Vector2> sighted = look(now)) {
      follow(*sighted, now);
      if (seen_s_ - since_s_ >= kSmoothing - kRounding) return sidestep(now);
    }
    side_ = 0;
    rest();
    return inactive();
  }

  double miss_m_ = kNone;

 private:
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  static constexpr double kNever = -1e9;     // s
  static constexpr double kSmoothing = 0.1;  // s, of the measured velocity
  static constexpr double kRounding = 1e-9;  // s
  static constexpr double kJump = 0.2;       // m; one that is farther from the last is another
  static constexpr double kFastest = 5.0;    // m/s
  static constexpr double kEven = 0.02;      // m; passing so near it may pass on either side

  /// The place of the nearest thing of the colour, in the world.
  std::optional<Vector2> look(const elsie::Perception& now) const {
    double nearest = std::numeric_limits<double>::infinity();
    std::optional<Vector2> place;
    for (const auto& view : now.readings<elsie::OmnidirectionalReading>()) {
      for (const auto& blob : view->blobs) {
        if (blob.distance_m >= nearest || (wanted_ && blob.colour() != *wanted_)) continue;
        nearest = blob.distance_m;
        const double bearing = view.azimuth_rad() + blob.bearing_rad;
        const elsie::Vector3& eye = view.mounting().position;
        place = elsie::point_of(now.self().pose, {eye.x + nearest * std::cos(bearing),
                                                  eye.y + nearest * std::sin(bearing)});
      }
    }
    return place;
  }

  /// Measures the velocity of what it sees.
  void follow(const Vector2& place, const elsie::Perception& now) {
    const double passed = now.time_s() - seen_s_;
    const bool knows =
        passed <= std::max(kSmoothing, 2.0 * now.period_s()) &&
        std::hypot(place.x - place_.x, place.y - place_.y) <= kJump + kFastest * passed;
    if (!knows) {
      velocity_ = {};
      since_s_ = now.time_s();
    } else if (passed > 0.0) {
      // The mean of all that it has seen at first, then of the last kSmoothing.
      const double part = passed / std::min(now.time_s() - since_s_, std::max(kSmoothing, passed));
      velocity_.x += part * ((place.x - place_.x) / passed - velocity_.x);
      velocity_.y += part * ((place.y - place_.y) / passed - velocity_.y);
    }
    place_ = place;
    seen_s_ = now.time_s();
  }

  elsie::Response sidestep(const elsie::Perception& now) {
    const elsie::Pose& pose = now.self().pose;
    const double fast = std::hypot(velocity_.x, velocity_.y);
    if (fast >= least_speed) {
      const Vector2 ahead{velocity_.x / fast, velocity_.y / fast};
      const Vector2 left{-ahead.y, ahead.x};
      // Of the robot, as seen by what comes.
      const Vector2 off{pose.x - place_.x, pose.y - place_.y};
      const double before = off.x * ahead.x + off.y * ahead.y;
      miss_m_ = off.x * left.x + off.y * left.y;
      if (before > 0.0 && before <= fast * horizon && std::abs(miss_m_) < clearance) {
        if (side_ == 0) {
          const double facing =
              std::cos(pose.heading_rad) * left.x + std::sin(pose.heading_rad) * left.y;
          side_ = (std::abs(miss_m_) < kEven ? facing : miss_m_) < 0.0 ? -1 : 1;
        }
        return moved_in_world({side_ * speed * left.x, side_ * speed * left.y}, now);
      }
    }
    side_ = 0;
    rest();
    return inactive();
  }

  std::optional<elsie::Colour> wanted_;
  Vector2 place_, velocity_;  // of what it sees, in the world
  double seen_s_ = kNever, since_s_ = kNever;
  int side_ = 0;  // of the way of what comes: 1: it goes to the left of it, -1: to the right
};

}  // namespace

ELSIE_BEHAVIOR(
    Dodge, "dodge", "A sidestep across the way of what approaches; a motor schema",
    elsie::needs<elsie::OmnidirectionalReading>(),
    elsie::parameter("colour", &Dodge::colour,
                     {.meaning = "of what it dodges, like \"#d03030\"; by default the nearest "
                                 "thing that the camera sees, whatever its colour"}),
    elsie::parameter("clearance", &Dodge::clearance,
                     {.unit = "m",
                      .above = 0,
                      .max = 1e6,
                      .meaning = "what would pass nearer to the robot's middle is dodged"}),
    elsie::parameter("horizon", &Dodge::horizon,
                     {.unit = "s",
                      .min = 0,
                      .max = 1e6,
                      .meaning = "what will be there later is not dodged yet"}),
    elsie::parameter("least_speed", &Dodge::least_speed,
                     {.unit = "m/s", .min = 0.001, .max = 50, .meaning = "what is slower stands"}),
    elsie::parameter("speed", &Dodge::speed,
                     {.unit = "m/s", .min = 0, .max = 50, .meaning = "length of the vector"}),
    elsie::parameter("lead", &Dodge::lead, MotorSchema::lead_facts()),
    elsie::publishes("miss", &Dodge::miss_m_,
                     {.unit = "m",
                      .meaning = "how far to the left of the way of what moves the robot is; none: "
                                 "nothing moves"}));
