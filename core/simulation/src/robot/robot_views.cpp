// What viewers see of a robot's plugins: readings, published numbers, sketches.
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "robot/robot.h"

namespace elsie::simulation {

SensorView Robot::sensor(std::size_t index) const {
  const SensorSlot& slot = *sensors_[index];
  const PluginObject::Extras& extras = slot.extras();
  return {
      slot.use->id,
      slot.use->plugin,
      &slot.object(),
      &slot.place->mounting,
      extras.camera ? &*extras.camera : nullptr,
      extras.camera && extras.picture && !extras.picture->empty() ? extras.picture.get() : nullptr};
}

ActuatorView Robot::actuator_view(std::size_t index) const {
  const ActuatorSlot& slot = *actuators_[index];
  return {slot.use->id, slot.use->plugin,      &slot.object(),
          slot.by,      frame_of(*slot.place), slot.shown.shine};
}

void Robot::visit_value(const PluginObject& slot, const ReadingDeclaration& declared,
                        const FieldVisit& visit) const {
  const auto& object = static_cast<const Disturbable&>(*slot.held);
  const std::string what = object.value_name();
  std::exception_ptr of_visitor;  // no fault of the plugin
  guard_.look(*slot.use, [&] {
    auto expected = declared.fields.begin();
    const auto end = declared.fields.end();
    object.visit_fields(object.value(), [&](const ReadingField& field) {
      if (field.item == 0 &&
          (expected == end || expected->name != field.name || (expected++)->group != field.group)) {
        guard_.fail(*slot.use, "its " + what + " lists '" + field.path() +
                                   "' in visit() in another place than a new one; every " + what +
                                   " must list the same names in the same order");
      }
      if (of_visitor) return;
      try {
        visit(field);
      } catch (...) {
        of_visitor = std::current_exception();
      }
    });
    if (expected != end) {
      guard_.fail(*slot.use, "its " + what + " does not list '" + expected->name +
                                 "' in visit(), as a new one does; every " + what +
                                 " must list the same names in the same order");
    }
  });
  if (of_visitor) std::rethrow_exception(of_visitor);
}

void Robot::visit_published(const VisitPublished& visit) const {
  for_each(Order::outer_first,
           [&](PluginObject& each, const std::string&, const std::string& within) {
             list_published(each, within, guard_, visit);
           });
}

std::vector<PluginSketch> Robot::sketches() const {
  std::vector<PluginSketch> sketches;
  const auto add = [&](PluginObject& each, const std::string& within, const Frame& frame) {
    add_sketch(each, within, frame, guard_, sketches);
  };
  const Pose& pose = truth_.pose;
  const Frame heading = Frame::turned({pose.x, pose.y, 0.0}, pose.heading_rad, 0.0);
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    add(*sensors_[i], "", sensor_frame(i));
  }
  for (const auto& slot : actuators_) {
    add(*slot, "", frame_of(*slot->place));
    Sketch heard({});  // in the world
    for (const HeardMessage& each : heard_) {
      if (each.device != slot->use->id) continue;
      heard.arrow(SketchRole::message, each.sender_at, frame_of(*slot->place).origin);
    }
    if (!heard.empty()) sketches.push_back({slot->use->id, slot->kind, std::move(heard)});
  }
  for_each(Order::outer_first,
           [&](PluginObject& each, const std::string&, const std::string& within) {
             if (each.kind != PluginKind::sensor && each.kind != PluginKind::actuator) {
               add(each, within, heading);
             }
           });
  return sketches;
}

}  // namespace elsie::simulation
