#include "elsie/neural/data_file.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "elsie/files/write_whole.h"

#include "text.h"

namespace elsie::neural {
namespace {

/// "a weight file, as elsie train writes it".
std::string expected_file(const DataFileKind& kind) {
  return std::string("a ") + kind.name + ", as elsie train writes it";
}

std::string trimmed_after(std::string_view line, std::string_view word) {
  const auto begin = static_cast<std::size_t>(word.data() - line.data()) + word.size();
  const std::size_t first = line.find_first_not_of(" \t", begin);
  if (first == std::string_view::npos) {
    return "";
  }
  return std::string(line.substr(first, line.find_last_not_of(" \t") + 1 - first));
}

bool is_blank(char c) { return c == ' ' || c == '\t'; }

}  // namespace

std::string_view remark(std::span<const Remark> about, std::string_view key) {
  const auto found =
      std::find_if(about.begin(), about.end(), [&](const Remark& r) { return r.key == key; });
  return found == about.end() ? std::string_view() : std::string_view(found->text);
}

std::string first_line(const DataFileKind& kind) {
  return std::string(kind.first_words) + ' ' + std::to_string(kind.version) + '\n';
}

std::string remark_lines(std::span<const Remark> about) {
  std::string lines;
  for (auto each = about.begin(); each != about.end(); ++each) {
    const bool is_word = words_of(each->key).size() == 1 && words_of(each->key)[0] == each->key;
    const bool known = std::any_of(about.begin(), each,
                                   [&](const Remark& other) { return other.key == each->key; });
    const std::string& text = each->text;
    const bool reads_back =
        (each->key + text).find_first_of(std::string_view("\r\n\0", 3)) == std::string::npos &&
        (text.empty() || (!is_blank(text.front()) && !is_blank(text.back())));
    if (!is_word || known || !reads_back) {
      throw std::invalid_argument("'" + each->key +
                                  "' cannot be written as a remark: it must be one word that "
                                  "occurs once, and its text one line without blanks around it.");
    }
    lines += "about " + each->key + (each->text.empty() ? "" : " ") + each->text + '\n';
  }
  return lines;
}

bool looks_like(const DataFileKind& kind, const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string beginning(kind.first_words.size(), '\0');
  file.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  return file && beginning == kind.first_words;
}

std::string read_data_file(const DataFileKind& kind, const std::string& path) {
  return read_text_file(path, expected_file(kind));
}

void write_data_file(const DataFileKind& kind, const std::string& path, const std::string& text) {
  // Stored on the disk before it replaces another file.
  const int error = files::write_whole(path, text, files::Durable::yes);
  if (error == 0) return;
  throw std::runtime_error(
      std::string("Cannot write the ") + kind.content + " '" + path +
      "': " + std::generic_category().message(error) +
      (error == ENOSPC ? ". Make room there, or name a file elsewhere."
                       : ". Name a file in a folder that exists and that you may write to."));
}

DataFileReader::DataFileReader(const DataFileKind& kind, std::string_view text, std::string name)
    : name_(std::move(name)), lines_(lines_of(text)) {
  require_text(text, name_, expected_file(kind));
  const auto first = words_of(kind.first_words);
  if (!advance() || words_.size() != 3 || words_[0] != first[0] || words_[1] != first[1]) {
    line_ = std::max<std::size_t>(line_, 1);
    refuse(std::string("this is no ") + kind.name + ": expected '" + std::string(kind.first_words) +
           ' ' + std::to_string(kind.version) + "' as its first line");
  }
  if (words_[2] != std::to_string(kind.version)) {
    refuse("the file has version " + neural::in_quotes(words_[2]) +
           ", but this program reads version " + std::to_string(kind.version) +
           "; write it again with this version's elsie train");
  }
}

bool DataFileReader::advance() {
  while (line_ < lines_.size()) {
    words_ = words_of(lines_[line_++]);
    if (!words_.empty() && !words_[0].starts_with('#')) {
      return true;
    }
  }
  return false;
}

void DataFileReader::next(const char* expected) {
  if (!advance()) {
    refuse(std::string("the file ends here, expected ") + expected +
           "; was it cut off? Write it again with elsie train");
  }
}

std::vector<Remark> DataFileReader::remarks(const char* expected) {
  std::vector<Remark> about;
  for (; words_[0] == "about"; next(expected)) {
    if (words_.size() < 2) {
      refuse("expected a word and a text after 'about'");
    }
    const std::string key(words_[1]);
    if (std::any_of(about.begin(), about.end(), [&](const Remark& r) { return r.key == key; })) {
      refuse("a second line about " + neural::in_quotes(key));
    }
    about.push_back({key, trimmed_after(lines_[line_ - 1], words_[1])});
    if ((about.back().key + about.back().text).find('\r') != std::string::npos) {
      refuse("the remark about " + neural::in_quotes(key) +
             " contains a carriage return; remove it");
    }
  }
  return about;
}

double DataFileReader::number(std::string_view word) {
  double value = 0.0;
  if (const std::string wrong = read_number(word, value); !wrong.empty()) {
    refuse(wrong);
  }
  return value;
}

void DataFileReader::end(const char* otherwise) {
  if (words_.size() != 1 || words_[0] != "end") {
    refuse(std::string("expected 'end': ") + otherwise);
  }
  if (advance()) {
    refuse("expected nothing after 'end'");
  }
}

void DataFileReader::refuse(const std::string& message) const {
  throw FileError({{name_, static_cast<int>(line_), message}});
}

}  // namespace elsie::neural
