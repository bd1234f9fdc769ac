#include "file.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace elsie::picture {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, int error) {
  throw std::runtime_error("Cannot write the picture '" + file.string() +
                           "': " + std::generic_category().message(error) +
                           (error == ENOSPC
                                ? ". Make room there, or name a file elsewhere."
                                : ". Name a file in a folder that exists and that you may write "
                                  "to."));
}

// A new file that no one else has, so that two programs writing the same picture do not meet.
std::filesystem::path open_beside(const std::filesystem::path& file, int& descriptor) {
  constexpr int kAttempts = 1000;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    std::filesystem::path part = file;
    part.replace_filename(".elsie-picture-" + std::to_string(::getpid()) + "-" +
                          std::to_string(attempt) + ".part");
    descriptor = ::open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0) return part;
    if (errno != EEXIST) break;
  }
  refuse(file, errno);
}

// The error number, 0 for none.
int write_all(int descriptor, const std::string& content) {
  std::size_t written = 0;
  while (written < content.size()) {
    const ssize_t count = ::write(descriptor, content.data() + written, content.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    written += static_cast<std::size_t>(count);
  }
  return 0;
}

}  // namespace

FileType file_type(const std::filesystem::path& file) {
  std::string suffix = file.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (suffix == ".png") return FileType::png;
  if (suffix == ".svg") return FileType::svg;
  throw std::invalid_argument("The picture '" + file.string() + "' has " +
                              (suffix.empty() ? "no suffix" : "the suffix '" + suffix + "'") +
                              ", but pictures are written as .png or .svg: end its name with one.");
}

void check_size(const Size& size) {
  constexpr int kLeast = 200, kMost = 16000;
  const auto fits = [](int length) { return length >= kLeast && length <= kMost; };
  if (fits(size.width) && (size.height == 0 || fits(size.height))) return;
  throw std::invalid_argument(
      "A picture of " + std::to_string(size.width) + " x " + std::to_string(size.height) +
      " pixels cannot be drawn: width and height must be from " + std::to_string(kLeast) + " to " +
      std::to_string(kMost) + ", or the height 0 for what the content needs.");
}

void write_whole(const std::filesystem::path& file, const std::string& content) {
  int descriptor = -1;
  const std::filesystem::path part = open_beside(file, descriptor);
  int error = write_all(descriptor, content);
  if (::close(descriptor) != 0 && error == 0) error = errno;
  if (error == 0 && ::rename(part.c_str(), file.c_str()) != 0) error = errno;
  if (error == 0) return;
  ::unlink(part.c_str());
  refuse(file, error);
}

}  // namespace elsie::picture
