#include "file.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <stdexcept>
#include <system_error>

#include "elsie/files/write_whole.h"

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

}  // namespace

FileType file_type(const std::filesystem::path& file) {
  std::string suffix = file.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (suffix == ".png") return FileType::png;
  if (suffix == ".svg") return FileType::svg;
  if (suffix == ".pdf") return FileType::pdf;
  throw std::invalid_argument(
      "The picture '" + file.string() + "' has " +
      (suffix.empty() ? "no suffix" : "the suffix '" + suffix + "'") +
      ", but pictures are written as .png, .svg or .pdf: end its name with one.");
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
  if (const int error = files::write_whole(file, content); error != 0) refuse(file, error);
}

}  // namespace elsie::picture
