// What engines note of robots that are watched: contacts with their impulses, and accelerations.
#include <array>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "conformance.h"

using namespace elsie;
using namespace elsie::physics;
using world::ObstacleKind;

namespace {

world::Physics smooth(const std::string& engine, double step) {
  world::Physics physics = with(engine, step);
  physics.friction = 0.0;
  return physics;
}

double pressing(const PhysicsContext& context, std::size_t robot) {
  double sum = 0.0;
  for (const BodyContact& contact : context.engine->contacts(robot)) sum += contact.pressing();
  return sum;
}

}  // namespace

TEST_CASE("What a box gives a body that it bumps into is the body's momentum") {
  const std::string engine = each_engine();
  const double step = GENERATE(1e-6, 1e-4, 0.01, 0.1), speed = GENERATE(0.05, 0.5);
  CAPTURE(engine, step, speed);
  constexpr double kMass = 0.3, kHalf = 0.05;
  PhysicsContext context(smooth(engine, step), open_field());
  const auto robot =
      context.engine->add_robot(alone(Shape::box({0.1, 0.1, 0.1}), kMass), {0.0, 0.0, 0.0});
  context.engine->watch_contacts(robot);
  // Ten steps away.
  const double from = -kHalf - 0.1 - 9.5 * step * speed;
  const auto box = context.obstacle(ObstacleKind::moving, from, 0.0, {0.2, 0.3, 0.2});
  double sum = 0.0;
  std::size_t most = 0;
  context.drive(box, {speed, 0.0}, 40.0 * step, [&] {
    sum += pressing(context, robot);
    most = std::max(most, context.engine->contacts(robot).size());
    for (const BodyContact& contact : context.engine->contacts(robot)) {
      CHECK(contact.vehicle == 0);
      CHECK(contact.other == box_body(box));
      CHECK(contact.normal.x == Approx(1.0).margin(1e-6));
      CHECK(contact.point.x == Approx(context.engine->robot(robot).frame.origin.x - kHalf)
                                   .margin(1e-3 + 2.0 * step * speed));
      CHECK(std::abs(contact.point.y) <= kHalf + 1e-3);
    }
  });
  CHECK(most >= 1);
  const double reached = context.engine->robot(robot).speed;
  CHECK(reached == Approx(speed).epsilon(0.1));  // soft contacts push back a little
  CHECK(sum == Approx(kMass * reached).epsilon(0.005));
}

TEST_CASE("A robot that pushes against a wall feels it, and nothing once it has left") {
  const std::string engine = each_engine();
  const double step = GENERATE(0.001, 0.02);
  PhysicsContext context(with(engine, step), {.length = 4.0, .width = 4.0});
  const auto robot = context.robot(1.8, 0.0);
  const auto other = context.robot(1.8, 1.0);
  context.engine->watch_contacts(robot);
  context.drive(robot, {10, 10});
  context.drive(other, {10, 10});
  context.run(2.0);
  REQUIRE(context.touching(robot_body(robot), wall_body(0)));
  const auto contacts = context.engine->contacts(robot);
  REQUIRE_FALSE(contacts.empty());
  for (const BodyContact& contact : contacts) {
    CHECK(contact.other == wall_body(0));
    CHECK(contact.normal.x == Approx(-1.0).margin(1e-6));
    CHECK(contact.point.x == Approx(2.0).margin(1e-3));
    CHECK(contact.point.z > 0.0);
    CHECK(contact.point.z < 0.1);
  }
  // The force of the push, whatever the step.
  CHECK(pressing(context, robot) > 0.01 * step);
  CHECK(context.engine->contacts(other).empty());  // it is not watched
  context.drive(robot, {-10, -10});
  context.run(1.0);
  CHECK(context.engine->contacts(robot).empty());
  CHECK_THROWS_AS(context.engine->contacts(7), std::out_of_range);
  CHECK_THROWS_AS(context.engine->watch_contacts(7), std::out_of_range);
}

TEST_CASE("A robot tells which of its segments was touched") {
  const std::string engine = each_engine();
  PhysicsContext context(with(engine), open_field());
  const auto train = context.train(0.0, 0.0, 0.0, {world::Segment(), world::Segment()});
  context.engine->watch_contacts(train);
  const std::size_t segment = GENERATE(0u, 1u);
  const Vector3 at = context.engine->segment(train, segment).frame.origin;
  const auto box = context.obstacle(ObstacleKind::moving, at.x, 0.3, {0.02, 0.2, 0.2});
  bool is_met = false;
  context.drive(box, {0.0, -0.2}, 1.0, [&] {
    for (const BodyContact& contact : context.engine->contacts(train)) {
      is_met = true;
      CHECK(contact.vehicle == segment + 1);
      CHECK(contact.other == box_body(box));
      CHECK(contact.normal.y < -0.7);
    }
  });
  CHECK(is_met);
}

