// Recordings of the run that starts next.
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
  /// From an order: `files`, `rate`, `images`. Throws base::BadInput for what no recording can be.
  void choose(const Json& order);
  /// Creates the files, once. Throws when one cannot be made; the next run is then not recorded.
  void start();
  /// Who watches the run.
  const std::vector<simulation::Observer*>& observers() const { return observers_; }
  /// Once the run has ended.
  void close();

 private:
  std::vector<std::filesystem::path> files_;
  recording::RecorderOptions options_;
  std::vector<std::unique_ptr<simulation::Observer>> recorders_;
  std::vector<simulation::Observer*> observers_;
};

}  // namespace elsie::server
