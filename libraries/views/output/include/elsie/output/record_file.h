// A file of lines that is written during a run, and ends with a whole line if the process crashes.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "elsie/base/emergency.h"
#include "elsie/output/output_file.h"

namespace elsie::output {

/// Collects lines and writes them 8 kB at a time.
class RecordFile final : private base::EmergencyWriter {
 public:
  /// `what`: begins the sentences of errors: "recording '/dev/full'".
  explicit RecordFile(std::string what) : out_(std::move(what)) {}
  ~RecordFile() override;

  /// Creates the file, or empties it. This and all functions below throw std::runtime_error.
  void create(const std::filesystem::path& file) { out_.create(file); }
  /// A line without its end.
  void line(std::string_view text) {
    buffer_.append(text).append("\n");
    if (buffer_.size() >= kFull) {
      flush();
    }
  }
  void flush();
  /// A last line for a process that crashes, with the time of the last at() between its two parts.
  /// Must be set before the first at(). Both parts must be short.
  void set_last_words(std::string before, std::string after) {
    before_time_ = std::move(before);
    after_time_ = std::move(after);
  }
  /// The simulated time up to which lines were given, s.
  void at(double time_s) { time_s_ = time_s; }
  /// Writes the rest and closes the file.
  void close();

 private:
  static constexpr std::size_t kFull = 8 * 1024;

  bool write_now() noexcept override;

  OutputFile out_;
  std::string buffer_;
  std::string before_time_, after_time_;
  double time_s_ = 0.0;
};

}  // namespace elsie::output
