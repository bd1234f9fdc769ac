#include "elsie/recording/formats.h"

#include "elsie/recording/csv_recorder.h"
#include "elsie/recording/mcap_recorder.h"

namespace elsie::recording {

std::span<const Format> formats() {
  static const Format all[] = {
      CsvRecorder::format(),
      McapRecorder::format(),
  };
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
