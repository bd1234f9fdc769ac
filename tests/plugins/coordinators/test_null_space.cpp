// Null-space-based control.
#include <cmath>
#include <random>

#include "support.h"

using namespace elsie;
using namespace elsie::test;

namespace of_null_space {
namespace {

constexpr double kLookahead = 0.2;

Response task(const Motion& command, std::optional<double> matters_rad = {}) {
  Response response(command);
  response.matters_rad = matters_rad;
  return response;
}

/// The velocity of the point ahead: forward, and across.
struct Planar {
  double x, y;
};
Planar planar(const Motion& motion) { return {motion.forward, kLookahead * motion.turn}; }
double along(const Motion& motion, double angle) {
  const Planar v = planar(motion);
  return v.x * std::cos(angle) + v.y * std::sin(angle);
}

struct Robot {
  explicit Robot(const std::vector<Response>& tasks, bool has_side = false) {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      team.member(std::string(1, static_cast<char>('a' + i)), 10.0 - static_cast<double>(i),
                  tasks[i]);
    }
    robot.emplace("fusion_null_space", team, Parameters{{"lookahead", kLookahead}});
    robot->now.self.channels.lateral = has_side;
  }
  Team team;
  std::optional<testing::Coordinator> robot;
};

std::mt19937 random_source(5);
double drawn(double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(random_source);
}
Motion any_motion() { return {drawn(-1, 1), 0.0, drawn(-3, 3)}; }

}  // namespace

TEST_CASE("The first task is met exactly as if it were alone, whatever is below it") {
  for (int i = 0; i < 500; ++i) {
    const std::optional<double> matters =
        i % 3 == 0 ? std::nullopt : std::optional(drawn(-3.1, 3.1));
    const Response first = task(any_motion(), matters);
    Robot robot({first, task(any_motion(), drawn(-3.1, 3.1)), task(any_motion())});
    Robot alone({first});
    const Motion command = robot.robot->decide(), by_itself = alone.robot->decide();
    if (matters) {
      CHECK(along(command, *matters) == Approx(along(first.command, *matters)).margin(1e-12));
      CHECK(along(command, *matters) == Approx(along(by_itself, *matters)).margin(1e-12));
    } else {
      CHECK(command.forward == Approx(first.command.forward).margin(1e-12));
      CHECK(command.turn == Approx(first.command.turn).margin(1e-12));
      CHECK(robot.team.asked("b") == 0);
      CHECK(robot.team.reason(1) == "no freedom left");
      CHECK(robot.team.trace(1).inhibited_by == 0);
    }
  }
}

TEST_CASE("A lower task acts across what matters to the first") {
  Robot robot({task({0.3, 0, 0}, 0.0), task({1.0, 0, 2.0})});
  const Motion command = robot.robot->decide();
  CHECK(command.forward == Approx(0.3));
  CHECK(command.turn == Approx(2.0));
  CHECK(robot.team.reason(0) == "first task");
  CHECK(robot.team.reason(1) == "in the freedom left");
  CHECK(robot.team.trace(0).share == Approx(0.3 / 0.7));  // 2 rad/s are 0.4 m/s of the point
  CHECK(robot.team.trace(0).share + robot.team.trace(1).share == Approx(1.0));
}

TEST_CASE("Three tasks are combined as by the projections of the paper") {
  for (int i = 0; i < 200; ++i) {
    const double a = drawn(-3.1, 3.1), b = drawn(-3.1, 3.1);
    const Response first = task(any_motion(), a), second = task(any_motion(), b),
                   third = task(any_motion());
    Robot robot({first, second, third});
    const Motion command = robot.robot->decide();
    // v = v1 + N1 v2 + N12 v3, where N12 is zero: two directions span the plane.
    const double v1 = along(first.command, a), v2 = along(second.command, b);
    const double left = v2 * std::cos(b - a);  // of v2 along the first direction
    const Planar expected{v1 * std::cos(a) + v2 * std::cos(b) - left * std::cos(a),
                          v1 * std::sin(a) + v2 * std::sin(b) - left * std::sin(a)};
    CHECK(planar(command).x == Approx(expected.x).margin(1e-9));
    CHECK(planar(command).y == Approx(expected.y).margin(1e-9));
    CHECK(robot.team.asked("c") == 0);
  }
}

TEST_CASE("Two tasks with one direction: the second finds nothing left, a third still does") {
  Robot robot({task({0.3, 0, 0}, 0.0), task({0.9, 0, 5.0}, 0.0), task({0.9, 0, 1.0})});
  const Motion command = robot.robot->decide();
  CHECK(command.forward == Approx(0.3));
  CHECK(command.turn == Approx(1.0));
  CHECK(robot.team.trace(1).share == Approx(0.0).margin(1e-12));
}

TEST_CASE("Tasks that are not active leave all freedom to others") {
  Response idle = task({0.3, 0, 0});
  idle.activation = 0.0;
  Robot robot({idle, task({0.1, 0, 1.0})});
  CHECK(robot.robot->decide() == Motion{0.1, 0, 1.0});
  CHECK(robot.team.reason(0) == "not active");
  CHECK(robot.team.reason(1) == "first task");
}

TEST_CASE("A drive that moves to the side has three dimensions") {
  Robot robot({task({0.2, 0.1, 0.5}, 0.0), task({1.0, 0.3, 2.0})}, true);
  const Motion command = robot.robot->decide();
  CHECK(command.forward == Approx(0.2));
  CHECK(command.lateral == Approx(0.3));
  CHECK(command.turn == Approx(2.0));
}

}  // namespace of_null_space
