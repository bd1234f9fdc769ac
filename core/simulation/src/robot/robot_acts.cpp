// What a robot does besides moving: its actuators.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "elsie/base/error.h"
#include "elsie/base/number_text.h"
#include "elsie/base/words.h"

#include "robot/robot.h"
#include "robot/robot_surroundings.h"
#include "step/fields.h"

namespace elsie::simulation {

namespace {

/// The command that an act gives by its numbers.
Act made(const Act& act, const Disturbable& actuator) {
  const std::shared_ptr<void> command = actuator.new_value();
  for (const auto& given : act.numbers()) {
    bool is_set = false;
    std::vector<std::string> names;
    actuator.visit_fields(command.get(), [&](const ReadingField& field) {
      for (std::size_t i = 0; field.is_stored && field.is_number() && i < field.count; ++i) {
        names.push_back("'" + field.column(i) + "'");
        if (field.column(i) != given.first) continue;
        field.set_number(i, given.second);
        is_set = true;
      }
    });
    if (!is_set) {
      throw base::Error("it gives a command with the number '" + given.first +
                        "' to an actuator that takes commands of '" + actuator.kind().name +
                        "', which have " + (names.empty() ? "no numbers" : base::joined(names)));
    }
  }
  return {act.actuator(), actuator.kind(), command};
}

}  // namespace

std::size_t Robot::actuator_for(Act& act) const {
  const auto names_it = [&](const auto& slot) { return act.actuator() == slot->use->id; };
  const auto takes_it = [&](const auto& slot) {
    const ReadingKind kind = slot->object().kind();
    return act.command() ? kind == act.kind()
                         : *act.kind().name == '\0' || kind.has_name_of(act.kind());
  };
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
  if (!act.command()) act = made(act, (*found)->object());
  (*found)->object().check_command(act.command());
  if (act.kind() == ReadingKind::of<SayCommand>()) {
    const auto& said = *static_cast<const SayCommand*>(act.command());
    if (!said.to.empty()) common_->require_robot(said.to);
    if (said.to == description_->id) {
      throw base::Error("it sends a message to its own robot '" + said.to +
                        "'; expected another one");
    }
  }
  return static_cast<std::size_t>(found - actuators_.begin());
}

void Robot::act(const Instant& now, const Fields& fields) {
  for (const auto& slot : actuators_) slot->deposits.clear();
  if (empty_) {
    for (const auto& slot : actuators_) {
      slot->effect = {};
      slot->by.clear();
      slot->forget();
    }
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
      slot->is_new = guard_.run(*slot->use, [&] {
        return slot->disturbed->update(slot->object(), now.time_s, now.period_s, slot->is_new);
      });
    }
    slot->effect = {};
    slot->now_s = now.time_s;
    const Frame frame = frame_of(*slot->place);
    slot->at = {frame.origin.x, frame.origin.y};
    slot->fields = &fields;
    const ActuatorContext context{now.time_s,    now.period_s,           slot->is_new,
                                  frame,         &slot->place->mounting, state_,
                                  &slot->random, &slot->effects()};
    const std::size_t before = slot->under_way.size();
    guard_.step(*slot, [&] { slot->object().carry_out(context); });
    for (std::size_t i = before; i < slot->under_way.size(); ++i) {
      slot->under_way[i].message = slot->lasting(slot->under_way[i].message);
    }
    tally_.talk.sent += static_cast<int>(slot->under_way.size() - before);
  }
}

void Robot::ActuatorSlot::forget() {
  object().forget();
  if (disturbed) disturbed->forget();
}

void Robot::ActuatorSlot::shine(const Colour& colour, double intensity) {
  if (!std::isfinite(intensity) || !(intensity > 0.0)) {
    throw base::Error("it shines with the intensity " + base::number_text(intensity) +
                      "; expected a number above 0");
  }
  effect.shine = colour;
  effect.intensity = intensity;
}

void Robot::ActuatorSlot::deposit(std::string_view field, double amount) {
  constexpr double kMost = 1e12;
  if (!(std::abs(amount) <= kMost)) {
    throw base::Error("it deposits an amount of " + base::number_text(amount) +
                      "; expected a number from -1e12 to 1e12");
  }
  deposits.push_back({fields->index(field), at, amount});
}

void Robot::deposit_into(Fields& fields) const {
  for (const auto& slot : actuators_) {
    for (const ActuatorSlot::Deposit& each : slot->deposits) {
      fields[each.field].deposit(each.place, each.amount);
    }
  }
}

void Robot::ActuatorSlot::draw_power(double units_per_s) {
  if (!std::isfinite(units_per_s) || units_per_s < 0.0) {
    throw base::Error("it draws a power of " + base::number_text(units_per_s) +
                      " units per second; expected a number at least 0");
  }
  effect.power += units_per_s;
}

void Robot::ActuatorSlot::hold(double reach_m) {
  if (!std::isfinite(reach_m) || reach_m < 0.0) {
    throw base::Error("it reaches " + base::number_text(reach_m) +
                      " m far for something to hold; expected a number at least 0");
  }
  if (place->mounting.segment != 0) {
    throw base::Error("it is on a segment, and only the robot itself can hold something");
  }
  effect.grasp = reach_m;
}

void Robot::ActuatorSlot::transmit(const std::shared_ptr<const AnyMessage>& message,
                                   const std::string& to, const Transmission& how) {
  if (!message) return;
  if (message->bytes() > how.bandwidth) {
    throw base::Error("the message '" + std::string(message->kind().name) + "' of '" + by +
                      "' has " + std::to_string(message->bytes()) + " bytes; its bandwidth is " +
                      std::to_string(how.bandwidth) + " in a control period");
  }
  under_way.push_back({message, to, how, now_s});
}

