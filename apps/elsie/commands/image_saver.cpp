#include "image_saver.h"

#include <cstdio>
#include <stdexcept>
#include <string>

#include <unistd.h>

#include "elsie/picture/image_file.h"
#include "elsie/recording/sensor_pictures.h"
#include "elsie/simulation/simulation.h"

#include "command.h"

namespace elsie::program {

namespace fs = std::filesystem;
using simulation::SensorView;
using simulation::Simulation;

void require_image_folder(const fs::path& folder, const char* option) {
  const std::string what =
      std::string(option) + ": cannot save images in '" + folder.string() + "': ";
  std::error_code error;
  if (folder.empty()) {
    throw BadInput(what + "the name of a folder is missing");
  }
  if (fs::exists(folder, error)) {
    if (!fs::is_directory(folder, error)) {
      throw BadInput(what + "it is a file, not a folder");
    }
    if (!fs::is_empty(folder, error) || error) {
      throw BadInput(what + (error ? error.message()
                                   : "it is not empty, and pictures of two runs would mix; empty "
                                     "it, or name a new folder"));
    }
  }
  const fs::path parent = fs::absolute(folder, error).lexically_normal().parent_path();
  if (!fs::exists(folder, error) && !fs::is_directory(parent, error)) {
    throw BadInput(what + "there is no folder '" + parent.string() + "' to make it in");
  }
  if (access(fs::exists(folder, error) ? folder.c_str() : parent.c_str(), W_OK) != 0) {
    throw BadInput(what + "permission denied");
  }
}

void require_cameras(const Simulation& simulation, const char* option) {
  for (std::size_t robot = 0; robot < simulation.robots(); ++robot) {
    for (std::size_t sensor = 0; sensor < simulation.sensors(robot); ++sensor) {
      if (simulation.sensor(robot, sensor).camera) {
        return;
      }
    }
  }
  throw BadInput(std::string(option) + ": no robot of this world has a sensor with a camera");
}

void ImageSaver::started(const Simulation& simulation) {
  require_cameras(simulation, "--save-images");
  std::error_code error;
  fs::create_directory(folder_, error);
  if (error) {
    throw std::runtime_error("cannot make the folder '" + folder_.string() +
                             "' for images: " + error.message());
  }
  times_ = 0;
  remember_who_sees(simulation);
}

void ImageSaver::stepped(const Simulation& simulation) {
  const std::uint64_t step = simulation.steps() - 1;
  const auto& physics = simulation.world().physics;
  if (simulation.decided()) {
    // Multiplied, not summed; slightly early, so that rounding does not delay a picture by a step.
    const double due_s = static_cast<double>(times_) * every_s_;
    if (simulation.step_began_s() >= due_s - 0.001 * physics.step) {
      save(simulation, step);
      ++times_;
    }
    remember_who_sees(simulation);
  }
}

void ImageSaver::replaced(const Simulation& simulation) { remember_who_sees(simulation); }

void ImageSaver::remember_who_sees(const Simulation& simulation) {
  blind_.clear();
  for (std::size_t robot = 0; robot < simulation.robots(); ++robot) {
    blind_.push_back(simulation.robot(robot).empty);
  }
}

void ImageSaver::save(const Simulation& simulation, std::uint64_t step) const {
  char number[24];
  std::snprintf(number, sizeof(number), "%07llu", static_cast<unsigned long long>(step));
  for (std::size_t robot = 0; robot < simulation.robots(); ++robot) {
    for (std::size_t i = 0; i < simulation.sensors(robot) && !blind_[robot]; ++i) {
      const SensorView sensor = simulation.sensor(robot, i);
      if (!sensor.picture) {
        continue;
      }
      // Ids contain no '+'.
      const std::string base = std::string(number) + "_" + simulation.robot(robot).description->id +
                               "+" + std::string(sensor.id);
      recording::visit_pictures(
          simulation, robot, i, [&](std::string_view name, const elsie::Image& image) {
            picture::write_png(image, folder_ / (base + "_" + std::string(name) + ".png"));
          });
    }
  }
}

}  // namespace elsie::program
