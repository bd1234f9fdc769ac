#include "elsie/recording/sensor_pictures.h"

namespace elsie::recording {

void visit_pictures(const simulation::Simulation& simulation, std::size_t robot, std::size_t sensor,
                    const std::function<void(std::string_view name, const Image& image)>& visit) {
  bool has_raw = false;
  simulation.visit_reading(robot, sensor, [&](const ReadingField& field) {
    if (field.is_number()) return;
    has_raw |= field.name == "raw";
    if (!field.picture().empty()) visit(field.name, field.picture());
  });
  const Image* const taken = simulation.sensor(robot, sensor).picture;
  if (!has_raw && taken) visit("raw", *taken);
}

}  // namespace elsie::recording