TEST_CASE("Both robots of a contact feel the same impulse, in opposite directions") {
  const std::string engine = each_engine();
  std::size_t pairs = 0;
  Bustle bustle{.seed = 3, .steps = 300, .side = 5, .apart = 0.3};
  bustle.after_each_step = [&](const Engine& now) {
    for (std::size_t robot = 0; robot <= 25; ++robot) {
      for (const BodyContact& contact : now.contacts(robot)) {
        if (contact.other.kind != BodyKind::robot) continue;
        const auto others = now.contacts(contact.other.index);
        const auto same = std::count_if(others.begin(), others.end(), [&](const BodyContact& each) {
          return each.other == robot_body(robot) && each.point == contact.point &&
                 each.normal == -1.0 * contact.normal && each.impulse == -1.0 * contact.impulse;
        });
        CHECK(same >= 1);
        ++pairs;
      }
      const auto touches = now.touches();
      for (const Touch& touch : touches) {
        if (touch.a != robot_body(robot)) continue;
        const auto own = now.contacts(robot);
        // A contact that only pushed in the step before is a touch, too.
        CHECK(std::count_if(own.begin(), own.end(), [&](const BodyContact& each) {
                return each.other == touch.b;
              }) >= (engine == "ode" ? 1 : 0));
      }
    }
  };
  history(engine, bustle);
  CHECK(pairs > 100);
}

TEST_CASE("Watching changes no bit, and contacts do not depend on the threads") {
  const std::string engine = each_engine();
  Bustle bustle{.seed = 4, .steps = 200, .side = 6, .apart = 0.25};
  const auto unwatched = history(engine, bustle);
  std::vector<std::vector<BodyContact>> with_threads;
  for (const std::size_t threads : {1, 2, 8}) {
    std::vector<BodyContact>& all = with_threads.emplace_back();
    bustle.after_each_step = [&](const Engine& now) {
      for (std::size_t robot = 0; robot <= 36; ++robot) {
        const auto some = now.contacts(robot);
        all.insert(all.end(), some.begin(), some.end());
      }
    };
    CHECK(history(engine, bustle, threads) == unwatched);
  }
  CHECK(with_threads[0].size() > 100);
  CHECK(with_threads[0] == with_threads[1]);
  CHECK(with_threads[0] == with_threads[2]);
}

TEST_CASE("The motion of a body in space is that in its plane") {
  const std::string engine = each_engine();
  const double step = GENERATE(1e-6, 1e-3, 0.01, 0.1);
  CAPTURE(engine, step);
  PhysicsContext context(with(engine, step), open_field());
  const auto robot = context.robot(0.0, 0.0, 40.0);
  context.drive(robot, {8, 12});
  for (int i = 0; i < 200; ++i) {
    context.engine->step();
  }
  const RobotState state = context.engine->robot(robot);
  const BodyMotion motion = context.engine->motion(robot);
  CHECK(dot(motion.velocity, state.frame.forward) == Approx(state.speed).epsilon(1e-3));
  CHECK(dot(motion.velocity, state.frame.left) == Approx(state.lateral).margin(1e-4));
  CHECK(motion.turning.z == Approx(state.turn_rate).epsilon(1e-9));
}

TEST_CASE("A robot that another engine takes over stays watched") {
  const std::string engine = each_engine();
  PhysicsContext context(with(engine), {.length = 4.0, .width = 4.0});
  const auto robot = context.robot(1.9, 0.0);
  context.engine->watch_contacts(robot);
  context.drive(robot, {10, 10});
  context.run(1.0);
  const auto next = make_engine(context.arena, context.physics);
  next->add_robot_of(*context.engine, robot);
  next->go_on_from(*context.engine);
  CHECK(next->contacts(0).empty());  // of no step
  next->step();
  context.engine->step();
  const auto expected = context.engine->contacts(robot), found = next->contacts(0);
  CHECK(std::equal(found.begin(), found.end(), expected.begin(), expected.end()));
  CHECK_FALSE(found.empty());
}
