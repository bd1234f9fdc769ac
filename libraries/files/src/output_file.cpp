#include "elsie/files/output_file.h"

#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "elsie/base/error.h"
#include "elsie/files/write_whole.h"

namespace elsie::files {

OutputFile::OutputFile(std::string what, Refuse refuse) : what_(std::move(what)), refuse_(refuse) {}

OutputFile::~OutputFile() {
  if (file_ >= 0) {
    ::close(file_);
  }
}

void OutputFile::create(const std::filesystem::path& file) {
  constexpr mode_t kForAll = 0666;  // less the user's mask
  file_ = ::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, kForAll);
  struct stat status {};
  if (file_ < 0 || fstat(file_, &status) != 0) {
    fail("cannot be created", errno);
  }
  if (!S_ISREG(status.st_mode)) {
    return;
  }
  // The lock ends with the file's last descriptor, also in a crash. Where the file system has no
  // locks, nothing is refused.
  if (flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(std::exchange(file_, -1));
    throw base::BadInput(what_ + " is being written by another run; name another file, or wait");
  }
  if (ftruncate(file_, 0) != 0) {
    fail("cannot be created", errno);
  }
}

void OutputFile::write(std::string_view bytes) {
  if (const int error = files::write_all(file_, bytes); error != 0) {
    fail("could not be written", error);
  }
  size_ += bytes.size();
}

void OutputFile::write_piece(std::string_view piece) {
  if (failed_ || file_ < 0) {
    fail("could not be written", failed_ ? EIO : EBADF);
  }
  if (const int error = files::write_all(file_, piece); error != 0) {
    failed_ = true;
    // If this fails too, nothing is reported: then the last piece is cut off.
    [[maybe_unused]] const int cut = ftruncate(file_, static_cast<off_t>(size_));
    fail("could not be written", error);
  }
  size_ += piece.size();
}

void OutputFile::close(std::string_view rest) {
  if (file_ < 0) {
    return;
  }
  int error = files::write_all(file_, rest);
  if (::close(std::exchange(file_, -1)) != 0 && error == 0) {
    error = errno;
  }
  if (error != 0) {
    fail("could not be written to its end", error);
  }
  size_ += rest.size();
}

void OutputFile::write_now(std::initializer_list<std::string_view> parts) noexcept {
  for (const std::string_view part : parts) {
    if (file_ < 0 || failed_ || files::write_all(file_, part) != 0) {
      break;
    }
  }
  failed_ = true;
}

void OutputFile::fail(const char* problem, int error) const {
  const std::string sentence =
      what_ + " " + problem + ": " + std::generic_category().message(error);
  if (refuse_) {
    refuse_(sentence);
  }
  throw std::runtime_error(sentence);
}

}  // namespace elsie::files