void Robot::show_effects(double next_s) {
  constexpr double kRounding = 1e-9;  // s
  for (const auto& slot : actuators_) {
    slot->shown = slot->effect;
    slot->sounding.clear();
    const auto is_due = [&](const ActuatorSlot::Sent& sent) {
      return sent.said_s + sent.how.delay_s <= next_s + kRounding;
    };
    std::copy_if(slot->under_way.begin(), slot->under_way.end(), std::back_inserter(slot->sounding),
                 is_due);
    std::erase_if(slot->under_way, is_due);
  }
}

double Robot::reach_of(const SensorPlace& device) const {
  const Vector3 place = frame_of(device).origin;
  return std::hypot(place.x - truth_.pose.x, place.y - truth_.pose.y);
}

double Robot::loudest_m() const {
  double loudest = 0.0;
  for (const auto& slot : actuators_) {
    if (slot->sounding.empty()) continue;
    const double reach = reach_of(*slot->place);
    for (const ActuatorSlot::Sent& sent : slot->sounding) {
      loudest = std::max(loudest, sent.how.range_m + reach);
    }
  }
  return loudest;
}

void Robot::listen(const RobotSurroundings& surroundings, double loudest_m, const Instant& now) {
  std::vector<Overheard> all;
  all.reserve(heard_.size());
  for (const auto& slot : actuators_) {
    if (empty_ || !(loudest_m > 0.0)) break;
    if (slot->declaration->hears_messages) hear(*slot, surroundings, loudest_m, now, all);
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Overheard& a, const Overheard& b) { return a.sender < b.sender; });
  heard_.clear();
  for (Overheard& each : all) {
    if (each.device->disturbed) disturb(*each.device, each.message);
    heard_.push_back(std::move(each.message));
  }
  perception_.heard = heard_;
  tally_.talk.heard += static_cast<int>(heard_.size());
}

/// Adds the noise of the device that hears a message to where it seems to come from.
void Robot::disturb(const ActuatorSlot& device, HeardMessage& heard) {
  if (std::isnan(heard.distance_m)) return;  // the device does not tell
  guard_.run(*device.use, [&] {
    DisturbedValue& disturbed = *device.disturbed;
    heard.distance_m = disturbed.disturbed("distance", heard.distance_m);
    heard.bearing_rad = wrap_angle(disturbed.disturbed("bearing", heard.bearing_rad));
    heard.elevation_rad = disturbed.disturbed("elevation", heard.elevation_rad);
  });
}

/// What one of its actuators hears.
void Robot::hear(const ActuatorSlot& device, const RobotSurroundings& surroundings,
                 double loudest_m, const Instant& now, std::vector<Overheard>& all) const {
  const Frame own = frame_of(*device.place);
  surroundings.for_each_near(loudest_m + reach_of(*device.place), [&](const Robot& other) {
    for (const auto& slot : other.actuators_) {
      if (slot->declaration != device.declaration) continue;
      for (const ActuatorSlot::Sent& sent : slot->sounding) {
        if (!sent.to.empty() && sent.to != description_->id) continue;
        const Vector3 there = other.frame_of(*slot->place).origin, way = there - own.origin;
        const double distance = std::sqrt(dot(way, way));
        if (distance > sent.how.range_m || is_lost(sent, other, device, now)) continue;
        if (sent.how.in_sight && !surroundings.sees(other, own.origin, there)) continue;
        const std::string& sender = other.description_->id;
        HeardMessage& heard = all.emplace_back(Overheard{sender, &device, {}}).message;
        heard.message = sent.message;
        heard.device = device.use->id;
        if (sent.how.tells_from) heard.from = sender;
        heard.age_s = now.time_s - sent.said_s;
        heard.sender_at = there;
        if (!sent.how.in_sight) continue;
        const double ahead = dot(way, own.forward), left = dot(way, own.left);
        heard.distance_m = distance;
        heard.bearing_rad = std::atan2(left, ahead);
        heard.elevation_rad = std::atan2(dot(way, own.up), std::hypot(ahead, left));
      }
    }
  });
}

/// One draw for each sender, receiver, device and control period.
bool Robot::is_lost(const ActuatorSlot::Sent& sent, const Robot& sender, const ActuatorSlot& device,
                    const Instant& now) const {
  if (!(sent.how.loss > 0.0)) return false;
  Random random(seed_, "message/" + sender.description_->id + "/" + description_->id + "/" +
                           device.use->id + "/" + std::to_string(now.step));
  return random.chance(sent.how.loss);
}

void Robot::add_messages(base::Fnv1a& hash) const {
  for (const auto& slot : actuators_) {
    for (const auto* sent : {&slot->under_way, &slot->sounding}) {
      for (const ActuatorSlot::Sent& each : *sent) {
        hash.add(description_->id);
        hash.add(each.to);
        hash.add(each.said_s);
        hash.add(std::string_view(each.message->kind().name));
        each.message->visit_fields([&](const ReadingField& field) {
          for (std::size_t i = 0; field.is_number() && i < field.count; ++i) {
            hash.add(field.number(i));
          }
        });
      }
    }
  }
}

void Robot::list_lights(std::vector<LampView>& lights) const {
  constexpr double kAbove = 0.025;  // m: above its own robot, which rays see 2 cm higher than it is
  for (const auto& slot : actuators_) {
    if (!slot->shown.shine) continue;
    Vector3 place = frame_of(*slot->place).origin;
    place.z += kAbove;
    lights.push_back({description_->id, place, slot->shown.intensity, *slot->shown.shine});
  }
}

}  // namespace elsie::simulation
