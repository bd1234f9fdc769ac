#include "private_copy.h"

#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

#include <unistd.h>

namespace elsie::plugin {

namespace fs = std::filesystem;

PrivateCopy::PrivateCopy(const fs::path& file) {
  std::error_code error;
  fs::path folder = fs::temp_directory_path(error) / "elsie-copy-XXXXXX";
  folder_ = folder.string();
  if (!mkdtemp(folder_.data())) {
    error = {errno, std::generic_category()};
    folder_.clear();
  } else {
    file_ = folder_ + "/" + file.filename().string();
    fs::copy_file(file, file_, error);
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

}  // namespace elsie::plugin
