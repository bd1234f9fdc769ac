#include "arguments.h"

#include <charconv>
#include <cmath>
#include <limits>

#include <CLI/CLI.hpp>

#include "elsie/base/number_text.h"

namespace elsie::program {

namespace {

template <typename Whole>
std::optional<Whole> parse_whole(std::string_view text) {
  Whole value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value)
                                                                  : std::nullopt;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

CLI::Validator positive_number(double most) {
  const bool any = most == std::numeric_limits<double>::infinity();
  const std::string limit = any ? "" : " and at most " + base::fixed_text(most, 0);
  return CLI::Validator(
      [=](std::string& text) -> std::string {
        const auto value = parse_number(text);
        return value && *value > 0.0 && *value <= most
                   ? ""
                   : "'" + text + "' is not a number above zero" + limit;
      },
      "NUMBER > 0");
}

CLI::Validator non_negative_number() {
  return CLI::Validator(
      [](std::string& text) -> std::string {
        const auto value = parse_number(text);
        return value && *value >= 0.0 ? "" : "'" + text + "' is not a number of zero or above";
      },
      "NUMBER >= 0");
}

CLI::Validator number_between(double least, double most) {
  const auto written = [](double bound) {
    return bound == std::floor(bound) ? base::fixed_text(bound, 0) : base::number_text(bound);
  };
  const std::string range = "from " + written(least) + " to " + written(most);
  return CLI::Validator(
      [=](std::string& text) -> std::string {
        const auto value = parse_number(text);
        return value && *value >= least && *value <= most
                   ? ""
                   : "'" + text + "' is not a number " + range;
      },
      range);
}

CLI::Validator whole_number() {
  return CLI::Validator(
      [](std::string& text) -> std::string {
        return parse_whole<std::int64_t>(text)
                   ? ""
                   : "'" + text + "' is not a whole number, or too large";
      },
      "INT");
}

CLI::Validator whole_number(std::int64_t least, std::int64_t most) {
  const std::string range = "from " + std::to_string(least) + " to " + std::to_string(most);
  return CLI::Validator(
      [=](std::string& text) -> std::string {
        const auto value = parse_whole<std::int64_t>(text);
        return value && *value >= least && *value <= most
                   ? ""
                   : "'" + text + "' is not a whole number " + range;
      },
      range);
}

CLI::Validator seed_number() {
  return CLI::Validator(
      [](std::string& text) -> std::string {
        return parse_whole<std::uint64_t>(text)
                   ? ""
                   : "'" + text + "' is not a whole number from 0 to 18446744073709551615";
      },
      "UINT");
}

void add_threads_option(CLI::App& command, std::size_t& threads) {
  command
      .add_option("--threads", threads,
                  "Threads in which robots sense, decide and move. The run is the same with any "
                  "number")
      ->check(whole_number(1, 256))
      ->type_name("N")
      ->capture_default_str();
}

}  // namespace elsie::program
