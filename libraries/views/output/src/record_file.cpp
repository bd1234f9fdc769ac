#include "elsie/output/record_file.h"

#include "elsie/base/number_text.h"

namespace elsie::output {

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
  const base::NumberText time(time_s_);
  out_.write_now({buffer_, before_time_, time.view(), after_time_});
  return true;
}

}  // namespace elsie::output
