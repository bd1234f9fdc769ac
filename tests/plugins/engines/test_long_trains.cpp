// Trains of more segments than ODE's solver takes: the exact solver for chains.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/base/thread_pool.h"

#include "trains.h"

using namespace elsie;
using namespace elsie::physics;
using world::ObstacleKind;

namespace {

// ODE's solver takes trains up to this length.
constexpr std::size_t kMostForOde = 10;

constexpr double kTop = 20.0;  // rad/s

/// So many segments. Hitched a little nearer to the axle in front than in the middle of the gap:
/// there a long train snakes, which amplifies any rounding. See the last case.
std::vector<world::Segment> steady(std::size_t count) {
  std::vector<world::Segment> segments(count);
  for (world::Segment& segment : segments) segment.hitch = 0.05;
  return segments;
}

/// What the wheels do in the course of time.
struct Course {
  const char* name;
  WheelRates (*rates)(double time);
};

const Course kStraight{"straight on", [](double) { return WheelRates{kTop, kTop}; }};
const Course kCircle{"a circle", [](double) { return WheelRates{14, kTop}; }};
const Course kSlalom{"a slalom", [](double time) {
                       const bool left = std::fmod(time, 4.0) < 2.0;
                       return left ? WheelRates{14, kTop} : WheelRates{kTop, 14};
                     }};
const Course kToAndFro{"to and fro", [](double time) {
                         const double rate = std::fmod(time, 2.0) < 1.0 ? kTop : -kTop;
                         return WheelRates{rate, rate};
                       }};

/// A train that is driven, and the extremes of what it did.
class Ride {
 public:
  explicit Ride(Train& train) : train_(train), energy_(train), history_{energy_.now()} {
    double mass = 0.2;
    for (const world::Segment& segment : train.segments) mass += segment.mass;
    const double speed = world::RobotBody{}.wheel_radius * kTop;
    at_top_speed = 0.5 * mass * speed * speed;
  }

  void run(const Course& course, double seconds) {
    PhysicsContext& context = train_.context;
    const auto window = static_cast<std::size_t>(std::lround(kWindow / context.physics.step));
    context.run(seconds, [&] {
      time_ += context.physics.step;
      const WheelRates rates = course.rates(time_);
      train_.drive(rates.left, rates.right);
      history_.push_back(energy_.now());
      most_energy = std::max(most_energy, history_.back() - history_.front());
      if (history_.size() > window) {
        most_gain = std::max(most_gain, history_.back() - history_[history_.size() - 1 - window]);
      }
      widest_gap = std::max(widest_gap, train_.widest_gap());
      for (std::size_t i = 0; i < train_.segments.size(); ++i) {
        const SegmentState state = train_.segment(i);
        steepest = std::max(steepest, std::acos(std::min(1.0, state.frame.up.z)));
        past_limit = std::max(past_limit, std::abs(state.yaw_rad) - train_.joints[i].max_yaw_rad);
      }
    });
  }

  static constexpr double kWindow = 0.1;  // s
  /// What the motors can give in such a time, J.
  static constexpr double kMostWork = 2.0 * world::RobotBody{}.wheel_torque * kTop * kWindow;

  double at_top_speed = 0.0;  // J, of a train that is not bent
  double most_energy = 0.0;   // J, more than at rest
  double most_gain = 0.0;     // J, of energy in such a time
  double widest_gap = 0.0;    // m
  double steepest = 0.0;      // rad
  double past_limit = -1.0;

 private:
  Train& train_;
  Energy energy_;
  std::vector<double> history_;
  double time_ = 0.0;
};

/// The segment's corner that is farthest along x.
double farthest(const SegmentState& segment) {
  double x = -1e9;
  for (const double ahead : {-0.04, 0.04}) {
    for (const double side : {-0.03, 0.03}) {
      x = std::max(x, segment.frame.point({ahead, side, 0.05}).x);
    }
  }
  return x;
}

}  // namespace

// The wheels keep their grip: where they slip, it matters how the weight is shared with the
// casters, which is a matter of softness.
TEST_CASE("A train for the exact solver takes the same path as one for ODE's solver") {
  const double step = GENERATE(0.005, 0.02);
  const Course course = GENERATE(kStraight, kCircle, kSlalom);
  CAPTURE(step, course.name);
  world::Physics physics = with_step(step);
  physics.friction = 1.0;
  PhysicsContext of_ode(physics, open_field()), exact(physics, open_field());
  std::vector<world::Segment> segments = steady(kMostForOde + 1);
  segments.back().mass = 1e-4;  // hardly a train of another weight
  Train longer = train(exact, segments);
  segments.pop_back();
  Train shorter = train(of_ode, segments);
  double apart = 0.0;
  for (long i = 0; i < std::lround(8.0 / step); ++i) {
    const WheelRates rates = course.rates(static_cast<double>(i) * step);
    for (Train* const pulled : {&shorter, &longer}) {
      pulled->drive(rates.left, rates.right);
      pulled->context.engine->step();
    }
    for (std::size_t k = 0; k < kMostForOde; ++k) {
      apart = std::max(apart, distance(shorter.segment(k).pose, longer.segment(k).pose));
    }
  }
  CHECK(apart < 3e-4);
}

