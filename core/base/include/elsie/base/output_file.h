// A file that grows while a run goes on, and that is of use whenever that ends: on a full disk, and
// when the process is brought down.
#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

namespace elsie::base {

class OutputFile {
 public:
  /// Throws the error of a module, with this sentence.
  using Refuse = void (*)(const std::string& sentence);

  /// `what` begins the sentences of errors: "recording '/dev/full'". Without `refuse`,
  /// std::runtime_error is thrown.
  explicit OutputFile(std::string what, Refuse refuse = nullptr);
  /// Closes it without a word on errors.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Creates the file, or empties it. Like write() and close(), throws.
  void create(const std::filesystem::path& file);
  /// Adds to it; if that fails, as much as there was room for.
  void write(std::string_view bytes);
  /// Adds to it; if that fails, the file is as it was before, where the file system can do that,
  /// and every later piece is refused.
  void write_piece(std::string_view piece);
  /// The last bytes, and the end.
  void close(std::string_view rest = {});
  bool is_open() const { return file_ >= 0; }

  /// The last bytes, in parts, without an error and without allocating memory: for handlers of
  /// signals. No piece is written after them.
  void write_now(std::initializer_list<std::string_view> parts) noexcept;

  /// How many bytes were written, but for those of write_now().
  std::uint64_t size() const { return size_; }

 private:
  [[noreturn]] void fail(const char* problem, int error) const;

  std::string what_;
  Refuse refuse_;
  int file_ = -1;
  bool failed_ = false;
  std::uint64_t size_ = 0;
};

}  // namespace elsie::base
