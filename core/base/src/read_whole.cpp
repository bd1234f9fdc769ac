#include "elsie/base/read_whole.h"

#include <cerrno>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include <unistd.h>

namespace elsie::base {
namespace {

namespace fs = std::filesystem;

// Rounded up to at most one decimal, so that a size above a limit also reads as larger.
std::string megabytes(std::uintmax_t bytes) {
  const std::uintmax_t tenths = bytes / 100'000 + (bytes % 100'000 > 0 ? 1 : 0);
  return std::to_string(tenths / 10) + (tenths % 10 > 0 ? "." + std::to_string(tenths % 10) : "") +
         " MB";
}

}  // namespace

std::string why_unreadable(const fs::path& file, std::uintmax_t most) {
  if (file.empty()) return "has no name";
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  switch (status.type()) {
    case fs::file_type::regular:
      break;
    case fs::file_type::not_found:
      return "cannot be read: " + std::generic_category().message(ENOENT);
    case fs::file_type::directory:
      return "is a directory";
    case fs::file_type::fifo:
      return "is a pipe, not a file";
    case fs::file_type::block:
    case fs::file_type::character:
      return "is a device, not a file";
    case fs::file_type::socket:
      return "is a socket, not a file";
    default:
      return "cannot be read: " + error.message();
  }
  const std::uintmax_t size = fs::file_size(file, error);
  if (!error && size > most) {
    return "is " + megabytes(size) + " long; files of up to " + megabytes(most) + " are read";
  }
  if (access(file.c_str(), R_OK) != 0) {
    return "cannot be read: " + std::generic_category().message(errno);
  }
  return "";
}

std::string read_whole(const fs::path& file, std::uintmax_t most) {
  if (const std::string why = why_unreadable(file, most); !why.empty()) {
    throw std::runtime_error(why);
  }
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    throw std::runtime_error("cannot be read: " + std::generic_category().message(errno));
  }
  try {
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  } catch (const std::ios_base::failure& failure) {
    throw std::runtime_error("cannot be read: " + failure.code().message());
  }
}

}  // namespace elsie::base
