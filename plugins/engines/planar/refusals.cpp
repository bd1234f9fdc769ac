#include "refusals.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "elsie/base/number_text.h"

#include "softness.h"

namespace elsie::physics {
namespace {

constexpr double kUpright = 1e-6;  // of 1

constexpr const char* kOther = ", or the engine 'ode', which has all three dimensions";

std::string above(const std::string& what, double z, const char* would) {
  return what + " is " + base::number_text(z) + " m above the floor and would " + would +
         ", but the engine 'planar' keeps everything at its height; expected z=\"0\"" + kOther;
}

// Contacts are found anew for each part of a step. In this time, robots and boxes of ordinary size
// and speed turn and move little.
constexpr double kLongestPart = 0.01;  // s
constexpr double kRoundingOfParts = 1e-9;
constexpr double kMostParts = 1000.0;  // more than a world can ask for

}  // namespace

int parts_of(double step) {
  return static_cast<int>(
      std::clamp(std::ceil(step / kLongestPart - kRoundingOfParts), 1.0, kMostParts));
}

std::optional<std::string> fault_of(const world::Physics& physics) {
  if (physics.gravity <= 0.0) return std::nullopt;
  return "gravity is " + base::number_text(physics.gravity) +
         " m/s2, which lifts everything, but the engine 'planar' keeps everything at its height; "
         "expected at most 0" +
         kOther;
}

std::optional<std::string> fault_of(const world::Obstacle& box, const std::string& what) {
  if (!box.is_dynamic() || box.z == 0.0) return std::nullopt;
  return above(what, box.z, "fall");
}

std::optional<std::string> fault_of_height(double z, const std::string& what) {
  if (z == 0.0) return std::nullopt;
  return above(what, z, "fall");
}

std::optional<std::string> fault_of(const BodyPlan& plan, const std::string& what) {
  for (const Part& part : plan.parts) {
    if (std::abs(part.frame.up.z - 1.0) > kUpright) {
      return what + " has a part that is not upright, '" + part.name +
             "', but the engine 'planar' has no tilted parts; expected an upright one" + kOther;
    }
  }
  return std::nullopt;
}

}  // namespace elsie::physics

// Contacts are rigid: there is no cfm.
extern "C" __attribute__((visibility("default"))) void elsie_engine_parameters(
    std::vector<elsie::world::AttributeSpec>& parameters) {
  parameters = elsie::physics::softness_parameters();
  std::erase_if(parameters, [](const auto& parameter) { return parameter.name == "cfm"; });
}

extern "C" __attribute__((visibility("default"))) void elsie_check_world(
    const elsie::world::World& world, elsie::base::Problems& problems) {
  using namespace elsie::physics;
  const auto add = [&](const elsie::world::Location& where, const auto& fault) {
    if (fault) problems.add(where, *fault);
  };
  check_softness(world.physics, problems);
  add(world.physics.location, fault_of(world.physics));
  for (const elsie::world::Obstacle& box : world.obstacles) {
    add(box.location, fault_of(box, "the box '" + box.id + "'"));
  }
  for (const elsie::world::Robot& robot : world.robots) {
    if (!fault_of_height(robot.z, "") && !fault_of(robot.driven, "")) continue;  // without a name
    const std::string what = "the robot '" + robot.id + "'";
    add(robot.location, fault_of_height(robot.z, what));
    add(robot.location, fault_of(robot.driven, what));
  }
}
