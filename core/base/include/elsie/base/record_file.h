// A file that is written while a run goes on, and that is whole up to the last line when the
// process is brought down.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "elsie/base/emergency.h"
#include "elsie/base/output_file.h"

namespace elsie::base {

/// Lines are collected and written some thousand bytes at a time.
class RecordFile final : private EmergencyWriter {
 public:
  /// `what`: begins the sentences of errors: "recording '/dev/full'".
  explicit RecordFile(std::string what) : out_(std::move(what)) {}
  ~RecordFile() override;

  /// Creates the file, or empties it. Like all that follows, throws std::runtime_error with a
  /// sentence.
  void create(const std::filesystem::path& file) { out_.create(file); }
  /// A line without its end.
  void line(std::string_view text) {
    buffer_.append(text).append("\n");
    if (buffer_.size() >= kFull) {
      flush();
    }
  }
  void flush();
  /// Writes the rest and closes.
  void close();

 private:
  static constexpr std::size_t kFull = 8 * 1024;

  bool write_now() noexcept override;

  OutputFile out_;
  std::string buffer_;
};

}  // namespace elsie::base
