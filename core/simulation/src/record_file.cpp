#include "record_file.h"

#include <charconv>

namespace elsie::simulation {

RecordFile::~RecordFile() {
  retire();
  out_.write_now({buffer_});
}

void RecordFile::flush() {
  const std::string lines = std::exchange(buffer_, {});
  out_.write(lines);
}

void RecordFile::close() {
  const std::string lines = std::exchange(buffer_, {});
  out_.close(lines);
}

bool RecordFile::write_now() noexcept {
  if (!out_.is_open()) {
    return false;
  }
  if (before_time_.empty()) {
    out_.write_now({buffer_});
    return true;
  }
  char time[32];
  char* const end = std::to_chars(time, time + sizeof time, time_s_).ptr;
  out_.write_now(
      {buffer_, before_time_, {time, static_cast<std::size_t>(end - time)}, after_time_});
  return true;
}

}  // namespace elsie::simulation
