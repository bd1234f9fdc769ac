#include "trace_line.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace elsie::traces {
namespace {

constexpr std::size_t kShown = 40;  // characters of what was found

[[noreturn]] void unexpected(std::string_view text, std::string_view column, const char* expected) {
  throw TraceLineError((text.empty() ? "nothing" : shown(text)) + " stands as " +
                       std::string(column) + ", where " + expected + " was expected");
}

/// The text up to its closing quote, which is taken off `rest` with it; none without one.
std::optional<std::string> take_quoted(std::string_view& rest) {
  std::string value;
  while (true) {
    const std::size_t quote = rest.find('"');
    if (quote == std::string_view::npos) {
      return std::nullopt;
    }
    value += rest.substr(0, quote);
    rest.remove_prefix(quote + 1);
    if (rest.empty() || rest.front() != '"') {
      return value;
    }
    value += '"';
    rest.remove_prefix(1);
  }
}

}  // namespace

std::string shown(std::string_view text) {
  return "'" + trace_format::one_line(text.substr(0, kShown)) +
         (text.size() > kShown ? "...'" : "'");
}

double number_in(std::string_view text, std::string_view column) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    unexpected(text, column, "a finite number");
  }
  return value;
}

double degree_in(std::string_view text, std::string_view column) {
  const double value = number_in(text, column);
  if (!(value >= 0.0 && value <= 1.0)) {
    unexpected(text, column, "a number from 0 to 1");
  }
  return value;
}

std::uint64_t count_in(std::string_view text, std::string_view column) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    unexpected(text, column, "a whole number");
  }
  return value;
}

ParsedRemark::ParsedRemark(std::string_view line) {
  std::string_view rest = line.substr(2);
  const auto take = [&](char stop) {
    const std::string_view taken = rest.substr(0, rest.find(stop));
    rest.remove_prefix(std::min(rest.size(), taken.size() + 1));
    return std::string(taken);
  };
  word_ = take(' ');
  while (!rest.empty()) {
    Field field{take('='), {}};
    if (rest.empty() || rest.front() != '"') {
      throw TraceLineError("the value of " + shown(field.name) + " is not in quotes");
    }
    rest.remove_prefix(1);
    auto value = take_quoted(rest);
    if (!value || !(rest.empty() || rest.front() == ' ')) {
      throw TraceLineError("the quotes around the value of " + shown(field.name) +
                           " are not as they should be");
    }
    rest.remove_prefix(rest.empty() ? 0 : 1);
    field.value = std::move(*value);
    fields_.push_back(std::move(field));
  }
}

const std::string& ParsedRemark::operator[](std::string_view name) const {
  const auto at = std::find_if(fields_.begin(), fields_.end(),
                               [&](const Field& field) { return field.name == name; });
  if (at == fields_.end()) {
    throw TraceLineError("the line " + shown("# " + word_) + " has no " + std::string(name));
  }
  return at->value;
}

void ParsedRow::parse(std::string_view line) {
  cells_.fill({});
  std::size_t column = 0;
  for (bool more = true; more; ++column) {
    if (column == cells_.size()) {
      throw TraceLineError("there are more than " + std::to_string(cells_.size()) +
                           " cells in the row");
    }
    if (!line.empty() && line.front() == '"') {
      line.remove_prefix(1);
      auto value = take_quoted(line);
      if (!value || !(line.empty() || line.front() == ',')) {
        throw TraceLineError("the quotes around a cell are not as they should be");
      }
      unquoted_[column] = std::move(*value);
      cells_[column] = unquoted_[column];
    } else {
      cells_[column] = line.substr(0, line.find(','));
      line.remove_prefix(cells_[column].size());
    }
    more = !line.empty();
    line.remove_prefix(more ? 1 : 0);
  }
}

}  // namespace elsie::traces
