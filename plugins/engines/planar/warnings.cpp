// Warns of speeds at which bodies lose way where they touch; moving boxes that reach into walls;
// robots that would topple in three dimensions; an erp that hardly moves bodies apart; settings
// without effect.
#include "elsie/world/warnings.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "elsie/base/number_text.h"
#include "elsie/world/footprint.h"

#include "dangers.h"
#include "refusals.h"
#include "softness.h"

namespace elsie::world {
namespace {

constexpr double kLeastErp = 0.01;

class Search {
 public:
  Search(const World& world, std::vector<Warning>& found) : world_(world), found_(found) {}

  void find() {
    physics();
    for (std::size_t i = 0; i < world_.robots.size(); ++i) robot(world_.robots[i], i);
    for (std::size_t i = 0; i < world_.obstacles.size(); ++i) box(world_.obstacles[i], i);
  }

 private:
  void add(Warning::About about, std::size_t index, const Location& location,
           const std::optional<std::string>& message) {
    if (message) found_.push_back({about, index, location, *message});
  }

  void physics() {
    const Physics& p = world_.physics;
    if (const int parts = physics::parts_of(p.step); parts > 1) {
      add(Warning::About::no_effect, 0, p.location,
          "the engine 'planar' does a step of " + base::number_text(p.step) + " s in " +
              std::to_string(parts) +
              " equal parts, because contacts need steps of at most 0.01 s");
    }
    if (const double erp = physics::softness_of(p).erp; erp < kLeastErp) {
      add(Warning::About::physics, 0, p.location,
          "erp is " + base::number_text(erp, 3) +
              ": bodies that overlap are hardly moved apart; expected 0.1 to 0.8");
    }
  }

  void speed(Warning::About about, std::size_t index, const Location& location,
             const std::string& name, double speed, double size) {
    const int parts = physics::parts_of(world_.physics.step);
    add(about, index, location,
        physics::danger_of_speed(name, speed, size, world_.physics.step / parts,
                                 ", so that it stays behind where it touches something"));
  }

  void robot(const Robot& robot, std::size_t index) {
    const std::string name = "the robot '" + robot.id + "'";
    speed(Warning::About::robot, index, robot.location, name, robot.max_speed,
          std::min(robot.body.length, robot.body.width));
    add(Warning::About::robot, index, robot.location,
        physics::danger_of_height(
            name, robot, ", and would topple, but the engine 'planar' keeps everything upright"));
  }

  void box(const Obstacle& box, std::size_t index) {
    if (box.kind != ObstacleKind::moving || box.waypoints.empty()) return;
    const Vector3 size = fixture_of(box).shape.size;
    speed(Warning::About::obstacle, index, box.location, box.in_words(), box.speed,
          std::min(size.x, size.y));
    add(Warning::About::obstacle, index, box.location,
        physics::danger_of_path(world_, box, ", and ends the run where it presses a body into it"));
  }

  const World& world_;
  std::vector<Warning>& found_;
};

}  // namespace
}  // namespace elsie::world

extern "C" __attribute__((visibility("default"))) void elsie_warn(
    const elsie::world::World& world, std::vector<elsie::world::Warning>& warnings) {
  elsie::physics::add_idle_parameters(world, warnings);
  elsie::world::Search(world, warnings).find();
}
