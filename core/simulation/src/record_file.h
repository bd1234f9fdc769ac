// A file that is written while a run goes on, and that is whole up to the last line when the
// process is brought down.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "elsie/plugin/crash_report.h"

namespace elsie::simulation {

/// Lines are collected and written some thousand bytes at a time.
class RecordFile final : private plugin::EmergencyWriter {
 public:
  /// `what`: begins the sentences of errors: "recording '/dev/full'".
  explicit RecordFile(std::string what) : what_(std::move(what)) {}
  ~RecordFile() override;

  /// Creates the file, or empties it. Like all that follows, throws std::runtime_error with a
  /// sentence.
  void create(const std::filesystem::path& file);
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
  [[noreturn]] void fail(const char* problem, int error) const;

  std::string what_;
  std::string buffer_;
  int file_ = -1;
};

}  // namespace elsie::simulation
