// What a robot does besides moving: its actuators.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "elsie/base/error.h"
#include "elsie/base/number_text.h"
#include "elsie/base/words.h"

#include "robot/robot.h"

namespace elsie::simulation {

std::size_t Robot::actuator_for(const Act& act) const {
  const auto names_it = [&](const auto& slot) { return act.actuator() == slot->use->id; };
  const auto takes_it = [&](const auto& slot) { return slot->object().kind() == act.kind(); };
  const auto found = act.actuator().empty()
                         ? std::find_if(actuators_.begin(), actuators_.end(), takes_it)
                         : std::find_if(actuators_.begin(), actuators_.end(), names_it);
  if (found == actuators_.end()) {
    std::vector<std::string> ids;
    for (const auto& slot : actuators_) ids.push_back("'" + slot->use->id + "'");
    throw base::Error(
        "it gives a command of the kind '" + std::string(act.kind().name) + "' to " +
        (act.actuator().empty() ? "an actuator" : "the actuator '" + act.actuator() + "'") +
        ", and the robot has none " + (act.actuator().empty() ? "that takes it" : "of that name") +
        "; it has " + (ids.empty() ? "no actuators" : base::joined(ids)));
  }
  if (!takes_it(*found)) {
    throw base::Error("it gives a command of the kind '" + std::string(act.kind().name) +
                      "' to the actuator '" + (*found)->use->id + "', which takes commands of '" +
                      (*found)->object().kind().name +
                      "'; if the names are equal, build both plugins with the same header");
  }
  (*found)->object().check_command(act.command());
  return static_cast<std::size_t>(found - actuators_.begin());
}

void Robot::act(const Instant& now) {
  if (empty_) {
    for (const auto& slot : actuators_) slot->effect = {};
    return;
  }
  for (const auto& slot : actuators_) slot->is_new = false;
  for (const Controller::ChosenAct& chosen : controller_->acts()) {
    ActuatorSlot& slot = *actuators_[chosen.actuator];
    guard_.run(*slot.use, [&] { slot.object().take(chosen.act.command()); });
    slot.by = chosen.act.by();
    slot.is_new = true;
  }
  for (const auto& slot : actuators_) {
    if (slot->disturbed) {
      guard_.run(*slot->use,
                 [&] { slot->disturbed->update(slot->object(), now.time_s, now.period_s); });
    }
    slot->effect = {};
    const ActuatorContext context{
        now.time_s, now.period_s,  slot->is_new,    frame_of(*slot->place), &slot->place->mounting,
        state_,     &slot->random, &slot->effects()};
    guard_.step(*slot, [&] { slot->object().carry_out(context); });
  }
}

void Robot::ActuatorSlot::shine(const Colour& colour, double intensity) {
  if (!std::isfinite(intensity) || !(intensity > 0.0)) {
    throw base::Error("it shines with the intensity " + base::number_text(intensity) +
                      "; expected a number above 0");
  }
  effect.shine = colour;
  effect.intensity = intensity;
}

void Robot::ActuatorSlot::draw_power(double units_per_s) {
  if (!std::isfinite(units_per_s) || units_per_s < 0.0) {
    throw base::Error("it draws a power of " + base::number_text(units_per_s) +
                      " units per second; expected a number at least 0");
  }
  effect.power += units_per_s;
}

void Robot::list_lights(std::vector<LampView>& lights) const {
  constexpr double kAbove = 0.005;  // m: its own chassis does not hide it
  for (const auto& slot : actuators_) {
    if (!slot->shown.shine) continue;
    Vector3 place = frame_of(*slot->place).origin;
    place.z += kAbove;
    lights.push_back({description_->id, place, slot->shown.intensity, *slot->shown.shine});
  }
}

}  // namespace elsie::simulation
