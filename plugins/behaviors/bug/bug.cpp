// Goes to a place past obstacles that it does not know, and knows when the place cannot be reached:
// Bug1 and Bug2 of V. J. Lumelsky and A. A. Stepanov, "Path-planning strategies for a point mobile
// automaton moving amidst unknown obstacles of arbitrary shape", Algorithmica 2 (1987). As there,
// H is the hit point, L the leave point, Q the point of the boundary that is nearest to the goal,
// and the M-line leads from the start to the goal.
//
//   to_goal    straight to the goal, until an obstacle is in the way: H
//   aligning   on the spot, until the obstacle is on the wanted side
//   boundary   along the obstacle. Bug1: once round it.
//              Bug2: to a point of the M-line that is nearer than H
//   returning  Bug1: along the obstacle to Q, the shorter way; that is L
//   given_up   the goal cannot be reached
//
// The automaton of the paper is a point: here the boundary runs at `distance` from the obstacle.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "boundary_trip.h"
#include "m_line.h"
#include "place_goal.h"
#include "seen_points.h"
#include "wall_pursuit.h"

namespace {

using elsie::Pose;

class Bug final : public PlaceGoal {
 public:
  std::string algorithm = "bug2";
  std::string side = "right";
  double speed = 0.2;
  double distance = 0.3;
  double reach = 0.75;
  double front_angle = 30.0;
  double lookahead = 0.3;
  double turn_rate = 1.5;

  void configured() override {
    const bool on_left = (side == "left") != is_reversed_;
    pursuit_.set(
        {on_left, distance, reach, elsie::radians(front_angle), speed, lookahead, turn_rate});
  }
  void equipped(const elsie::Perception& example) override {
    pursuit_.check(example);
    if (is_bug1()) {  // it may come back along the obstacle
      WallPursuit other = pursuit_;
      other.set_side(!pursuit_.settings().on_left);
      other.check(example);
    }
  }
  void reset(elsie::Random& random) override {
    PlaceGoal::reset(random);
    state_ = State::begin;
  }
  void remember(elsie::Memory& memory) override;

 protected:
  elsie::Response approach(const elsie::Perception& now, double away_m, double off_rad) override {
    const Pose& pose = now.self().pose;
    const bool was_away = now.time_s() - asked_s_ > std::max(kAway, 2.0 * now.period_s());
    asked_s_ = now.time_s();
    if (state_ == State::begin || x != m_line_.goal().x || y != m_line_.goal().y ||
        (was_away && state_ != State::given_up)) {
      start(pose);
    }
    const bool meets = m_line_.meets(pose);
    elsie::Response response;
    if (state_ == State::to_goal) {
      go(now, away_m, off_rad, response);
    } else if (state_ == State::boundary || state_ == State::returning) {
      follow(now, away_m, off_rad, meets, response);
    }
    if (state_ == State::aligning) {
      align(now, response);
    } else if (state_ == State::given_up) {
      response.command = {};
      response.activation = 0.0;
      response.status = elsie::Status::failure;
    }
    return response;
  }

 private:
  enum class State { begin, to_goal, aligning, boundary, returning, given_up };

  static constexpr double kAway = 0.5;       // s without being asked
  static constexpr double kGain = 3.0;       // 1/s, of turns on the spot
  static constexpr double kStraight = 0.1;   // rad, farther off it turns on the spot
  static constexpr double kAligned = 0.05;   // rad
  static constexpr double kSame = 0.1;       // m, within it two points are the same
  static constexpr double kCorridor = 0.75;  // distances to either side that are looked at

  bool is_bug1() const { return algorithm == "bug1"; }

  /// Begins anew from here.
  void start(const Pose& pose) {
    state_ = State::to_goal;
    m_line_.begin(pose, {x, y});
    trip_.forget_leave();
  }

  /// Straight lines only: what is ahead is seen, what is on a curve may be not.
  void go(const elsie::Perception& now, double away_m, double off_rad, elsie::Response& response) {
    const auto obstacle = in_the_way(now, away_m, off_rad);
    if (!obstacle) {
      response.command = steer(off_rad, away_m, speed, kGain, distance);
      response.command.forward *= std::abs(off_rad) < kStraight ? 1.0 : 0.0;
      response.command.turn = std::clamp(response.command.turn, -turn_rate, turn_rate);
      return;
    }
    const Pose& pose = now.self().pose;
    if (is_bug1() && trip_.leads_back(pose, pose.heading_rad + *obstacle)) {
      give_up(response);  // the way from L to the goal crosses the same obstacle, at L
      return;
    }
    turn_side(false);
    heading_ = elsie::wrap_angle(pose.heading_rad + *obstacle -
                                 pursuit_.towards_wall() * 0.5 * std::numbers::pi);
    trip_.begin({pose.x, pose.y, heading_}, away_m, distance);
    state_ = State::aligning;
    next_ = State::boundary;
    response.events.push_back({"hit_point"});
  }

