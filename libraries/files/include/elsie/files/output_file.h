// A file that grows during a run and stays usable when the disk is full or the process crashes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

namespace elsie::files {

class OutputFile {
 public:
  /// Throws an error of the caller's own type with this sentence.
  using Refuse = void (*)(const std::string& sentence);

  /// `what` begins the sentences of errors: "recording '/dev/full'". Without `refuse`, errors are
  /// std::runtime_error.
  explicit OutputFile(std::string what, Refuse refuse = nullptr);
  /// Closes the file and ignores errors.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Creates the file, or empties it. A regular file that another OutputFile is writing, perhaps in
  /// another process, is refused and stays as it is: base::BadInput. This and all functions below
  /// but write_now() throw.
  void create(const std::filesystem::path& file);
  /// Appends; if that fails, the file has as many bytes as there was room for.
  void write(std::string_view bytes);
  /// Appends; if that fails, the file is cut back to its size before, where the file system can do
  /// that, and all later pieces are refused.
  void write_piece(std::string_view piece);
  /// Appends the rest and closes the file.
  void close(std::string_view rest = {});
  bool is_open() const { return file_ >= 0; }

  /// Appends the last bytes without throwing or allocating memory, for signal handlers. No piece is
  /// written after them.
  void write_now(std::initializer_list<std::string_view> parts) noexcept;

  /// The bytes written so far, without those of write_now().
  std::uint64_t size() const { return size_; }

 private:
  [[noreturn]] void fail(const char* problem, int error) const;

  std::string what_;
  Refuse refuse_;
  int file_ = -1;
  bool failed_ = false;
  std::uint64_t size_ = 0;
};

}  // namespace elsie::files
