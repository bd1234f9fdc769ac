// The parts of robots and controllers that put new plugin objects in the places of old ones.
#include <algorithm>
#include <optional>
#include <string>

#include "elsie/world/parts.h"

#include "replacement/swap.h"
#include "step/cameras.h"
#include "step/controller.h"
#include "step/robot.h"

namespace elsie::simulation {
namespace {

/// As far as the joints that a drive sets depend on it.
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

void Controller::replace(Swap& swap, const std::string& path) {
  for (const auto& each : slots_) {
    Slot& slot = *each;
    const std::string name = path + "behavior[" + slot.use->id + "]";
    if (slot.inside) {
      slot.inside->replace(swap, name + "/");
    }
    const bool is_new = swap.exchange<Behavior>(PluginKind::behavior, *slot.use, name, slot.object,
                                                slot.declaration, slot.random, slot.inside.get());
    if (is_new) {
      // Its events are named by the old library.
      swap.when_settled([&slot] { slot.response = {}; });
    }
  }
  if (coordinator_) {
    swap.exchange<Coordinator>(PluginKind::coordinator, *description_->coordinator,
                               path + "coordinator", coordinator_, coordinator_declaration_,
                               random_);
  }
}

void Controller::check_needs(std::span<const ReadingGroup> groups, const std::string& robot,
                             const std::string& path) const {
  for (const auto& each : slots_) {
    const Slot& slot = *each;
    const std::string name = path + "behavior[" + slot.use->id + "]";
    for (const ReadingDeclaration& need : slot.declaration->needs) {
      const auto is_kind = [&](const ReadingGroup& group) { return group.kind.name == need.kind; };
      const auto of_size = [&](const ReadingGroup& group) {
        return is_kind(group) && group.kind.size == need.size;
      };
      if (std::none_of(groups.begin(), groups.end(), of_size)) {
        const bool other = std::any_of(groups.begin(), groups.end(), is_kind);
        Swap::refuse(robot, name,
                     "it needs readings of the kind '" + need.kind + "', " +
                         (other ? "of which its sensors have another size; build the plugins of "
                                  "both with the same header"
                                : "which no sensor of the robot makes"));
      }
    }
    if (slot.inside) {
      slot.inside->check_needs(groups, robot, name + "/");
    }
  }
}

void Robot::replace(Swap& swap, const Cameras& cameras) {
  swap.begin_robot(description_->id, tuning_);
  swap.undo([this] { regroup(); });  // last of all, once the old sensors are back
  const std::size_t first = swap.all().size();
  for (const auto& each : sensors_) {
    SensorSlot& slot = *each;
    replace(swap, slot, cameras);
  }
  replace_drive(swap);
  controller_->replace(swap, "");
  if (swap.all().size() == first) {
    return;
  }
  regroup();
  controller_->check_needs(groups_, description_->id, "");
  for (std::size_t i = first; i < swap.all().size(); ++i) {
    const Swap::Exchanged& exchanged = swap.all()[i];
    swap.when_settled([this, use = exchanged.use] { guard_.forget(*use); });
    const TunedObject object = object_of(*exchanged.use);
    swap.run(exchanged, [&] { Tuning::equip(object, *object.object, example()); });
  }
  swap.hand_over(first);
}

void Robot::replace(Swap& swap, SensorSlot& slot, const Cameras& cameras) {
  const std::string path = "sensor[" + slot.use->id + "]";
  const std::string kind = slot.object->kind().name;
  const std::optional<Camera> before = slot.camera;
  swap.undo([&slot, before] { slot.camera = before; });
  if (!swap.exchange<Sensor>(PluginKind::sensor, *slot.use, path, slot.object, slot.declaration,
                             slot.random)) {
    return;
  }
  const auto refuse = [&](const std::string& problem) {
    Swap::refuse(description_->id, path, problem);
  };
  swap.run(swap.all().back(), [&] { slot.camera = slot.object->camera(); });
  if (kind != slot.object->kind().name) {
    refuse("it makes readings of the kind '" + std::string(slot.object->kind().name) +
           "' now, and made some of the kind '" + kind +
           "' before; replace its element by an edit, or run the world anew");
  }
  if (slot.camera.has_value() != before.has_value()) {
    refuse("it would " + std::string(before ? "cease" : "begin") +
           " to look through a camera; replace its element by an edit, or run the world anew");
  }
  if (const auto problem = slot.camera ? cameras.problem_of(*slot.camera) : std::nullopt) {
    refuse(*problem);
  }
}

void Robot::replace_drive(Swap& swap) {
  swap.undo([this, wheels = state_.wheels, channels = state_.channels] {
    state_.wheels = wheels;
    state_.channels = channels;
  });
  if (!swap.exchange<Drive>(PluginKind::drive, drive_use(), "drive", drive_, drive_declaration_,
                            drive_random_)) {
    return;
  }
  BodyPlan plan;
  const Chassis chassis = world::chassis_of(description_->body);
  swap.run(swap.all().back(), [&] {
    plan = world::plan_of(chassis, *drive_);
    state_.wheels = drive_->wheels(chassis);
    state_.channels = drive_->channels();
  });
  if (!same_body(plan, world::driven_plan(*description_))) {
    Swap::refuse(
        description_->id, "drive",
        "it would build another body now; replace its element by an edit, or run the world "
        "anew");
  }
}

void Robot::regroup() {
  sensed_.clear();
  groups_.clear();
  group_readings();
  perception_.groups = groups_;
}

}  // namespace elsie::simulation
