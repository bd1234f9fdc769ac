// Saves camera pictures of a run as files.
#pragma once

#include <filesystem>
#include <vector>

#include "elsie/simulation/observer.h"

namespace elsie::program {

/// Checks, before any work is done, that pictures can be saved in the folder: it is empty, or can
/// be created. Throws BadInput.
void require_image_folder(const std::filesystem::path& folder, const char* option);

/// Throws BadInput when no robot has a sensor with a camera.
void require_cameras(const simulation::Simulation& simulation, const char* option);

/// Saves pictures of all sensors with cameras as PNG files:
///
///   0000120_r1+eye_raw.png        the camera's picture before step 120 (counted from 0)
///   0000120_r1+eye_processed.png  the sensor's processed picture, if it has one
class ImageSaver final : public simulation::Observer {
 public:
  /// `every_s`: simulated time between pictures of a camera, at least a control period; 0: every
  /// control period.
  ImageSaver(std::filesystem::path folder, double every_s)
      : folder_(std::move(folder)), every_s_(every_s) {}

  /// Creates the folder. Throws BadInput when no robot has a camera, std::runtime_error when it
  /// cannot be created.
  void started(const simulation::Simulation& simulation) override;
  /// Throws std::runtime_error when a picture cannot be written.
  void stepped(const simulation::Simulation& simulation) override;
  void replaced(const simulation::Simulation& simulation) override;

 private:
  void remember_who_sees(const simulation::Simulation& simulation);
  void save(const simulation::Simulation& simulation, std::uint64_t step) const;

  std::filesystem::path folder_;
  double every_s_;
  std::uint64_t times_ = 0;  // number of times that pictures were saved
  std::vector<bool> blind_;  // robots whose battery was empty before the step
};

}  // namespace elsie::program
