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

}  // namespace elsie::recording
