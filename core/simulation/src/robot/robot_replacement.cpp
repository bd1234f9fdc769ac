// The functions of robots that replace old plugin objects by new ones.
#include <algorithm>
#include <optional>
#include <string>

#include "elsie/world/parts.h"

#include "replacement/swap.h"
#include "robot/controller.h"
#include "robot/robot.h"
#include "step/cameras.h"

namespace elsie::simulation {
namespace {

/// Compares only what matters for the joints that a drive sets.
bool same_body(const BodyPlan& a, const BodyPlan& b) {
  return std::equal(a.parts.begin(), a.parts.end(), b.parts.begin(), b.parts.end(),
                    [](const Part& one, const Part& other) {
                      return one.vehicle == other.vehicle &&
                             one.frame.origin == other.frame.origin &&
                             one.shape.size == other.shape.size &&
                             one.joint.index() == other.joint.index() &&
                             can_be_set(one.joint) == can_be_set(other.joint);
                    });
}

}  // namespace

void Robot::replace(Swap& swap, const Cameras& cameras) {
  swap.begin_robot(description_->id);
  swap.undo().add([this] { group_readings(); });  // undone last, after the old sensors
  for (const auto& slot : sensors_) replace_sensor(swap, *slot, cameras);
  for (const auto& slot : actuators_) {
    exchange(swap, *slot, "actuator[" + slot->use->id + "]", "it takes commands", "took");
  }
  replace_drive(swap);
  if (localisation_) swap.exchange(*localisation_, "localisation");
  const bool has_new_body = swap.concerns_robot();
  controller_->for_each(
      Order::inner_first, "", "", [&](PluginObject& each, const std::string& path, const auto&) {
        const bool sees_more = has_new_body || each.kind == PluginKind::coordinator;
        if (!swap.exchange(each, path) && sees_more) swap.stays(each, path);
      });
  controller_->forget_acts();  // their code may be in a library that is to be unloaded
  if (swap.concerns_robot()) {
    group_readings();
    check_needs();
    swap.hand_over(example());
  }
}

template <class Slot>
bool Robot::exchange(Swap& swap, Slot& slot, const std::string& path, const char* makes,
                     const char* made) {
  const ReadingKind before = slot.object().kind();
  if (slot.disturbed) swap.undo().keep(*slot.disturbed);
  if (!swap.exchange(slot, path)) return false;
  const ReadingKind now = slot.object().kind();
  if (!now.has_name_of(before)) {
    swap.refuse(path, std::string(makes) + " of the kind '" + now.name + "' now, and " + made +
                          " some of the kind '" + before.name +
                          "' before; replace its element by an edit, or start a new run");
  }
  if (slot.disturbed) slot.disturbed->renew(slot.object(), now == before);
  return true;
}

void Robot::replace_sensor(Swap& swap, SensorSlot& slot, const Cameras& cameras) {
  const std::string path = "sensor[" + slot.use->id + "]";
  const bool had_camera = slot.extras().camera.has_value();
  if (!exchange(swap, slot, path, "it makes readings", "made")) return;
  std::optional<Camera> camera;
  swap.run(slot, path, [&] { camera = slot.object().camera(); });
  if (camera.has_value() != had_camera) {
    swap.refuse(path, "it would " + std::string(had_camera ? "lose" : "gain") +
                          " a camera; replace its element by an edit, or start a new run");
  }
  if (!camera) return;
  if (const auto problem = cameras.problem_of(*camera)) {
    swap.refuse(path, *problem);
  }
  swap.undo().keep(slot.own_extras().camera);
  slot.own_extras().camera = camera;
}

void Robot::replace_drive(Swap& swap) {
  if (!swap.exchange(*drive_, "drive")) return;
  swap.undo().keep(state_.wheels, state_.channels);
  BodyPlan plan;
  const Chassis chassis = world::chassis_of(description_->body);
  swap.run(*drive_, "drive", [&] {
    Drive& drive = drive_->object();
    plan = world::plan_of(chassis, drive);
    state_.wheels = drive.wheels(chassis);
    state_.channels = drive.channels();
  });
  if (!same_body(plan, world::driven_plan(*description_))) {
    swap.refuse("drive",
                "it would build another body now; replace its element by an edit, or start a new "
                "run");
  }
}

void Robot::check_needs() const {
  std::vector<ReadingDeclaration> made, taken;
  for (const auto& slot : sensors_) made.push_back(slot->declaration->produces.front());
  for (const auto& slot : actuators_) taken.push_back(slot->declaration->takes.front());
  for_each(Order::outer_first, [&](PluginObject& each, const std::string& path, const auto&) {
    if (each.kind != PluginKind::behavior) return;
    const auto check = [&](const std::vector<ReadingDeclaration>& needs,
                           const std::vector<ReadingDeclaration>& there, const char* verb,
                           const char* none, const char* others) {
      for (const ReadingDeclaration& need : needs) {
        const auto is_kind = [&](const auto& one) { return one.kind == need.kind; };
        const auto fits = [&](const auto& one) { return is_kind(one) && one.fits(need); };
        if (std::any_of(there.begin(), there.end(), fits)) continue;
        const bool other = std::any_of(there.begin(), there.end(), is_kind);
        throw ReplacementRefused("robot '" + description_->id + "', " + path + ": it " + verb +
                                 " of the kind '" + need.kind + "', " + (other ? others : none));
      }
    };
    check(each.declaration->needs, made, "needs readings", "which no sensor of the robot makes",
          "but its sensors make them with another layout; build all these plugins with the same "
          "header");
    check(each.declaration->commands, taken, "gives commands",
          "which no actuator of the robot takes",
          "but its actuators take them with another layout; build all these plugins with the same "
          "header");
  });
}

}  // namespace elsie::simulation