  void follow(const elsie::Perception& now, double away_m, double off_rad, bool meets,
              elsie::Response& response) {
    const Pose& pose = now.self().pose;
    const WallPursuit::State before = pursuit_.look(now);
    response = pursuit_.act();
    if (before == WallPursuit::State::following &&
        pursuit_.state() == WallPursuit::State::searching) {
      pursuit_.begin(now);  // out of sight is not gone: it rounds the end in the next step
    }
    response.activation = response.strength = 1.0;
    if (state_ == State::returning ? trip_.passes_nearest(pose)
                                   : meets && is_free(now, away_m, off_rad)) {
      trip_.leave(pose, (side == "left" ? 0.5 : -0.5) * std::numbers::pi);
      state_ = State::to_goal;
      response = elsie::Motion{};
      response.events.push_back({"leave_point"});
    } else if (pursuit_.state() == WallPursuit::State::searching) {
      start(pose);  // the obstacle is gone
    } else if (state_ == State::boundary && trip_.comes_round(pose, away_m)) {
      if (!is_bug1()) {
        give_up(response);
      } else if (trip_.is_nearer_back()) {
        turn_side(true);
        heading_ = elsie::wrap_angle(pose.heading_rad + std::numbers::pi);
        state_ = State::aligning;
        next_ = State::returning;
      } else {
        state_ = State::returning;
      }
    }
  }

  void align(const elsie::Perception& now, elsie::Response& response) {
    const double off = elsie::wrap_angle(heading_ - now.self().pose.heading_rad);
    if (std::abs(off) < kAligned) {
      state_ = next_;
      pursuit_.begin(now);
    }
    response.command = {0.0, 0.0, std::clamp(kGain * off, -turn_rate, turn_rate)};
  }

  /// The direction of what the robot would come too near to on its way.
  std::optional<double> in_the_way(const elsie::Perception& now, double away_m, double off_rad) {
    const double ahead = std::min(distance, away_m + body_radius(now.self()));
    constexpr double kMargin = 0.02;  // m
    const double aside = std::max(kCorridor * distance, 0.5 * now.self().width_m + kMargin);
    return nearest_in_corridor(now, off_rad, ahead, aside);
  }

  /// Bug2: whether it leaves here, on the M-line nearer than H. Another obstacle, not on the side
  /// of this one, may well be in the way: that is the next H.
  bool is_free(const elsie::Perception& now, double away_m, double off_rad) {
    if (is_bug1() || away_m >= trip_.hit_away_m() - kSame) return false;
    const auto obstacle = in_the_way(now, away_m, off_rad);
    return !obstacle || std::sin(*obstacle) * pursuit_.towards_wall() < -0.5;
  }

  void turn_side(bool is_reversed) {
    is_reversed_ = is_reversed;
    pursuit_.set_side((side == "left") != is_reversed);
  }
  void give_up(elsie::Response& response) {
    state_ = State::given_up;
    response.events.push_back({"unreachable"});
  }

  WallPursuit pursuit_;
  BoundaryTrip trip_;
  MLine m_line_;
  State state_ = State::begin;
  State next_ = State::boundary;  // after aligning
  double asked_s_ = -1e9;         // when it was asked last
  double heading_ = 0.0;          // while aligning: the one to turn to
  bool is_reversed_ = false;      // the obstacle is on the other side
};

void Bug::remember(elsie::Memory& memory) {
  PlaceGoal::remember(memory);
  pursuit_.remember(memory);
  trip_.remember(memory);
  m_line_.remember(memory);
  memory("bug_state", state_);
  memory("bug_next", next_);
  memory("bug_asked_s", asked_s_);
  memory("align_to", heading_);
  memory("is_reversed", is_reversed_);
  turn_side(is_reversed_);
}

}  // namespace

ELSIE_BEHAVIOR(
    Bug, "bug",
    "Goes to a place past unknown obstacles, along their boundaries; knows when it cannot get "
    "there",
    elsie::parameter(
        "algorithm", &Bug::algorithm,
        {.choices = {"bug1", "bug2"},
         .meaning = "bug1 goes once round an obstacle and leaves it where the place is "
                    "nearest; bug2 leaves it on the line from the start to the place"}),
    elsie::parameter("x", &Bug::x, {.unit = "m", .meaning = "the place, east"}),
    elsie::parameter("y", &Bug::y, {.unit = "m", .meaning = "the place, north"}),
    elsie::parameter("side", &Bug::side,
                     {.choices = {"left", "right"},
                      .meaning = "where an obstacle is while it follows its boundary"}),
    elsie::parameter("speed", &Bug::speed,
                     {.unit = "m/s", .above = 0, .max = 50, .meaning = "how fast"}),
    elsie::parameter(
        "distance", &Bug::distance,
        {.unit = "m",
         .above = 0,
         .meaning = "from the robot's middle to the obstacle whose boundary it follows"}),
    elsie::parameter("reach", &Bug::reach,
                     {.unit = "m",
                      .above = 0,
                      .meaning = "beyond this distance from the robot's middle, there is no "
                                 "boundary to follow"}),
    elsie::parameter("front_angle", &Bug::front_angle,
                     {.unit = "deg",
                      .min = 0,
                      .max = 60,
                      .meaning = "rays look ahead up to this azimuth to either side, in "
                                 "degrees, and to the side beyond it, up to 150"}),
    elsie::parameter(
        "lookahead", &Bug::lookahead,
        {.unit = "m", .above = 0, .meaning = "on a boundary it steers to a point this far on"}),
    elsie::parameter("turn_rate", &Bug::turn_rate,
                     {.unit = "rad/s",
                      .above = 0,
                      .max = 100,
                      .meaning = "fastest turn, in radians per second"}),
    elsie::parameter("tolerance", &Bug::tolerance,
                     {.unit = "m", .above = 0, .meaning = "nearer than this, it has arrived"}),
    elsie::raises("arrived", "the robot has come within the tolerance of the place"),
    elsie::raises("hit_point", "an obstacle is in the way: it follows its boundary from here"),
    elsie::raises("leave_point", "it leaves the boundary of the obstacle"),
    elsie::raises("unreachable", "the place cannot be reached: it stops"));
