#include "elsie/recording/formats.h"

#include "elsie/base/error.h"
#include "elsie/files/outputs.h"
#include "elsie/recording/csv_recorder.h"
#include "elsie/recording/mcap_recorder.h"
#include "elsie/traces/sampling.h"

namespace elsie::recording {

double rate_in(double rate_hz, double step_s) {
  return 1.0 / (static_cast<double>(traces::steps_in(1.0 / rate_hz, step_s)) * step_s);
}

std::span<const Format> formats() {
  static const Format all[] = {csv_format(), mcap_format()};
  return all;
}

const Format* format_of(const std::filesystem::path& file) {
  for (const Format& format : formats()) {
    if (file.extension() == format.suffix) {
      return &format;
    }
  }
  return nullptr;
}

void require_recording(const std::filesystem::path& file, const std::string& named_by) {
  for (const Format& format : formats()) {
    files::require_stem(file, named_by, format.suffix);
  }
  const Format* const format = format_of(file);
  if (!format && !files::is_device(file)) {
    throw base::BadInput(named_by + ": a recording's name must end in " + suffixes(" or ") +
                         ", but '" + file.string() + "' does not");
  }
  files::require_replaceable(file, named_by, "recording", [&](std::string_view start) {
    return format && start.starts_with(format->mark) &&
           start.find(format->maker) != std::string_view::npos;
  });
}

std::string suffixes(std::string_view between, bool with_images) {
  std::string list;
  for (const Format& format : formats()) {
    if (with_images && !format.images) {
      continue;
    }
    list += (list.empty() ? "" : std::string(between)) + std::string(format.suffix);
  }
  return list;
}

}  // namespace elsie::recording
