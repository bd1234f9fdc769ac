#include "elsie/recording/beams.h"

#include "elsie/api/reading.h"

namespace elsie::recording {

std::vector<RangeBeam> range_beams(const simulation::Simulation& simulation, std::size_t robot) {
  std::vector<RangeBeam> beams;
  for (std::size_t i = 0; i < simulation.sensors(robot); ++i) {
    const simulation::SensorView sensor = simulation.sensor(robot, i);
    if (sensor.sensor->kind() != ReadingKind::of<RangeReading>()) {
      continue;
    }
    const auto& reading = *static_cast<const RangeReading*>(sensor.sensor->reading());
    const Frame frame = simulation.sensor_frame(robot, i);
    beams.push_back({frame.origin, frame.point({reading.distance_m, 0.0, 0.0}), reading.hit});
  }
  return beams;
}

std::vector<SensedVolume> sensed_volumes(const simulation::Simulation& simulation,
                                         std::size_t robot) {
  std::vector<SensedVolume> volumes;
  for (std::size_t i = 0; i < simulation.sensors(robot); ++i) {
    const simulation::SensorView sensor = simulation.sensor(robot, i);
    if (!sensor.volume) {
      continue;
    }
    SensedVolume& sensed = volumes.emplace_back();
    sensed.pyramid = *sensor.volume;
    sensed.pyramid.frame = simulation.sensor_frame(robot, i);
    if (sensor.sensor->kind() == ReadingKind::of<ProximityReading>()) {
      sensed.detected = static_cast<const ProximityReading*>(sensor.sensor->reading())->detected;
    }
  }
  return volumes;
}

}  // namespace elsie::recording
