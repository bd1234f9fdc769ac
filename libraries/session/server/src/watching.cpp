#include "watching.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <utility>

#include "elsie/api/reading.h"
#include "elsie/base/error.h"
#include "elsie/files/base64.h"
#include "elsie/files/clean_text.h"
#include "elsie/recording/sensor_pictures.h"
#include "elsie/traces/trace_rows.h"

namespace elsie::server {
namespace {

using simulation::RobotView;
using simulation::SensorView;
using simulation::Simulation;
using simulation::TracedMember;

constexpr const char* kWhat[] = {"decisions", "sensors", "cameras", "fuzzy", "measures"};

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json motion_json(const Motion& motion) {
  return {number(motion.forward), number(motion.lateral), number(motion.turn)};
}

Json members_json(const RobotView& robot) {
  Json members = Json::array();
  for (const TracedMember& member : robot.trace) {
    const TraceRow row = traces::kept(member.member->trace);
    const TracedMember* inhibitor = traces::inhibitor_of(member, robot.trace);
    members.push_back({{"path", member.path},
                       {"plugin", member.plugin},
                       {"coordinator", member.coordinator},
                       {"depth", member.depth},
                       {"parent", member.parent},
                       {"priority", member.member->priority()},
                       {"activation", row.activation},
                       {"strength", row.strength},
                       {"weight", number(row.weight)},
                       {"share", number(row.share)},
                       {"asked", row.asked},
                       {"command", motion_json(row.command)},
                       {"inhibited_by", inhibitor ? inhibitor - robot.trace.data() : -1},
                       {"reason", files::one_line(row.reason)}});
  }
  return members;
}

Json sensors_json(const Simulation& simulation, std::size_t robot) {
  Json sensors = Json::array();
  for (std::size_t i = 0; i < simulation.sensors(robot); ++i) {
    const SensorView sensor = simulation.sensor(robot, i);
    Json names = Json::array(), units = Json::array(), numbers = Json::array();
    simulation.visit_reading(robot, i, [&](const ReadingField& field) {
      for (std::size_t k = 0; field.is_number() && k < field.size; ++k) {
        names.push_back(field.column(k));
        units.push_back(field.unit);
        numbers.push_back(k < field.count ? number(field.number(k)) : Json());
      }
    });
    sensors.push_back({{"id", sensor.id},
                       {"plugin", sensor.plugin},
                       {"names", std::move(names)},
                       {"units", std::move(units)},
                       {"values", std::move(numbers)}});
  }
  return sensors;
}

/// The picture with three bytes per pixel, whatever its own number of channels.
std::string rgb_text(const Image& image) {
  const std::string_view bytes(reinterpret_cast<const char*>(image.bytes.data()),
                               image.bytes.size());
  if (image.channels == 3) {
    return files::base64(bytes);
  }
  std::string pixels;
  pixels.reserve(3 * bytes.size());
  for (std::size_t i = 0; i < bytes.size(); i += static_cast<std::size_t>(image.channels)) {
    pixels.append(3, bytes[i]);
  }
  return files::base64(pixels);
}

Json cameras_json(const Simulation& simulation, std::size_t robot) {
  Json cameras = Json::array();
  for (std::size_t i = 0; i < simulation.sensors(robot); ++i) {
    const SensorView sensor = simulation.sensor(robot, i);
    if (!sensor.camera) {
      continue;
    }
    Json camera = {
        {"id", sensor.id}, {"width", sensor.camera->width}, {"height", sensor.camera->height}};
    recording::visit_pictures(simulation, robot, i, [&](std::string_view name, const Image& image) {
      camera[std::string(name)] = rgb_text(image);
    });
    cameras.push_back(std::move(camera));
  }
  return cameras;
}

Json fuzzy_json(const Simulation& simulation, std::size_t robot) {
  const auto values = [](const std::vector<Inference::Value>& all) {
    Json json = Json::object();
    for (const Inference::Value& each : all) {
      json[each.name] = number(each.value);
    }
    return json;
  };
  Json models = Json::array();
  for (const simulation::MadeInference& made : simulation.inferences(robot)) {
    const Inference& inference = made.inference;
    Json model = {{"path", made.path},
                  {"file", std::filesystem::absolute(inference.model).string()}};
    if (!inference.block.empty()) {
      model["block"] = inference.block;
    }
    model["inputs"] = values(inference.inputs);
    model["outputs"] = values(inference.outputs);
    models.push_back(std::move(model));
  }
  return models;
}

}  // namespace

void Watching::choose(const Json& order) {
  std::set<std::string, std::less<>> what;
  for (const Json& each : order.at("what")) {
    const auto word = each.get<std::string>();
    if (std::find(std::begin(kWhat), std::end(kWhat), word) == std::end(kWhat)) {
      throw base::BadInput("'" + word +
                           "' cannot be watched; expected decisions, sensors, cameras, fuzzy or "
                           "measures");
    }
    what.insert(word);
  }
  const auto robots = order.value("robots", std::vector<std::string>());
  what_ = std::move(what);
  robots_ = {robots.begin(), robots.end()};
}

Json Watching::robot(const Simulation& simulation, std::size_t index) const {
  const RobotView view = simulation.robot(index);
  const world::Robot& description = *view.description;
  const OwnState& state = *view.state;
  Json robot = {{"id", description.id},
                {"team", description.team},
                {"energy", state.capacity > 0.0 ? number(state.energy) : Json()},
                {"distance", number(view.distance_m)},
                {"speed", number(state.moving.forward)},
                {"collisions", view.collisions},
                {"asked", motion_json(view.asked)},
                {"possible", motion_json(view.command)}};
  if (watches("decisions")) {
    robot["coordinator"] = description.coordinator ? description.coordinator->plugin : "";
    robot["members"] = members_json(view);
  }
  if (watches("sensors")) {
    robot["sensors"] = sensors_json(simulation, index);
  }
  if (watches("cameras")) {
    robot["cameras"] = cameras_json(simulation, index);
  }
  if (watches("fuzzy")) {
    robot["fuzzy"] = fuzzy_json(simulation, index);
  }
  return robot;
}

Json Watching::state(const Simulation& simulation, std::uint64_t epoch) const {
  Json robots = Json::array();
  for (std::size_t i = 0; i < simulation.robots(); ++i) {
    if (robots_.empty() || robots_.contains(simulation.robot(i).description->id)) {
      robots.push_back(robot(simulation, i));
    }
  }
  return {{"event", "state"},
          {"epoch", epoch},
          {"time_s", simulation.time_s()},
          {"robots", std::move(robots)}};
}

Json measures_json(std::span<const simulation::MeasuredValue> measures) {
  Json json = Json::object();
  for (const simulation::MeasuredValue& measure : measures) {
    json[measure.name] = measure.value ? number(*measure.value) : Json();
  }
  return json;
}

std::string text_of(const simulation::Note& note) {
  return (note.robot.empty() ? "" : note.robot + ", ") + note.plugin + ": " + note.text;
}

}  // namespace elsie::server
