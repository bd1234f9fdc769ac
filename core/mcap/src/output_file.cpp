#include "output_file.h"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include "elsie/mcap/records.h"

#include "format.h"

namespace elsie::mcap {
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

OutputFile::OutputFile(const std::filesystem::path& file) : path_(file) {
  constexpr mode_t kForAll = 0666;  // less the user's mask
  file_ = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, kForAll);
  if (file_ < 0) {
    fail("cannot be created", errno);
  }
}

OutputFile::~OutputFile() {
  if (file_ >= 0) {
    ::close(file_);
  }
}

void OutputFile::write(std::string_view piece) {
  if (failed_ || file_ < 0) {
    fail("could not be written", failed_ ? EIO : EBADF);
  }
  if (const int error = write_all(file_, piece); error != 0) {
    failed_ = true;
    // Not worth a word when it fails, too: then the last chunk is cut off.
    [[maybe_unused]] const int cut = ftruncate(file_, static_cast<off_t>(size_));
    fail("could not be written", error);
  }
  size_ += piece.size();
  checksum_ = crc(piece, checksum_);
}

void OutputFile::close() {
  const int file = file_;
  file_ = -1;
  if (file >= 0 && ::close(file) != 0) {
    fail("could not be written to its end", errno);
  }
}

void OutputFile::write_now(std::initializer_list<std::string_view> parts) noexcept {
  for (const std::string_view part : parts) {
    if (file_ < 0 || failed_ || write_all(file_, part) != 0) {
      break;
    }
  }
  failed_ = true;
}

void OutputFile::fail(const char* problem, int error) {
  throw McapError("recording '" + path_.string() + "' " + problem + ": " +
                  std::generic_category().message(error));
}

}  // namespace elsie::mcap
