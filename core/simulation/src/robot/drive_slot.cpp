#include "robot/drive_slot.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <variant>

namespace elsie::simulation {
namespace {

constexpr std::pair<const char*, double JointSetting::*> kNumbers[] = {
    {".rate", &JointSetting::rate_rad_s}, {".angle", &JointSetting::angle_rad}};

}  // namespace

std::vector<NamedJoint> joints_of(const BodyPlan& plan) {
  std::vector<NamedJoint> joints;
  for (const Part& part : plan.parts) {
    if (!can_be_set(part.joint)) continue;
    const auto* wheel = std::get_if<WheelJoint>(&part.joint);
    const auto* hitch = std::get_if<HitchJoint>(&part.joint);
    joints.push_back({part.name, wheel   ? (wheel->steered ? wheel->max_steer_rad : 0.0)
                                 : hitch ? hitch->max_yaw_rad
                                         : 0.0});
  }
  return joints;
}

void DisturbedJoints::check(const Drive& drive, std::span<const NamedJoint> joints) {
  std::vector<std::string> names;
  for (const NamedJoint& joint : joints) {
    names.push_back(joint.name + ".rate");
    if (joint.most_rad > 0.0) names.push_back(joint.name + ".angle");
  }
  for (const Disturbance& each : drive.disturbances()) {
    if (const auto* noise = std::get_if<Noise>(&each)) {
      Disturbances::check(*noise, names, "its joints");
    }
  }
}

void DisturbedJoints::fit(const Drive& drive, std::span<const NamedJoint> joints) {
  disturbances_.fit(drive.disturbances());
  targets_.clear();
  for (const Noise& noise : disturbances_.noises()) {
    for (std::size_t i = 0; i < joints.size(); ++i) {
      for (const auto& [suffix, number] : kNumbers) {
        if (noise.on != joints[i].name + suffix) continue;
        const bool is_angle = number == &JointSetting::angle_rad;
        targets_.push_back(
            {i, number, is_angle ? joints[i].most_rad : std::numeric_limits<double>::infinity()});
      }
    }
  }
}

void DisturbedJoints::reset(std::uint64_t seed, const std::string& path) {
  disturbances_.reset(seed, path);
  commands_.clear();
  arrived_.clear();
}

void DisturbedJoints::update(std::span<JointSetting> joints, double time_s, double period_s) {
  arrived_.resize(joints.size());
  const double slack = 1e-6 * period_s;
  const bool is_missed = disturbances_.misses_update();
  if (!disturbances_.is_stuck(time_s + slack)) {
    Command command{time_s, {joints.begin(), joints.end()}};
    for (std::size_t noise = 0; noise < targets_.size(); ++noise) {
      const Target& target = targets_[noise];
      double& number = command.joints[target.joint].*target.number;
      number = std::clamp(disturbances_.disturbed(noise, number), -target.most, target.most);
    }
    if (!is_missed) commands_.push_back(std::move(command));
    while (!commands_.empty() &&
           commands_.front().time_s <= time_s - disturbances_.latency_s() + slack) {
      arrived_ = std::move(commands_.front().joints);
      commands_.pop_front();
    }
  }
  std::copy(arrived_.begin(), arrived_.end(), joints.begin());
}

void DriveSlot::equip(Component& object, const Example& /*example*/) const {
  const auto& drive = static_cast<const Drive&>(object);
  DisturbedJoints::check(drive, joints);
  if (&object != held.get()) return;  // it is only tried
  if (!disturbed) {
    if (drive.disturbances().empty()) return;
    disturbed = std::make_unique<DisturbedJoints>();
  }
  disturbed->fit(drive, joints);
}

void DriveSlot::reset(std::uint64_t seed, const std::string& path) {
  if (disturbed) disturbed->reset(seed, path);
  PluginObject::reset(seed, path);
}

}  // namespace elsie::simulation
