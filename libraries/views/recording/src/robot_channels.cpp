#include "robot_channels.h"

#include <utility>

#include "elsie/api/reading.h"

#include "format.h"
#include "readings.h"
#include "schemas.h"

namespace elsie::recording {

using simulation::SensorView;
using simulation::Simulation;

VisitAllPublished published_of(const Simulation& simulation, std::size_t robot) {
  return [&simulation, robot](const simulation::VisitPublished& visit) {
    simulation.visit_published(robot, visit);
  };
}

VisitAllPublished published_of_measures(const Simulation& simulation) {
  return
      [&simulation](const simulation::VisitPublished& visit) { simulation.visit_published(visit); };
}

std::uint32_t Channels::schema(const std::string& name) {
  return schema(name, schema_of(name).dump());
}

std::uint32_t Channels::schema(const std::string& name, const std::string& text) {
  const auto [known, is_new] = schemas_.try_emplace(name + "\n" + text, std::uint32_t{0});
  if (is_new) {
    known->second = out_.add_schema(name, text);
  }
  return known->second;
}

std::uint32_t Channels::add(const std::string& topic, std::uint32_t schema,
                            const std::map<std::string, std::string>& metadata) {
  return out_.add_channel(topic, schema, metadata);
}

std::uint32_t Channels::add(const world::Robot& robot, const std::string& kind,
                            std::uint32_t schema) {
  return add(robot_topic(robot.id, kind), schema, {{"robot", robot.id}, {"team", robot.team}});
}

std::vector<std::uint32_t> ids_of(const RobotChannels& channels) {
  std::vector<std::uint32_t> ids{channels.pose, channels.state, channels.readings, channels.command,
                                 channels.trace};
  for (const auto& each : {channels.belief, channels.published, channels.sketches, channels.heard,
                           channels.graphs, channels.lit}) {
    if (each) ids.push_back(*each);
  }
  for (const CameraChannels& camera : channels.cameras) {
    for (const auto& [name, id] : camera.of) ids.push_back(id);
  }
  return ids;
}

std::string kind_of(const Simulation& simulation, std::size_t r) {
  std::string kind = simulation.robot(r).description->id;
  for (std::size_t s = 0; s < simulation.sensors(r); ++s) {
    const SensorView sensor = simulation.sensor(r, s);
    kind += "|" + std::string(sensor.id) + " " + std::string(sensor.plugin) +
            (sensor.camera ? " looks" : "");
    simulation.visit_reading(r, s, [&](const ReadingField& field) {
      kind += " " + field.path() + (field.is_array ? std::to_string(field.size) : "");
    });
  }
  for (std::size_t a = 0; a < simulation.actuators(r); ++a) {
    const simulation::ActuatorView actuator = simulation.actuator(r, a);
    kind += "|" + std::string(actuator.id) + " " + std::string(actuator.plugin);
  }
  for (const simulation::TracedMember& member : simulation.robot(r).trace) {
    kind += "|" + member.path + " " + std::string(member.plugin) + " " +
            std::string(member.coordinator);
  }
  kind += simulation.robot(r).description->localisation ? "|believes" : "";
  simulation.visit_published(r, [&](const simulation::PublishedValue& each) {
    kind += "|" + std::string(each.path) + "." + each.number.name;
  });
  return kind;
}

RobotChannels robot_channels(Channels& channels, const Simulation& simulation, std::size_t r,
                             bool images) {
  const world::Robot& robot = *simulation.robot(r).description;
  const auto own = [&](const std::string& kind, std::uint32_t schema) {
    return channels.add(robot, kind, schema);
  };
  const auto pose = channels.schema("foxglove.PoseInFrame");
  RobotChannels made{r,
                     own("pose", pose),
                     own("state", channels.schema("elsie.State")),
                     own(kReadingsKind, channels.schema("elsie.Readings." + robot.id,
                                                        readings_schema(simulation, r))),
                     own("command", channels.schema("elsie.Command")),
                     channels.add(robot_topic(robot.id, kTraceKind), channels.schema("elsie.Trace"),
                                  trace_metadata(simulation.robot(r))),
                     std::nullopt,
                     std::nullopt,
                     std::nullopt,
                     std::nullopt,
                     std::nullopt,
                     std::nullopt,
                     {},
                     TraceTexts(simulation.robot(r)),
                     kind_of(simulation, r)};
  if (robot.localisation) made.belief = own(kBeliefKind, pose);
  const std::string title = "elsie.Published." + robot.id;
  const auto published = published_of(simulation, r);
  if (const auto text = published_schema(title, published); !text.empty()) {
    made.published = channels.add(
        robot_topic(robot.id, kPublishedKind), channels.schema(title, text),
        {{"robot", robot.id}, {"team", robot.team}, {kPublishedNumbers, numbers_text(published)}});
  }
  for (std::size_t s = 0; images && s < simulation.sensors(r); ++s) {
    const SensorView sensor = simulation.sensor(r, s);
    const auto image = channels.schema("foxglove.CompressedImage");
    const std::string topic = "cameras/" + std::string(sensor.id);
    CameraChannels camera{s, {}};
    if (sensor.camera) camera.of.emplace("raw", own(topic, image));
    simulation.visit_reading(r, s, [&](const ReadingField& field) {
      const std::string name(field.name);
      if (!field.is_number() && !camera.of.contains(name)) {
        camera.of.emplace(name, own(name == "raw" ? topic : topic + "/" + name, image));
      }
    });
    if (!camera.of.empty()) made.cameras.push_back(std::move(camera));
  }
  return made;
}

}  // namespace elsie::recording
