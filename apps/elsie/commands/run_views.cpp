#include "run_views.h"

#include <filesystem>
#include <vector>

#include "elsie/recording/csv_recorder.h"
#include "elsie/recording/mcap_recorder.h"
#include "elsie/traces/trace_recorder.h"
#include "elsie/traces/tracks.h"

#include "command.h"
#include "environment.h"
#include "image_saver.h"
#include "make_views.h"
#include "top_view.h"

namespace elsie::program {

namespace {

bool is_mcap(const std::filesystem::path& recording) { return recording.extension() == ".mcap"; }

std::unique_ptr<simulation::Observer> recorder(const RecordOptions& options) {
  if (is_mcap(*options.file)) {
    return std::make_unique<recording::McapRecorder>(
        *options.file, recording::McapOptions{options.rate_hz, options.images, options.times,
                                              "elsie " ELSIE_VERSION});
  }
  return std::make_unique<recording::CsvRecorder>(*options.file, options.rate_hz, options.times);
}

class Views final : public RunViews {
 public:
  explicit Views(ViewOptions options) : options_(std::move(options)) {
    const RecordOptions& record = options_.record;
    if (record.file) {
      require_recording(*record.file, "--record");
    }
    if (record.images && !is_mcap(*record.file)) {
      throw BadInput(
          "--record-images: a table has no place for pictures; expected --record FILE.mcap");
    }
    if (options_.explain) {
      require_trace(*options_.explain, "--explain");
    }
    if (options_.picture) {
      require_picture(*options_.picture, "--picture");
      // A plugin may change folders.
      options_.picture = std::filesystem::absolute(*options_.picture);
    }
    if (options_.image_folder) {
      require_image_folder(*options_.image_folder, "--save-images");
    }
  }

  void open(const simulation::Simulation& simulation) override {
    if (options_.record.images) {
      require_cameras(simulation, "--record-images");
    }
    options_.paths.check(simulation.world());
    if (options_.record.file) {
      add(recorder(options_.record));
    }
    if (options_.image_folder) {
      add(std::make_unique<ImageSaver>(*options_.image_folder, options_.image_period_s));
    }
    if (options_.explain) {
      add(std::make_unique<traces::TraceRecorder>(*options_.explain, options_.explain_times));
    }
    if (options_.picture) {
      auto tracks = std::make_unique<traces::TrackRecorder>();
      tracks_ = tracks.get();
      add(std::move(tracks));
    }
  }

  std::span<simulation::Observer* const> observers() const override { return observers_; }

  void draw(const simulation::Simulation& simulation, const std::string& line) const override {
    if (options_.picture) {
      program::draw(simulation, tracks_, {line}, *options_.picture, options_.picture_width,
                    options_.paths.choice());
    }
  }

 private:
  void add(std::unique_ptr<simulation::Observer> observer) {
    observers_.push_back(observer.get());
    owned_.push_back(std::move(observer));
  }

  ViewOptions options_;
  std::vector<std::unique_ptr<simulation::Observer>> owned_;
  std::vector<simulation::Observer*> observers_;
  const traces::TrackRecorder* tracks_ = nullptr;
};

}  // namespace

std::unique_ptr<RunViews> make_views(const ViewOptions& options) {
  return std::make_unique<Views>(options);
}

}  // namespace elsie::program
