#include "record_file.h"

#include <cerrno>
#include <charconv>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace elsie::simulation {
namespace {

/// Zero, or what went wrong.
int write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(file, bytes.data(), bytes.size());
    if (count >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

}  // namespace

RecordFile::~RecordFile() {
  retire();
  if (file_ >= 0) {
    write_all(file_, buffer_);
    ::close(file_);
  }
}

void RecordFile::create(const std::filesystem::path& file) {
  constexpr mode_t kForAll = 0666;  // less the user's mask
  file_ = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, kForAll);
  if (file_ < 0) {
    fail("cannot be created", errno);
  }
}

void RecordFile::flush() {
  const int error = write_all(file_, buffer_);
  buffer_.clear();
  if (error != 0) {
    fail("could not be written", error);
  }
}

void RecordFile::close() {
  int error = write_all(file_, buffer_);
  buffer_.clear();
  if (::close(file_) != 0 && error == 0) {
    error = errno;
  }
  file_ = -1;
  if (error != 0) {
    fail("could not be written to its end", error);
  }
}

bool RecordFile::write_now() noexcept {
  if (file_ < 0) {
    return false;
  }
  write_all(file_, buffer_);
  if (!before_time_.empty()) {
    char time[32];
    char* const end = std::to_chars(time, time + sizeof time, time_s_).ptr;
    write_all(file_, before_time_);
    write_all(file_, {time, static_cast<std::size_t>(end - time)});
    write_all(file_, after_time_);
  }
  return true;
}

void RecordFile::fail(const char* problem, int error) const {
  throw std::runtime_error(what_ + " " + problem + ": " + std::generic_category().message(error));
}

}  // namespace elsie::simulation
