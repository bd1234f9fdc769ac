// A file that is read from front to back, with its checksum so far.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace elsie::mcap {

class InputFile {
 public:
  /// Throws McapError when the file cannot be opened.
  explicit InputFile(const std::filesystem::path& file);

  std::uint64_t at() const { return at_; }
  std::uint64_t left() const { return size_ - at_; }
  /// The next `count` bytes, or fewer at the end of the file.
  std::string take(std::uint64_t count);
  /// The checksum of all bytes that were taken.
  std::uint32_t checksum() const { return checksum_; }
  /// True if the file has the end of a complete one.
  bool ends_whole() const { return ends_whole_; }

 private:
  std::filesystem::path path_;
  std::ifstream in_;
  std::uint64_t size_ = 0;
  std::uint64_t at_ = 0;
  std::uint32_t checksum_ = 0;
  bool ends_whole_ = false;
};

}  // namespace elsie::mcap
