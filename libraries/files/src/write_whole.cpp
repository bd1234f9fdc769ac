#include "elsie/files/write_whole.h"

#include <atomic>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "elsie/base/error.h"
#include "elsie/files/emergency.h"

namespace fs = std::filesystem;

namespace elsie::files {
namespace {

constexpr mode_t kForAll = 0666;  // minus the user's mask

/// Opens a new file with a unique name, so that two programs that write the same file do not
/// collide. Sets errno on an error.
fs::path open_beside(const fs::path& file, int& descriptor) {
  constexpr int kAttempts = 1000;
  fs::path part;
  descriptor = -1;
  errno = EEXIST;
  for (int attempt = 0; attempt < kAttempts && descriptor < 0 && errno == EEXIST; ++attempt) {
    part = file;
    part.replace_filename(".elsie-" + std::to_string(::getpid()) + "-" + std::to_string(attempt) +
                          ".part");
    descriptor = ::open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kForAll);
  }
  return part;
}

/// The new file is removed unless it has replaced the old one, also when the process is
/// interrupted.
class Part final : private EmergencyWriter {
 public:
  explicit Part(fs::path path) : path_(std::move(path)) {}
  ~Part() override {
    retire();
    clean_up_now();
  }
  Part& operator=(const Part&) = delete;

  /// Returns zero or errno.
  int replace(const fs::path& file) {
    if (::rename(path_.c_str(), file.c_str()) != 0) {
      return errno;
    }
    is_done_ = true;
    return 0;
  }

 private:
  void clean_up_now() noexcept override {
    if (!is_done_) {
      ::unlink(path_.c_str());
    }
  }

  const fs::path path_;
  std::atomic<bool> is_done_{false};
};

/// Writes and closes; returns the error number.
int fill(int descriptor, std::string_view content, Durable durable) {
  int error = write_all(descriptor, content);
  if (error == 0 && durable == Durable::yes && ::fsync(descriptor) != 0 && errno != EINVAL) {
    error = errno;  // EINVAL: a pipe
  }
  if (::close(descriptor) != 0 && error == 0) {
    error = errno;
  }
  return error;
}

/// Copies the permissions of the replaced file; returns the error number. Where they cannot be set,
/// as on some mounted disks, the file keeps those of a new file.
int keep_mode(const fs::path& file, int descriptor) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) {
    return errno == ENOENT ? 0 : errno;
  }
  const mode_t mode = status.st_mode & (S_IRWXU | S_IRWXG | S_IRWXO);
  return ::fchmod(descriptor, mode) == 0 || errno == EPERM || errno == ENOTSUP ? 0 : errno;
}

int write_in_place(const fs::path& file, std::string_view content, Durable durable) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
  return descriptor < 0 ? errno : fill(descriptor, content, durable);
}

}  // namespace

int write_all(int descriptor, std::string_view bytes) noexcept {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

fs::path end_of_links(fs::path file) {
  constexpr int kMostLinks = 40;  // the limit of Linux
  const fs::path first = file;
  std::error_code error;
  for (int links = 0; links < kMostLinks; ++links) {
    const fs::path target = fs::read_symlink(file, error);
    if (error) {
      return file;  // it is not a link
    }
    file = file.parent_path() / target;
  }
  return first;
}

int write_whole(const fs::path& file, std::string_view content, Durable durable) {
  std::error_code ignored;
  const bool exists = fs::exists(file, ignored);
  if (exists && !fs::is_regular_file(file, ignored)) {
    return write_in_place(file, content, durable);
  }
  const fs::path target = end_of_links(file);
  int descriptor = -1;
  const fs::path beside = open_beside(target, descriptor);
  if (descriptor < 0) {
    const int error = errno;
    const bool closed_folder = error == EACCES || error == EPERM || error == EROFS;
    return exists && closed_folder ? write_in_place(file, content, durable) : error;
  }
  Part part(beside);
  const int mode_error = keep_mode(target, descriptor);
  int error = fill(descriptor, content, durable);
  error = error != 0 ? error : mode_error;
  return error != 0 ? error : part.replace(target);
}

void write_whole_or_throw(const fs::path& file, std::string_view content, Durable durable) {
  if (const int error = write_whole(file, content, durable); error != 0) {
    throw base::Error("'" + file.string() +
                      "' cannot be written: " + std::generic_category().message(error));
  }
}

}  // namespace elsie::files
