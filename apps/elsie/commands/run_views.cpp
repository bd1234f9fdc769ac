#include "run_views.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <spdlog/spdlog.h>

#include "elsie/base/number_text.h"
#include "elsie/files/outputs.h"
#include "elsie/recording/formats.h"
#include "elsie/recording/run_picture.h"
#include "elsie/traces/tracks.h"

#include "command.h"
#include "graph_file.h"
#include "image_saver.h"
#include "live_view.h"
#include "make_views.h"
#include "output_files.h"

namespace elsie::program {

namespace {

/// A device has no suffix; it gets the first format.
const recording::Format& format_of(const std::string& file) {
  const recording::Format* format = recording::format_of(file);
  return format ? *format : recording::formats().front();
}

void check(const RecordOptions& record) {
  for (const std::string& file : record.files) {
    recording::require_recording(file, "--record");
  }
  const auto takes_images = [](const std::string& file) { return format_of(file).images; };
  if (record.images && std::none_of(record.files.begin(), record.files.end(), takes_images)) {
    throw BadInput("--record-images: " + std::string(format_of(record.files.front()).description) +
                   " has no place for pictures; expected --record FILE" +
                   recording::suffixes(" or FILE", true));
  }
}

class Views final : public RunViews {
 public:
  explicit Views(ViewOptions options) : options_(std::move(options)) {
    check(options_.record);
    if (options_.graph) graph_.emplace(*options_.graph);
    files::require_apart(outputs(), {});
    if (options_.picture) {
      require_picture(*options_.picture, "--picture");
      // A plugin may change folders.
      options_.picture = std::filesystem::absolute(*options_.picture);
    }
    if (options_.image_folder) {
      require_image_folder(*options_.image_folder, "--save-images");
    }
    if (options_.live) live_.emplace(options_);
  }

  void open(const simulation::Simulation& simulation,
            const std::vector<std::filesystem::path>& inputs, RunAgain again) override {
    files::require_apart(outputs(), inputs);
    if (options_.record.images) {
      require_cameras(simulation, "--record-images");
    }
    if (graph_) picture::require_drawable(graphs_of(simulation, find_graph(simulation)).first);
    options_.paths.check(simulation.world());
    const RecordOptions& record = options_.record;
    require_robots(simulation.world(), record.robots, "--record-robots");
    warn_of_rate(simulation.world().physics.step);
    for (const std::string& file : record.files) {
      add(format_of(file).recorder(
          file, {record.rate_hz, record.images, record.times, record.robots, "elsie " ELSIE_VERSION,
                 [](const std::string& text) { spdlog::warn(text); }}));
      if (record.robots.empty() && format_of(file).most_robots < simulation.robots()) {
        spdlog::warn("recording '" + file + "': of " + std::to_string(simulation.robots()) +
                     " robots, only the poses are recorded beyond the first " +
                     std::to_string(format_of(file).most_robots) +
                     "; --record-robots chooses those with everything else");
      }
    }
    if (options_.image_folder) {
      add(std::make_unique<ImageSaver>(*options_.image_folder, options_.image_period_s));
    }
    if (options_.picture) {
      auto tracks = std::make_unique<traces::TrackRecorder>();
      tracks_ = tracks.get();
      add(std::move(tracks));
    }
    if (live_) {
      // Last: it holds the run, and the others are done by then.
      observers_.push_back(&live_->open(simulation, std::move(again)));
    }
  }

  std::span<simulation::Observer* const> observers() const override { return observers_; }

  void draw(const simulation::Simulation& simulation, const std::string& line) const override {
    if (options_.picture) {
      picture::TopView view = recording::view_of(
          simulation, tracks_, [](const std::string& sentence) { spdlog::warn(sentence); });
      view.subtitles = {line};
      view.paths = options_.paths.choice();
      picture::save_top_view(view, *options_.picture, {options_.picture_width, 0});
    }
    if (graph_) draw_graph(simulation, line);
  }

  void linger(const simulation::Simulation& simulation) override {
    if (live_) live_->linger(simulation);
  }

 private:
  /// The robot whose graph is drawn. Throws BadInput if it has none.
  std::size_t find_graph(const simulation::Simulation& simulation) const {
    const std::string& chosen = graph_->robot();
    for (std::size_t i = 0; i < simulation.robots(); ++i) {
      const std::string& id = simulation.robot(i).description->id;
      if (!chosen.empty() && id != chosen) continue;
      if (!simulation.graphs(i).empty()) return i;
      if (!chosen.empty()) {
        throw BadInput("--graph: no coordinator of the robot '" + id + "' shows a graph" +
                       kWhoHasGraphs);
      }
    }
    if (!chosen.empty()) require_robots(simulation.world(), {chosen}, "--graph");
    throw BadInput(std::string("--graph: no coordinator in this world shows a graph") +
                   kWhoHasGraphs);
  }

  static std::pair<std::vector<picture::NamedGraph>, picture::GraphLights> graphs_of(
      const simulation::Simulation& simulation, std::size_t robot) {
    std::pair<std::vector<picture::NamedGraph>, picture::GraphLights> all;
    for (simulation::LitGraph& lit : simulation.graphs(robot)) {
      all.first.push_back({std::move(lit.path), std::move(lit.graph)});
      all.second.push_back(std::move(lit.lights));
    }
    return all;
  }

  void draw_graph(const simulation::Simulation& simulation, const std::string& line) const {
    // An edit may have removed the robot, or its coordinator.
    const std::size_t robot = find_graph(simulation);
    const auto [graphs, lights] = graphs_of(simulation, robot);
    graph_->save(graphs, lights, simulation.robot(robot).description->id, line);
  }

  void warn_of_rate(double step_s) const {
    constexpr double kRounding = 1e-6;
    const double asked = options_.record.rate_hz, used = recording::rate_in(asked, step_s);
    if (!options_.record.files.empty() && std::abs(used - asked) > kRounding * asked) {
      spdlog::warn("--record-rate " + base::number_text(asked, 6) +
                   ": samples are whole steps of " + base::number_text(step_s, 6) +
                   " s apart; recorded are " + base::number_text(used, 6) + " a second");
    }
  }
  std::vector<files::Output> outputs() const {
    std::vector<files::Output> all;
    for (const std::string& file : options_.record.files) {
      all.push_back({"--record", file});
    }
    if (options_.picture) {
      all.push_back({"--picture", *options_.picture});
    }
    if (graph_) all.push_back({"--graph", graph_->file()});
    return all;
  }
  void add(std::unique_ptr<simulation::Observer> observer) {
    observers_.push_back(observer.get());
    owned_.push_back(std::move(observer));
  }

  ViewOptions options_;
  std::optional<GraphFile> graph_;
  std::vector<std::unique_ptr<simulation::Observer>> owned_;
  std::vector<simulation::Observer*> observers_;
  const traces::TrackRecorder* tracks_ = nullptr;
  std::optional<LiveView> live_;
};

}  // namespace

void describe_formats(CLI::App& command) {
  std::string help = command.get_option("--record")->get_description();
  for (const recording::Format& format : recording::formats()) {
    help += "; " + std::string(format.suffix) + ": " + std::string(format.description);
  }
  command.get_option("--record")
      ->description(help)
      ->type_name("FILE" + recording::suffixes("|FILE"));
}

std::unique_ptr<RunViews> make_views(const ViewOptions& options) {
  return std::make_unique<Views>(options);
}

}  // namespace elsie::program
