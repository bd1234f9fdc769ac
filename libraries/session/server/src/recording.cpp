#include "recording.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "elsie/base/error.h"

namespace elsie::server {

namespace fs = std::filesystem;

void Recording::choose(const Json& order) {
  std::vector<fs::path> files;
  recording::RecorderOptions options;
  options.rate_hz = order.value("rate", options.rate_hz);
  options.images = order.value("images", false);
  options.program = "elsie " ELSIE_VERSION;
  if (!(options.rate_hz > 0.0) || !std::isfinite(options.rate_hz)) {
    throw base::BadInput("a recording needs a positive number of samples a second");
  }
  for (const Json& each : order.at("files")) {
    const fs::path file = fs::absolute(each.get<std::string>());  // a plugin may change folders
    const std::string what = "'" + each.get<std::string>() + "' cannot be a recording: ";
    if (!recording::format_of(file)) {
      throw base::BadInput(what + "expected a name that ends in " + recording::suffixes(" or "));
    }
    if (!fs::is_directory(file.parent_path())) {
      throw base::BadInput(what + "there is no folder '" + file.parent_path().string() + "'");
    }
    if (std::find(files.begin(), files.end(), file) != files.end()) {
      throw base::BadInput(what + "it is named twice");
    }
    files.push_back(file);
  }
  files_ = std::move(files);
  options_ = std::move(options);
}

void Recording::start() {
  std::vector<std::unique_ptr<simulation::Observer>> recorders;
  for (const fs::path& file : std::exchange(files_, {})) {  // each is tried only once
    recorders.push_back(recording::format_of(file)->recorder(file, options_));
  }
  for (auto& recorder : recorders) {
    observers_.push_back(recorder.get());
    recorders_.push_back(std::move(recorder));
  }
}

void Recording::close() {
  observers_.clear();
  recorders_.clear();
}

}  // namespace elsie::server
