#include "elsie/files/record_file.h"

#include <utility>

namespace elsie::files {

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
  out_.write_now({buffer_});
  return true;
}

}  // namespace elsie::files
