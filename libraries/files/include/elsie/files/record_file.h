// A file of lines that is written during a run, and ends with a whole line if the process crashes.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "elsie/files/emergency.h"
#include "elsie/files/output_file.h"

namespace elsie::files {

/// Collects lines and writes them 8 kB at a time.
class RecordFile final : private files::EmergencyWriter {
 public:
  /// `what`: begins the sentences of errors: "recording '/dev/full'".
  explicit RecordFile(std::string what) : out_(std::move(what)) {}
  ~RecordFile() override;

  /// Creates the file, or empties it. This and all functions below throw std::runtime_error.
  void create(const std::filesystem::path& file) { out_.create(file); }
  /// Adds a line; `text` does not include its end.
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
  static constexpr std::size_t kFull = 8'192;

  bool write_now() noexcept override;

  OutputFile out_;
  std::string buffer_;
};

}  // namespace elsie::files
