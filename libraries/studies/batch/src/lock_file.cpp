#include "lock_file.h"

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "elsie/results/database_file.h"

#include "file_identity.h"

namespace elsie::batch {
namespace {

std::string content_of(int descriptor) {
  std::array<char, 256> text;
  const ssize_t size = pread(descriptor, text.data(), text.size(), 0);
  return size > 0 ? std::string(text.data(), static_cast<std::size_t>(size)) : "another process";
}

/// The reason why a lock file cannot be created.
std::string why_not(const std::filesystem::path& locked, const std::filesystem::path& lock,
                    int error) {
  const std::filesystem::path folder = locked.has_parent_path() ? locked.parent_path() : ".";
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored)) {
    return "there is no folder '" + folder.string() + "'; make it first";
  }
  if (error == ENOENT || error == EACCES || error == EROFS || error == EPERM) {
    return "no file can be created in the folder '" + folder.string() + "' (" +
           std::generic_category().message(error) + "); choose another folder";
  }
  return "its lock '" + lock.string() +
         "' cannot be made: " + std::generic_category().message(error);
}

std::string me() {
  std::array<char, 256> host{};
  gethostname(host.data(), host.size() - 1);
  return "process " + std::to_string(getpid()) + " on " + host.data();
}

}  // namespace

std::filesystem::path LockFile::path_for(const std::filesystem::path& file) {
  // A link refers to the same database, and so to the same lock.
  std::error_code error;
  const std::filesystem::path real = std::filesystem::weakly_canonical(file, error);
  return (error ? file : real).string() + "-lock";
}

LockFile::LockFile(const std::filesystem::path& locked) : file_(path_for(locked)) {
  for (;;) {
    descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0) {
      const int error = errno;
      throw results::DatabaseRefused("the database '" + locked.string() +
                                     "' cannot be written: " + why_not(locked, file_, error));
    }
    if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
      const std::string who = content_of(descriptor_);
      close(descriptor_);
      throw results::DatabaseRefused("the database '" + locked.string() +
                                     "' is being written by another batch (" + who +
                                     "); wait until it has ended, or choose another --database");
    }
    if (FileIdentity::of(descriptor_) == FileIdentity::of(file_)) {
      break;
    }
    close(descriptor_);  // another process has just removed the file, so this lock is worthless
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
  const int descriptor = ::open(path_for(locked).c_str(), O_RDWR | O_CLOEXEC);
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
