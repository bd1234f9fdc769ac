// Recordings of the next run.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "elsie/recording/formats.h"
#include "elsie/simulation/observer.h"

#include "link.h"

namespace elsie::server {

class Recording {
 public:
  /// Reads an order: `files`, `rate`, `images`. `inputs`: the files of the world, which no
  /// recording may replace. Throws base::BadInput for impossible recordings.
  void choose(const Json& order, const std::vector<std::filesystem::path>& inputs);
  /// Creates the files once. Throws if a file cannot be created; then the next run is not recorded.
  void start(const std::vector<std::filesystem::path>& inputs);
  /// Samples per simulated second, as chosen.
  double rate_hz() const { return options_.rate_hz; }
  /// Whether the next run is to be recorded.
  bool is_due() const { return !files_.empty(); }
  /// The observers of the run.
  const std::vector<simulation::Observer*>& observers() const { return observers_; }
  /// Finishes the files after the end of the run.
  void close();

 private:
  std::vector<std::filesystem::path> files_;
  recording::RecorderOptions options_;
  std::vector<std::unique_ptr<simulation::Observer>> recorders_;
  std::vector<simulation::Observer*> observers_;
};

}  // namespace elsie::server
