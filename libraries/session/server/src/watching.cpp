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
#include "elsie/picture/floor_field.h"
#include "elsie/recording/graph_json.h"
#include "elsie/recording/sensor_pictures.h"
#include "elsie/traces/trace_rows.h"

#include "scene.h"

namespace elsie::server {
namespace {

using simulation::RobotView;
using simulation::SensorView;
using simulation::Simulation;
using simulation::TracedMember;

constexpr const char* kWhat[] = {"decisions", "sensors", "cameras", "fuzzy", "graphs",
                                 "measures",  "fields",  "lights",  "stuck"};

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

/// By the paths of the behaviours that were asked.
Json reasons_json(const RobotView& robot) {
  Json reasons = Json::object();
  for (const TracedMember& member : robot.trace) {
    const TraceRow& row = member.member->trace;
    if (row.asked) reasons[member.path] = files::one_line(row.reason);
  }
  return reasons;
}

/// "distance_m", or "blobs.2.distance" in a list.
std::string name_of(const ReadingField& field) {
  std::string name(field.group);
  if (!name.empty()) name += '.' + std::to_string(field.item) + '.';
  return name += field.name;
}

void add_field(const ReadingField& field, Json& fields) {
  if (!field.is_number()) return;
  Json values = Json::array();
  for (std::size_t k = 0; k < field.count; ++k) values.push_back(number(field.number(k)));
  fields.push_back({{"name", name_of(field)}, {"unit", field.unit}});
  if (field.is_array) fields.back()["size"] = field.size;
  fields.back()["values"] = std::move(values);
}

/// The readings of sensors, then the commands of actuators.
Json sensors_json(const Simulation& simulation, std::size_t robot) {
  Json all = Json::array();
  for (std::size_t i = 0; i < simulation.sensors(robot); ++i) {
    const SensorView sensor = simulation.sensor(robot, i);
    Json fields = Json::array();
    simulation.visit_reading(robot, i,
                             [&](const ReadingField& field) { add_field(field, fields); });
    all.push_back({{"id", sensor.id}, {"plugin", sensor.plugin}, {"fields", std::move(fields)}});
  }
  for (std::size_t i = 0; i < simulation.actuators(robot); ++i) {
    const simulation::ActuatorView actuator = simulation.actuator(robot, i);
    Json fields = Json::array();
    simulation.visit_command(robot, i,
                             [&](const ReadingField& field) { add_field(field, fields); });
    all.push_back({{"id", actuator.id},
                   {"plugin", actuator.plugin},
                   {"by", actuator.by},
                   {"fields", std::move(fields)}});
  }
  return all;
}

/// What its actuators heard before the last decision.
Json heard_json(const Simulation& simulation, std::size_t robot) {
  Json all = Json::array();
  for (const HeardMessage& heard : simulation.heard(robot)) {
    Json fields = Json::array();
    heard.message->visit_fields([&](const ReadingField& field) { add_field(field, fields); });
    all.push_back({{"by", heard.device},
                   {"from", heard.from},
                   {"kind", files::one_line(heard.message->kind().name)},
                   {"age_s", number(heard.age_s)},
                   {"fields", std::move(fields)}});
  }
  return all;
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

/// The sensors that have taken a picture, or whose readings have one.
Json cameras_json(const Simulation& simulation, std::size_t robot) {
  Json cameras = Json::array();
  for (std::size_t i = 0; i < simulation.sensors(robot); ++i) {
    Json pictures = Json::array();
    recording::visit_pictures(simulation, robot, i, [&](std::string_view name, const Image& image) {
      pictures.push_back({{"name", name},
                          {"width", image.width},
                          {"height", image.height},
                          {"pixels", rgb_text(image)}});
    });
    if (!pictures.empty()) {
      cameras.push_back(
          {{"id", simulation.sensor(robot, i).id}, {"pictures", std::move(pictures)}});
    }
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

/// The graphs of its coordinators, and what is lit in them.
Json graphs_json(const Simulation& simulation, std::size_t robot) {
  Json graphs = Json::array();
  for (const simulation::LitGraph& lit : simulation.graphs(robot)) {
    graphs.push_back(recording::graph_json(lit.path, lit.plugin, lit.graph));
    recording::add_lights(lit.lights, graphs.back());
  }
  return graphs;
}

/// The fields of the floor, as opaque as they are shown.
Json fields_json(const Simulation& simulation) {
  constexpr std::size_t kMost = 128;
  Json fields = Json::array();
  for (std::size_t i = 0; i < simulation.fields(); ++i) {
    const picture::FloorField field = picture::floor_field(simulation.field(i), kMost);
    const Colour& colour = field.colour;
    fields.push_back({{"id", field.id},
                      {"colour", {colour.red, colour.green, colour.blue}},
                      {"columns", field.columns},
                      {"rows", field.rows},
                      {"opacity", files::packed(field.opacities())}});
  }
  return fields;
}

}  // namespace

void Watching::choose(const Json& order) {
  std::set<std::string, std::less<>> what;
  for (const Json& each : order.at("what")) {
    const auto word = each.get<std::string>();
    if (std::find(std::begin(kWhat), std::end(kWhat), word) == std::end(kWhat)) {
      throw base::BadInput("'" + word +
                           "' cannot be watched; expected decisions, sensors, cameras, fuzzy, "
                           "graphs, measures, fields, lights or stuck");
    }
    what.insert(word);
  }
  const auto robots = order.value("robots", std::vector<std::string>());
  what_ = std::move(what);
  robots_ = {robots.begin(), robots.end()};
}

bool Watching::shows(const Simulation& simulation, std::size_t index) const {
  return robots_.empty() || robots_.contains(simulation.robot(index).description->id);
}

Json Watching::look(const Simulation& simulation) const {
  if (!watches("cameras") && !watches("sensors") && !watches("decisions")) return {};
  Json robots = Json::array();
  for (std::size_t i = 0; i < simulation.robots(); ++i) {
    if (!shows(simulation, i)) continue;
    const RobotView view = simulation.robot(i);
    Json& robot = robots.emplace_back(Json{{"id", view.description->id}});
    if (watches("cameras")) robot["cameras"] = cameras_json(simulation, i);
    if (watches("sensors")) robot["heard"] = heard_json(simulation, i);
    if (watches("decisions")) robot["reasons"] = reasons_json(view);
  }
  return {{"time_s", simulation.time_s()}, {"robots", std::move(robots)}};
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
    robot["heard"] = heard_json(simulation, index);
  }
  if (watches("cameras")) {
    robot["cameras"] = cameras_json(simulation, index);
  }
  if (watches("fuzzy")) {
    robot["fuzzy"] = fuzzy_json(simulation, index);
  }
  if (watches("graphs")) {
    robot["graphs"] = graphs_json(simulation, index);
  }
  return robot;
}

Json Watching::state(const Simulation& simulation, std::uint64_t epoch) const {
  Json robots = Json::array();
  for (std::size_t i = 0; i < simulation.robots(); ++i) {
    if (shows(simulation, i)) robots.push_back(robot(simulation, i));
  }
  Json state = {{"event", "state"},
                {"epoch", epoch},
                {"time_s", simulation.time_s()},
                {"robots", std::move(robots)}};
  if (watches("fields")) state["fields"] = fields_json(simulation);
  if (watches("lights")) state["lights"] = lights_json(simulation);
  return state;
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
