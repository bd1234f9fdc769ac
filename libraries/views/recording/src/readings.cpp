#include "readings.h"

#include <utility>

#include "messages.h"
#include "schemas.h"

namespace elsie::recording {

namespace {

using simulation::Simulation;

Json object_schema(Json properties) {
  return {
      {"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
}

}  // namespace

std::string readings_schema(const Simulation& simulation, std::size_t robot) {
  Json sensors = Json::object(), actuators = Json::object();
  for (std::size_t s = 0; s < simulation.sensors(robot); ++s) {
    Json properties = Json::object();
    simulation.visit_reading(robot, s,
                             [&](const ReadingField& field) { add_to_schema(field, properties); });
    sensors[std::string(simulation.sensor(robot, s).id)] = object_schema(std::move(properties));
  }
  for (std::size_t a = 0; a < simulation.actuators(robot); ++a) {
    Json properties{{"by", {{"type", "string"}}}};
    simulation.visit_command(robot, a,
                             [&](const ReadingField& field) { add_to_schema(field, properties); });
    actuators[std::string(simulation.actuator(robot, a).id)] = object_schema(std::move(properties));
  }
  Json schema = schema_of("elsie.Readings");
  schema["properties"]["sensors"]["properties"] = std::move(sensors);
  if (!actuators.empty()) {
    schema["properties"]["actuators"] = {{"type", "object"}, {"properties", std::move(actuators)}};
  }
  return schema.dump();
}

Json readings_message(const Simulation& simulation, std::size_t robot, std::uint64_t decided_ns) {
  Json sensors = Json::object();
  for (std::size_t s = 0; s < simulation.sensors(robot); ++s) {
    Json& sensor = sensors[std::string(simulation.sensor(robot, s).id)] = Json::object();
    simulation.visit_reading(robot, s,
                             [&](const ReadingField& field) { add_to_message(field, sensor); });
  }
  Json message{{"timestamp", time_json(decided_ns)}, {"sensors", std::move(sensors)}};
  for (std::size_t a = 0; a < simulation.actuators(robot); ++a) {
    const simulation::ActuatorView view = simulation.actuator(robot, a);
    Json& actuator = message["actuators"][std::string(view.id)] = {{"by", view.by}};
    simulation.visit_command(robot, a,
                             [&](const ReadingField& field) { add_to_message(field, actuator); });
  }
  return message;
}

Json heard_message(const Simulation& simulation, std::size_t robot, std::uint64_t decided_ns) {
  Json message{{"timestamp", time_json(decided_ns)}, {"heard", Json::array()}};
  for (const HeardMessage& heard : simulation.heard(robot)) {
    Json content = Json::object();
    heard.message->visit_fields([&](const ReadingField& field) { add_to_message(field, content); });
    message["heard"].push_back({{"by", heard.device},
                                {"from", heard.from},
                                {"kind", heard.message->kind().name},
                                {"age_s", heard.age_s},
                                {"message", std::move(content)}});
  }
  return message;
}

}  // namespace elsie::recording
