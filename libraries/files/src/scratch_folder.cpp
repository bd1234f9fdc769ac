#include "elsie/files/scratch_folder.h"

#include <cerrno>
#include <string>
#include <string_view>
#include <system_error>

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace elsie::files {
namespace {

constexpr int kDeepest = 8;

/// A signal handler may call neither readdir(3) nor anything else that allocates.
void remove_content(int folder, int depth) noexcept {
  alignas(dirent64) char entries[2048];
  // Removing entries may make the system skip others.
  for (bool found = true; found;) {
    found = false;
    lseek(folder, 0, SEEK_SET);
    for (long size; (size = syscall(SYS_getdents64, folder, entries, sizeof(entries))) > 0;) {
      for (long at = 0; at < size;) {
        const auto* const entry = reinterpret_cast<const dirent64*>(entries + at);
        at += entry->d_reclen;
        const std::string_view name = entry->d_name;
        if (name == "." || name == "..") {
          continue;
        }
        const int inner = depth < kDeepest ? openat(folder, entry->d_name,
                                                    O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC)
                                           : -1;
        if (inner >= 0) {
          remove_content(inner, depth + 1);
          close(inner);
        }
        found = unlinkat(folder, entry->d_name, inner >= 0 ? AT_REMOVEDIR : 0) == 0 || found;
      }
    }
  }
}

}  // namespace

ScratchFolder::ScratchFolder(const fs::path& parent) {
  constexpr int kAttempts = 1000;
  constexpr mode_t kForAll = 0777;  // less the user's mask
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    path_ = parent / (".elsie-" + std::to_string(::getpid()) + "-" + std::to_string(attempt));
    if (::mkdir(path_.c_str(), kForAll) == 0) {
      return;
    }
    if (errno != EEXIST) {
      break;
    }
  }
  const std::error_code error(errno, std::generic_category());
  retire();
  throw fs::filesystem_error("cannot make a folder", parent, error);
}

ScratchFolder::~ScratchFolder() {
  retire();
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void ScratchFolder::become(const fs::path& target) {
  // The system would replace an empty folder, or a file.
  if (fs::exists(fs::symlink_status(target))) {
    throw fs::filesystem_error("cannot make a folder", target,
                               std::make_error_code(std::errc::file_exists));
  }
  fs::rename(path_, target);
}

void ScratchFolder::clean_up_now() noexcept {
  const int folder = open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (folder >= 0) {
    remove_content(folder, 0);
    close(folder);
    rmdir(path_.c_str());
  }
}

}  // namespace elsie::files
