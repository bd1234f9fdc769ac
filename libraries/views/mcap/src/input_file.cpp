#include "input_file.h"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "elsie/base/read_whole.h"
#include "elsie/mcap/records.h"

#include "format.h"

namespace elsie::mcap {

InputFile::InputFile(const std::filesystem::path& file) : path_(file) {
  std::error_code error;
  if (const std::string why = base::why_unreadable(file); !why.empty()) {
    throw McapError("recording '" + file.string() + "' " + why);
  }
  in_.open(file, std::ios::binary);
  if (in_) {
    size_ = std::filesystem::file_size(file, error);
  }
  if (!in_ || error) {
    throw McapError("recording '" + file.string() + "' cannot be read: " +
                    (error ? error.message() : std::generic_category().message(errno)));
  }
  if (size_ >= 2 * kMagic.size()) {
    std::string end(kMagic.size(), '\0');
    in_.seekg(-static_cast<std::streamoff>(end.size()), std::ios::end);
    in_.read(end.data(), static_cast<std::streamsize>(end.size()));
    in_.seekg(0);
    ends_whole_ = end == kMagic;
  }
}

std::string InputFile::take(std::uint64_t count) {
  std::string bytes(static_cast<std::size_t>(std::min(count, left())), '\0');
  in_.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!in_) {
    throw McapError("recording '" + path_.string() + "' cannot be read on from byte " +
                    std::to_string(at_));
  }
  at_ += bytes.size();
  checksum_ = crc(bytes, checksum_);
  return bytes;
}

}  // namespace elsie::mcap
