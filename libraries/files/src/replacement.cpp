#include "elsie/files/replacement.h"

#include <cerrno>
#include <string>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "fill.h"

namespace elsie::files {

Replacement::Replacement(std::filesystem::path file) : file_(std::move(file)) {
  struct stat status {};
  if (::stat(file_.c_str(), &status) == 0) {
    mode_ = status.st_mode & (S_IRWXU | S_IRWXG | S_IRWXO);
  } else if (errno != ENOENT) {
    error_ = errno;
    return;
  }
  constexpr mode_t kForAll = 0666, kOwn = 0600;
  const mode_t mode = mode_ ? (*mode_ & kForAll) | kOwn : kForAll;  // minus the user's mask
  // The name is unique, so that two programs that write the same file do not collide.
  constexpr int kAttempts = 1000;
  errno = EEXIST;
  for (int attempt = 0; attempt < kAttempts && descriptor_ < 0 && errno == EEXIST; ++attempt) {
    path_ = file_;
    path_.replace_filename(".elsie-" + std::to_string(::getpid()) + "-" + std::to_string(attempt) +
                           ".part");
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
  }
  error_ = descriptor_ < 0 ? errno : 0;
  is_there_ = descriptor_ >= 0;
}

Replacement::~Replacement() {
  retire();
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
  clean_up_now();
}

void Replacement::clean_up_now() noexcept {
  if (is_there_) {
    ::unlink(path_.c_str());
  }
}

int Replacement::write(std::string_view content, Durable durable) {
  if (error_ == 0) {
    error_ = fill(std::exchange(descriptor_, -1), content, durable);
  }
  return error_;
}

int Replacement::replace() {
  if (error_ == 0 && mode_ && ::chmod(path_.c_str(), *mode_) != 0 && errno != EPERM &&
      errno != ENOTSUP) {
    error_ = errno;
  }
  if (error_ == 0 && ::rename(path_.c_str(), file_.c_str()) != 0) {
    error_ = errno;
  }
  if (error_ == 0) {
    is_there_ = false;
  }
  return error_;
}

}  // namespace elsie::files
