#include "text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "elsie/base/read_whole.h"

namespace elsie::neural {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

}  // namespace

std::string read_number(std::string_view word, double& value) {
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error == std::errc::result_out_of_range && stop == end) {
    return in_quotes(word) + " is beyond what a number can hold";
  }
  if (error != std::errc() || stop != end) {
    return in_quotes(word) + " is not a number" +
           (word.find(',') != std::string_view::npos ? "; write a decimal point, not a comma" : "");
  }
  if (!std::isfinite(value)) {
    return in_quotes(word) + " is not a finite number";
  }
  return "";
}

bool read_count(std::string_view word, long long least, long long& value) {
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  return error == std::errc() && stop == end && value >= least;
}

std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view kBetween = " \t";
  std::vector<std::string_view> words;
  std::size_t at = line.find_first_not_of(kBetween);
  while (at != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(kBetween, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(kBetween, end);
  }
  return words;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) {
    text.remove_prefix(kByteOrderMark.size());
  }
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) {
      line.remove_suffix(1);
    }
    lines.push_back(line);
  }
  while (!lines.empty() && words_of(lines.back()).empty()) {
    lines.pop_back();
  }
  return lines;
}

std::string read_text_file(const std::string& path, const std::string& expected) {
  Problems problems(path);
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    problems.add(0, "there is no such file; expected " + expected);
    problems.raise<FileError>();
  }
  constexpr std::uintmax_t kMostBytes = 256'000'000;
  std::string text;
  try {
    text = base::read_whole(path, kMostBytes);
  } catch (const std::runtime_error& why) {
    problems.add(0, std::string("this ") + why.what() + "; expected " + expected);
  }
  problems.raise<FileError>();
  return text;
}

void require_text(std::string_view text, const std::string& name, const std::string& expected) {
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
    Problems problems(name, kMostProblems);
    const auto before = text.substr(0, zero);
    problems.add(1 + static_cast<int>(std::count(before.begin(), before.end(), '\n')),
                 "this is not a text file, expected " + expected);
    problems.raise<FileError>();
  }
}

}  // namespace elsie::neural
