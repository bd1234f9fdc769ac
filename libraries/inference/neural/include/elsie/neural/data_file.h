// Data files with an item on each line: weights, learned values. They begin with a line that names
// their kind and the version of its format, have remarks ("about"), and finish with "end". Empty
// lines and lines that begin with # are ignored.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/neural/error.h"

namespace elsie::neural {

/// A remark in a data file about its content: `key` is a word, `text` one line.
struct Remark {
  std::string key;
  std::string text;

  friend bool operator==(const Remark&, const Remark&) = default;
};

/// The text of a remark, or "".
std::string_view remark(std::span<const Remark> about, std::string_view key);

/// A kind of data file.
struct DataFileKind {
  std::string_view first_words;  // "elsie network"
  int version;
  const char* name;     // "weight file"
  const char* content;  // "weights", for messages
};

/// The first line of a file of this kind.
std::string first_line(const DataFileKind& kind);
/// A line for each remark. Throws std::invalid_argument for one whose key is no word or repeated,
/// or whose text has several lines, or blanks around it, which would not be read back.
std::string remark_lines(std::span<const Remark> about);

/// Whether the file begins like one of this kind.
bool looks_like(const DataFileKind& kind, const std::string& path);

/// The content of a file. Throws FileError when it does not exist, is no file, or is no text.
std::string read_data_file(const DataFileKind& kind, const std::string& path);

/// Writes a file in one piece, through a new file next to it. Throws std::runtime_error with file
/// and reason when it cannot be written; an existing file is then unchanged.
void write_data_file(const DataFileKind& kind, const std::string& path, const std::string& text);

/// Reads the lines of a file in order; stops at the first mistake, because the lines after it
/// depend on it.
class DataFileReader {
 public:
  /// Reads the first line. `name`: of the file in messages. The text must outlive the reader. This
  /// and all other functions throw FileError.
  DataFileReader(const DataFileKind& kind, std::string_view text, std::string name);

  /// Moves to the next line; "... expected `expected`" if there is none.
  void next(const char* expected);
  /// The words of the present line.
  const std::vector<std::string_view>& words() const { return words_; }
  /// Reads remarks while there are any, beginning with the present line. `expected`: of next().
  std::vector<Remark> remarks(const char* expected);
  /// The word as a finite number.
  double number(std::string_view word);
  /// Reads the last line. `otherwise`: why it should be here.
  void end(const char* otherwise);

  /// Throws a mistake in the present line.
  [[noreturn]] void refuse(const std::string& message) const;

 private:
  bool advance();

  std::string name_;
  std::vector<std::string_view> lines_;
  std::size_t line_ = 0;  // number of lines read
  std::vector<std::string_view> words_;
};

}  // namespace elsie::neural
