#include "elsie/files/write_whole.h"

#include <cerrno>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include "elsie/base/error.h"
#include "elsie/files/replacement.h"

#include "fill.h"

namespace fs = std::filesystem;

namespace elsie::files {
namespace {

int write_in_place(const fs::path& file, std::string_view content, Durable durable) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
  return descriptor < 0 ? errno : fill(descriptor, content, durable);
}

}  // namespace

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
  Replacement part(end_of_links(file));
  const int error = part.error();
  if (exists && (error == EACCES || error == EPERM || error == EROFS)) {  // a closed folder
    return write_in_place(file, content, durable);
  }
  part.write(content, durable);
  return part.replace();
}

void write_whole_or_throw(const fs::path& file, std::string_view content, Durable durable) {
  if (const int error = write_whole(file, content, durable); error != 0) {
    throw base::Error("'" + file.string() +
                      "' cannot be written: " + std::generic_category().message(error));
  }
}

}  // namespace elsie::files
