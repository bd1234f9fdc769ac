// The part of InputMaker for measures and rules.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "elsie/base/words.h"

#include "random_input.h"

namespace elsie::testing {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Robots r1, r2...; usually r1 is the leader.
Scene random_world(int number, Random& random) {
  Scene made;
  const std::size_t robots = number == 2 ? 1 : number == 1 ? 10 : 2 + index(random, 4);
  made.steps_of(0.01, number == 3 ? 5 : 1);
  for (std::size_t i = 0; i < robots; ++i) {
    made.robot("r" + std::to_string(i + 1), random.uniform(-4, 4), random.uniform(-4, 4),
               number == 1 && i % 2 == 1 ? "blue" : "red", random.uniform(-180, 180));
    made.leads(i == 0 && number != 3);
    made.publishes("explore.known", "m2");
    if (number != 2) {
      made.behaves("avoid_obstacle");
      made.behaves("explore");
      made.behaves("explore/find_resource").behaves("explore/wander");
    }
  }
  for (std::size_t i = 0; i < 4; ++i) {
    made.resource("food_" + std::to_string(i + 1), random.uniform(-4, 4), random.uniform(-4, 4),
                  i == 3 ? "blue" : "");
  }
  made.box("crate", ObservedObstacle::Kind::dynamic, random.uniform(-4, 4), random.uniform(-4, 4));
  made.field("pheromone", 8, std::vector<double>(64));
  return made;
}

void move(ObservedRobot& robot, double step_s, bool decides, Random& random) {
  if (decides) {
    const double left = random.uniform(-25, 25);
    robot.command = robot.wheels.motion({left, random.uniform(-25, 25)});
    robot.asked = robot.command;
  }
  robot.moving.forward = random.uniform(-0.5, 0.5);
  robot.moving.turn = random.uniform(-5, 5);
  robot.pose.x += robot.moving.forward * step_s * std::cos(robot.pose.heading_rad);
  robot.pose.y += robot.moving.forward * step_s * std::sin(robot.pose.heading_rad);
  robot.pose.heading_rad = wrap_angle(robot.pose.heading_rad + robot.moving.turn * step_s);
  robot.distance_m += std::abs(robot.moving.forward) * step_s;
  robot.energy_used += 0.03;
  robot.energy = std::max(0.0, robot.energy - 0.03);
  robot.collisions += random.chance(0.05) ? 1 : 0;
  robot.talk.sent += decides ? 1 : 0;
  robot.talk.heard += decides ? 2 : 0;
  if (random.chance(0.02)) {  // a user moves it
    robot.pose.x = random.uniform(-5, 5);
    robot.pose.y = random.uniform(-5, 5);
  }
  if (random.chance(0.01)) {
    robot.is_leader = !robot.is_leader;
  }
}

/// Of a field with 8 x 8 of them.
std::vector<double> random_cells(std::size_t step) {
  Random random(step + 1);  // its own, so that other input stays as it is
  std::vector<double> cells(64);
  for (double& cell : cells) cell = random.chance(0.5) ? random.uniform(0, 100) : 0.0;
  return cells;
}

/// A robot's behaviours by their paths in the scene, and its published numbers.
struct Cast {
  std::string robot;
  std::vector<std::string> behaviors;
  std::vector<int> parents;
  std::vector<std::string> numbers;
};

/// Gives shares to some behaviours at each level; the shares add up to 1 or 0.
void decide(Scene& scene, const Cast& cast, const Motion& command, Random& random) {
  std::vector<double> shares;
  std::map<int, double> sums;
  for (const int parent : cast.parents) {
    shares.push_back(random.chance(0.5) ? random.uniform() : 0.0);
    sums[parent] += shares.back();
  }
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const double sum = sums[cast.parents[i]];
    ObservedBehavior& behavior = scene.behavior(cast.robot, cast.behaviors[i]);
    behavior.share = sum > 0.0 ? shares[i] / sum : 0.0;
    behavior.asked = behavior.share > 0.0 || random.chance(0.5);
    behavior.activation = behavior.asked ? random.uniform() : 0.0;
    behavior.command = behavior.asked ? command : Motion{};
  }
}

