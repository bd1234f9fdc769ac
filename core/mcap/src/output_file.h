// A file that grows by whole pieces.
#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

namespace elsie::mcap {

class OutputFile {
 public:
  /// Creates the file, or empties it. Like write() and close(), throws McapError.
  explicit OutputFile(const std::filesystem::path& file);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Adds a piece. If that fails, the file is as it was before it, where the file system can do
  /// that; and so does every later call.
  void write(std::string_view piece);
  void close();
  bool is_open() const { return file_ >= 0; }

  /// The last piece, in parts: as write(), without an error and without allocating memory.
  void write_now(std::initializer_list<std::string_view> parts) noexcept;

  std::uint64_t size() const { return size_; }
  /// Of all that was written.
  std::uint32_t checksum() const { return checksum_; }

 private:
  [[noreturn]] void fail(const char* problem, int error);

  std::filesystem::path path_;
  int file_ = -1;
  bool failed_ = false;
  std::uint64_t size_ = 0;
  std::uint32_t checksum_ = 0;
};

}  // namespace elsie::mcap