TEST_CASE("A long train keeps to its joints and is never faster than its motors") {
  const std::size_t count = GENERATE(30, 100);
  const Course course = GENERATE(kStraight, kCircle, kSlalom, kToAndFro);
  CAPTURE(count, course.name);
  PhysicsContext context({}, open_field());
  Train pulled = train(context, steady(count));
  Ride ride(pulled);
  ride.run(course, 4.0);
  CHECK(ride.most_energy < 1.1 * ride.at_top_speed);
  CHECK(ride.most_energy > 0.1 * ride.at_top_speed);
  CHECK(ride.widest_gap < 1e-9);
  CHECK(ride.past_limit <= 0.0);
  CHECK(ride.steepest < 1e-3);
}

// A train that snakes exercises all limits. In a step of 0.1 s the tail of a whip goes through a
// tenth of a turn, and its speed from place to place is no longer that of its motion.
TEST_CASE("A long train stays within bounds at every step") {
  const double step = GENERATE(0.002, 0.02, 0.1);
  CAPTURE(step);
  PhysicsContext context(with_step(step), open_field());
  Train pulled = train(context, std::vector<world::Segment>(30));
  Ride ride(pulled);
  ride.run(kSlalom, 6.0);
  CHECK(ride.most_energy < (step > 0.05 ? 2.0 : 1.1) * ride.at_top_speed);
  CHECK(ride.widest_gap < 1e-9);
  CHECK(ride.past_limit <= 0.0);
}

TEST_CASE("In a steady circle each axle of a long train runs at the radius of the closed form",
          "[release]") {
  PhysicsContext context({}, open_field());
  Train pulled = train(context, steady(30));
  pulled.drive(18, 20);
  context.run(25.0);
  check_circle(pulled, {18, 20}, 1e-3);
}

TEST_CASE("A wall stops a long train that is pushed against it") {
  PhysicsContext context;
  Train backing = train(context, std::vector<world::Segment>(20), 2.55);
  context.engine->place_robot(backing.robot, {2.55, 0.0, std::numbers::pi});
  bool touched = false;
  double most = 0.0;
  backing.drive(-10, -10);
  context.run(6.0, [&] {
    for (std::size_t i = 0; i < 20; ++i) most = std::max(most, farthest(backing.segment(i)));
    touched = touched || context.touching(robot_body(0), wall_body(0));
  });
  CHECK(touched);
  CHECK(most < 5.0 + 1e-3);
  CHECK(most > 5.0 - 1e-3);
}

TEST_CASE("A long train that curls up is stopped by its own segments") {
  PhysicsContext context({}, open_field());
  constexpr std::size_t kCount = 20;
  std::vector<world::Segment> segments(kCount);
  for (world::Segment& segment : segments) segment.mass = 0.02;
  Train curling = train(context, segments);
  Ride ride(curling);
  double nearest = 1.0;
  const Course curl{"", [](double) { return WheelRates{4, 14}; }};
  for (int i = 0; i < 40; ++i) {
    ride.run(curl, 0.5);
    for (std::size_t a = 0; a < kCount; ++a) {
      for (std::size_t b = a + 2; b < kCount; ++b) {
        nearest = std::min(nearest, distance(curling.segment(a).pose, curling.segment(b).pose));
      }
    }
  }
  CHECK(nearest > 0.0595);  // they are 0.06 m wide
  CHECK(nearest < 0.09);
  CHECK(ride.widest_gap < 1e-9);
  CHECK(ride.most_gain < 1.1 * Ride::kMostWork);
}

TEST_CASE("Long trains have the same bits with any number of threads") {
  const auto hash = [](std::size_t threads) {
    base::ThreadPool pool(threads);
    world::Arena small;
    small.length = small.width = 4.0;
    PhysicsContext context({}, small);
    context.engine->work_with(pool);
    for (int i = 0; i < 4; ++i) {
      context.train(1.8, 0.5 * i - 0.75, 0.0, std::vector<world::Segment>(12));
      context.drive(static_cast<std::size_t>(i), {10.0 + i, 14.0});
    }
    context.obstacle(ObstacleKind::dynamic, 1.9, 0.1, {0.1, 0.2, 0.1});
    context.run(4.0);
    return context.engine->hash_state();
  };
  const std::uint64_t alone = hash(1);
  CHECK(hash(1) == alone);
  CHECK(hash(3) == alone);
}

TEST_CASE("A long train that is hitched in the middle of its gaps snakes by the slip of its wheels",
          "[release]") {
  const auto widest_yaw = [](double slip, double hitch) {
    world::Physics physics;
    physics.wheel_slip = slip;
    PhysicsContext context(physics, open_field());
    std::vector<world::Segment> segments(30);
    for (world::Segment& segment : segments) segment.hitch = hitch;
    Train pulled = train(context, segments);
    double time = 0.0, widest = 0.0;
    context.run(9.0, [&] {
      const double rate = kTop * std::min(1.0, time / 6.0);
      pulled.drive(rate, rate);
      time += physics.step;
      for (std::size_t i = 0; i < segments.size(); ++i) {
        widest = std::max(widest, std::abs(pulled.segment(i).yaw_rad));
      }
    });
    return widest;
  };
  constexpr double kMiddle = 0.06;  // m behind the axle in front
  CHECK(widest_yaw(1e-2, kMiddle) > 0.1);
  CHECK(widest_yaw(1e-6, kMiddle) < 0.01);
  CHECK(widest_yaw(1e-2, kMiddle - 0.01) < 0.01);
}
