#include "lock_file.h"

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "elsie/batch/results_database.h"

namespace elsie::batch {
namespace {

std::string content_of(int descriptor) {
  std::array<char, 256> text;
  const ssize_t size = pread(descriptor, text.data(), text.size(), 0);
  return size > 0 ? std::string(text.data(), static_cast<std::size_t>(size)) : "another process";
}

/// Whether the file of this name is still the one that was opened.
bool is_there(int descriptor, const std::filesystem::path& file) {
  struct stat opened {};
  struct stat named {};
  return fstat(descriptor, &opened) == 0 && stat(file.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

std::string me() {
  std::array<char, 256> host{};
  gethostname(host.data(), host.size() - 1);
  return "process " + std::to_string(getpid()) + " on " + host.data();
}

}  // namespace

std::filesystem::path LockFile::beside(const std::filesystem::path& file) {
  return file.string() + "-lock";
}

LockFile::LockFile(const std::filesystem::path& locked) : file_(beside(locked)) {
  for (;;) {
    descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0) {
      const int error = errno;
      const auto folder = locked.has_parent_path() ? locked.parent_path() : ".";
      throw DatabaseRefused(
          "the database '" + locked.string() + "' cannot be written: " +
          (error == ENOENT ? "there is no folder '" + folder.string() + "'; make it first"
                           : "its lock '" + file_.string() +
                                 "' cannot be made: " + std::generic_category().message(error)));
    }
    if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
      const std::string who = content_of(descriptor_);
      close(descriptor_);
      throw DatabaseRefused("the database '" + locked.string() +
                            "' is being written by another batch (" + who +
                            "); wait until it has ended, or choose another --database");
    }
    if (is_there(descriptor_, file_)) {
      break;
    }
    close(descriptor_);  // somebody has just removed it; the lock is on nothing
  }
  const std::string text = me();
  if (ftruncate(descriptor_, 0) == 0) {
    [[maybe_unused]] const ssize_t written = pwrite(descriptor_, text.data(), text.size(), 0);
  }
}

LockFile::LockFile(LockFile&& other) noexcept
    : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

LockFile::~LockFile() {
  if (descriptor_ >= 0) {
    unlink(file_.c_str());
    close(descriptor_);
  }
}

std::optional<std::string> LockFile::holder(const std::filesystem::path& locked) {
  const int descriptor = ::open(beside(locked).c_str(), O_RDWR | O_CLOEXEC);
  if (descriptor < 0) {
    return std::nullopt;
  }
  std::optional<std::string> who;
  if (flock(descriptor, LOCK_SH | LOCK_NB) != 0) {
    who = content_of(descriptor);
  }
  close(descriptor);
  return who;
}

}  // namespace elsie::batch
