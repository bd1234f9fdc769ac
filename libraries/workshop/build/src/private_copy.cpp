#include "elsie/build/private_copy.h"

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "elsie/files/emergency.h"

#include "own_folder.h"

namespace elsie::build {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kBegin = "elsie-copy-";  // followed by the process and random letters

/// Whether a folder of copies was left behind by a process that was killed. A young folder is kept:
/// its process may run in another container, where this process cannot see it.
bool is_left_behind(const fs::path& folder) {
  constexpr time_t kYoung = 60;  // s
  const std::string name = folder.filename().string();
  if (!name.starts_with(kBegin)) {
    return false;
  }
  pid_t process = 0;
  const char* const end = name.data() + name.size();
  const auto read = std::from_chars(name.data() + kBegin.size(), end, process);
  struct stat status {};
  return read.ec == std::errc() && read.ptr != end && *read.ptr == '-' && process > 0 &&
         lstat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) &&
         status.st_uid == geteuid() && time(nullptr) - status.st_mtim.tv_sec > kYoung &&
         kill(process, 0) != 0 && errno == ESRCH;
}

/// Removes what processes left behind that could not clean up themselves.
bool sweep_copies(const fs::path& temporary) {
  std::error_code error;
  for (fs::directory_iterator at(temporary, error), end; !error && at != end; at.increment(error)) {
    if (is_left_behind(at->path())) {
      std::error_code ignored;
      fs::remove_all(at->path(), ignored);
    }
  }
  return true;
}

class PrivateCopy final : private files::EmergencyWriter {
 public:
  explicit PrivateCopy(const fs::path& file);
  ~PrivateCopy() override;

  const fs::path& path() const { return path_; }

 private:
  void clean_up_now() noexcept override;

  std::string folder_;
  std::string file_;
  fs::path path_;
};

PrivateCopy::PrivateCopy(const fs::path& file) {
  std::error_code error;
  const fs::path temporary = fs::temp_directory_path(error);
  [[maybe_unused]] static const bool swept = sweep_copies(temporary);
  fs::path folder = temporary / (std::string(kBegin) + std::to_string(getpid()) + "-XXXXXX");
  folder_ = folder.string();
  if (!mkdtemp(folder_.data())) {
    error = {errno, std::generic_category()};
    folder_.clear();
  } else {
    try {
      own_folder(folder_, kCopiesOfPlugins);
    } catch (...) {
      clean_up_now();
      retire();
      throw;
    }
    file_ = folder_ + "/" + file.filename().string();
    path_ = file_;
    fs::copy_file(file, path_, error);
  }
  if (error) {
    const std::string problem = "could not be copied to " + folder.parent_path().string() +
                                " for loading: " + error.message();
    clean_up_now();
    retire();
    throw std::runtime_error(problem);
  }
}

PrivateCopy::~PrivateCopy() {
  retire();
  clean_up_now();
}

void PrivateCopy::clean_up_now() noexcept {
  if (!file_.empty()) {
    unlink(file_.c_str());
  }
  if (!folder_.empty()) {
    rmdir(folder_.c_str());
  }
}

}  // namespace

std::shared_ptr<const fs::path> private_copy(const fs::path& library) {
  auto copy = std::make_shared<PrivateCopy>(library);
  const fs::path* const path = &copy->path();
  return {std::move(copy), path};
}

}  // namespace elsie::build
