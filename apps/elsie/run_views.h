// The results of a run for people to look at: recordings and pictures.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "elsie/simulation/edit.h"

#include "path_options.h"
#include "record_options.h"

namespace elsie::simulation {
class Observer;
class Simulation;
}  // namespace elsie::simulation

namespace elsie::program {

/// The views that the command line asks for.
struct ViewOptions {
  RecordOptions record;
  std::optional<std::string> picture;
  int picture_width = 1000;
  PathOptions paths;
  std::optional<std::string> graph;  // [ROBOT=]FILE
  std::optional<std::string> image_folder;
  double image_period_s = 0.0;      // simulated time between two saved images; 0: a control period
  std::optional<std::string> live;  // [ADDRESS:]PORT
  std::vector<std::string> live_origins;  // whose pages may connect
  double live_speed = 1.0;                // simulated seconds per second
  bool quiet = false;

  bool any() const { return !record.files.empty() || picture || graph || image_folder || live; }
};

/// How to make the run once more, for those who want to see its past.
struct RunAgain {
  std::function<std::unique_ptr<simulation::Simulation>()> make;  // empty: it cannot be
  std::vector<simulation::TimedEdit> edits;                       // those of the run
};

/// The views of one run. elsie-commands.so makes them (command_module.h), because they need
/// libraries that most runs do not use.
class RunViews {
 public:
  virtual ~RunViews() = default;
  /// Opens the files, before the run; `inputs`: what it has read. Throws BadInput for views that
  /// this world cannot have, and for files that are inputs.
  virtual void open(const simulation::Simulation& simulation,
                    const std::vector<std::filesystem::path>& inputs, RunAgain again) = 0;
  /// The observers of the run; none before open().
  virtual std::span<simulation::Observer* const> observers() const = 0;
  /// Draws the picture and the graph that are asked for, with a line below their titles.
  virtual void draw(const simulation::Simulation& simulation, const std::string& line) const = 0;
  /// Shows the end of a live run until the user ends the program.
  virtual void linger(const simulation::Simulation& simulation) = 0;
};

}  // namespace elsie::program
