#include "elsie/files/csv_line.h"

#include <algorithm>
#include <charconv>
#include <system_error>

#include "elsie/files/clean_text.h"

namespace elsie::files {

namespace {

/// Spreadsheets compute a text that begins like this, and may run a program for it.
bool is_formula(std::string_view text) {
  if (text.empty() || std::string_view("=+-@").find(text.front()) == std::string_view::npos) {
    return false;
  }
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  return read.ec == std::errc::invalid_argument || read.ptr != end;
}

bool is_plain(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c < '\x7f'; });
}

}  // namespace

std::string csv_cell(std::string_view given) {
  const std::string text =
      (is_formula(given) ? "'" : "") + (is_plain(given) ? std::string(given) : clean(given));
  if (text.find_first_of(",\"\n#") == std::string::npos) {
    return text;
  }
  std::string cell = "\"";
  for (const char c : text) {
    cell += c;
    if (c == '"') {
      cell += c;
    }
  }
  return cell + '"';
}

}  // namespace elsie::files