std::vector<Cast> casts_of(const Observation& now) {
  std::vector<Cast> casts;
  for (const ObservedRobot& robot : now.robots) {
    Cast& cast = casts.emplace_back();
    cast.robot = robot.id;
    for (const ObservedBehavior& behavior : robot.behaviors) {
      cast.behaviors.emplace_back(behavior.path);
      cast.parents.push_back(behavior.parent);
    }
    for (const ObservedNumber& number : robot.published) {
      cast.numbers.emplace_back(number.name);
    }
  }
  return casts;
}

/// The id of some resource; "" if a randomly chosen box is none.
std::string some_resource(const Observation& now, Random& random) {
  if (now.obstacles.empty()) {
    return "";
  }
  const ObservedObstacle& box = now.obstacles[index(random, now.obstacles.size())];
  return box.kind == ObservedObstacle::Kind::resource ? std::string(box.id) : "";
}

}  // namespace

Input InputMaker::make_watched(int number, Random& random) const {
  Input input;
  const bool given = !options_.scenes.empty();
  Scene now =
      given ? options_.scenes[static_cast<std::size_t>(number)] : random_world(number, random);
  now.restart();
  const std::vector<Cast> casts = casts_of(now.observation());
  input.robot = given ? "world " + std::to_string(number + 1) + " of those given"
                      : "a world with " + base::counted(casts.size(), "robot");
  input.watched.push_back(now);
  for (std::size_t step = 0; step < kInstants; ++step) {
    now.step();
    const double step_s = now.observation().step_s;
    const bool decides = now.observation().decided;
    for (const Cast& cast : casts) {
      const int collisions = now[cast.robot].collisions;
      move(now[cast.robot], step_s, decides, random);
      if (now[cast.robot].collisions > collisions) now.event("collision", cast.robot);
      if (decides) {
        decide(now, cast, now[cast.robot].command, random);
      }
      for (const std::string& name : cast.numbers) {
        now.number(cast.robot, name) = random.chance(0.9) ? random.uniform(-10, 10) : kNone;
      }
    }
    if (!now.observation().fields.empty() && decides && !given) {
      now.field("pheromone", 8, random_cells(step));
    }
    if (const std::string box = some_resource(now.observation(), random);
        !box.empty() && !casts.empty() && random.chance(0.1)) {
      input.gone.push_back(box);
      const std::string& collector = casts[index(random, casts.size())].robot;
      ++now[collector].collected;
      now.event("collected", collector);
      now.remove_obstacle(box);
    }
    input.watched.push_back(now);
  }
  return input;
}

Scene instant(const Input& input, std::size_t step) {
  const std::vector<Scene>& instants = input.watched;
  const std::size_t count = instants.size() - 1;  // the first is the start
  const std::size_t whole_laps = step / count;
  const auto laps = static_cast<double>(whole_laps);
  const Observation& first = instants[1 + step % count].observation();
  Scene now = instants[1 + step % count];
  const Observation& last = instants.back().observation();
  for (const ObservedRobot& total : last.robots) {
    ObservedRobot& robot = now[std::string(total.id)];
    robot.distance_m += laps * total.distance_m;
    robot.energy_used += laps * total.energy_used;
    robot.collisions += static_cast<int>(laps) * total.collisions;
    robot.collected += static_cast<int>(laps) * total.collected;
    robot.talk.sent += static_cast<int>(laps) * total.talk.sent;
    robot.talk.heard += static_cast<int>(laps) * total.talk.heard;
  }
  if (laps > 0.0) {
    for (const std::string& box : input.gone) now.remove_obstacle(box);
  }
  now.at_step(static_cast<int>(step) + 1);
  for (const ObservedEvent& event : first.events) {
    now.event(std::string(event.name), std::string(event.robot));
  }
  return now;
}

}  // namespace elsie::testing
