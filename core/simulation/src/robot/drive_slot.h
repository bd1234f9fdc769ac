// A robot's drive, and what disturbs the joints that it sets.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "elsie/api/drive.h"

#include "plugins/plugin_object.h"
#include "robot/disturbances.h"

namespace elsie::simulation {

/// A joint that a drive sets: the name of its part, and how far it turns to either side.
struct NamedJoint {
  std::string name;
  double most_rad = 0.0;
};

/// Those of a body.
std::vector<NamedJoint> joints_of(const BodyPlan& plan);

/// The noise and the failures that a world file gives a drive. The drive itself goes on as without
/// them. Numbers are called "PART.rate" (rad/s) and "PART.angle" (rad).
class DisturbedJoints {
 public:
  /// Throws std::invalid_argument with a sentence if a noise names no joint.
  static void check(const Drive& drive, std::span<const NamedJoint> joints);

  /// Takes over the drive's disturbances; random streams go on. Requires check().
  void fit(const Drive& drive, std::span<const NamedJoint> joints);
  void reset(std::uint64_t seed, const std::string& path);
  /// Called after each command of the drive: changes its set points. Angles stay within the limits
  /// of the joints.
  void update(std::span<JointSetting> joints, double time_s, double period_s);
  /// Whether a command was disturbed since the run began: it stays until the next one.
  bool has_begun() const { return !arrived_.empty(); }

 private:
  struct Target {
    std::size_t joint;
    double JointSetting::*number;
    double most;  // infinite: any
  };
  struct Command {
    double time_s = 0.0;
    std::vector<JointSetting> joints;
  };

  Disturbances disturbances_;
  std::vector<Target> targets_;   // of each noise
  std::deque<Command> commands_;  // on their way to the joints
  std::vector<JointSetting> arrived_;
};

struct DriveSlot final : ObjectOf<Drive, PluginKind::drive> {
  using ObjectOf::ObjectOf;
  void equip(Component& object, const Example& example) const override;
  void reset(std::uint64_t seed, const std::string& path) override;

  std::vector<NamedJoint> joints;                      // that it sets
  mutable std::unique_ptr<DisturbedJoints> disturbed;  // null: neither noise nor failures
};

}  // namespace elsie::simulation
