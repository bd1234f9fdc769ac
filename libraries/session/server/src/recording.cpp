#include "recording.h"

#include <cmath>
#include <string>
#include <utility>

#include "elsie/base/error.h"
#include "elsie/files/outputs.h"

namespace elsie::server {

namespace fs = std::filesystem;

namespace {

constexpr const char* kOrder = "record";

std::vector<files::Output> outputs(const std::vector<fs::path>& files) {
  std::vector<files::Output> all;
  for (const fs::path& file : files) {
    all.push_back({kOrder, file});
  }
  return all;
}

}  // namespace

void Recording::choose(const Json& order, const std::vector<fs::path>& inputs) {
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
    recording::require_recording(file, kOrder);
    files.push_back(file);
  }
  files::require_apart(outputs(files), inputs);
  files_ = std::move(files);
  options_ = std::move(options);
}

void Recording::start(const std::vector<fs::path>& inputs) {
  std::vector<std::unique_ptr<simulation::Observer>> recorders;
  const std::vector<fs::path> files = std::exchange(files_, {});  // each is tried only once
  files::require_apart(outputs(files), inputs);  // the document may have changed since choose()
  for (const fs::path& file : files) {
    const recording::Format* const format = recording::format_of(file);
    recorders.push_back((format ? *format : recording::formats().front()).recorder(file, options_));
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
