#include "elsie/learning/values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "elsie/base/number_text.h"
#include "elsie/base/words.h"

namespace elsie::learning {
namespace {

constexpr neural::DataFileKind kValues{"elsie values", kValuesVersion, "file of values", "values"};
constexpr const char* kRemarkOrTable = "a line that begins with 'about' or 'table'";

class ValuesReader {
 public:
  ValuesReader(std::string_view text, const std::string& name) : lines_(kValues, text, name) {}

  Values read() {
    Values values;
    lines_.next(kRemarkOrTable);
    values.about = lines_.remarks(kRemarkOrTable);
    do {
      values.tables.push_back(read_table());
    } while (lines_.words()[0] == "table");
    lines_.end("the table has no further row");
    return values;
  }

 private:
  /// Reads a table, and moves to the line after it.
  NamedTable read_table() {
    const auto& words = lines_.words();
    if (words.size() != 4 || words[0] != "table") {
      lines_.refuse("expected 'table', its name, how many rows, and how many numbers in each");
    }
    NamedTable table{std::string(words[1]), made(count(words[2]), count(words[3]))};
    for (std::size_t row = 0; row < table.values.states(); ++row) {
      lines_.next("the next row of the table");
      read_row(table.values, row);
    }
    lines_.next("a row, a table, or 'end' after the last one");
    return table;
  }

  ValueTable made(std::size_t rows, std::size_t numbers) {
    try {
      return ValueTable(rows, numbers);
    } catch (const std::invalid_argument& problem) {
      lines_.refuse(problem.what());
    }
  }

  void read_row(ValueTable& values, std::size_t row) {
    const auto& words = lines_.words();
    const std::string which = "row " + std::to_string(row + 1);
    if (words.size() < 2 || words[0] != "row" || words[1] != std::to_string(row + 1)) {
      lines_.refuse("expected '" + which + "' and its numbers");
    }
    if (words.size() != values.actions() + 2) {
      lines_.refuse(which + " has " + base::counted(words.size() - 2, "number") + ", expected " +
                    std::to_string(values.actions()));
    }
    for (std::size_t i = 0; i < values.actions(); ++i) {
      values.at(row, i) = lines_.number(words[i + 2]);
    }
  }

  std::size_t count(std::string_view word) {
    std::size_t number = 0;
    const char* const end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, number);
    if (error != std::errc() || stop != end || number < 1 || number > kMostValues) {
      lines_.refuse("the size " + base::in_quotes(word) + " is not a whole number from 1 to " +
                    std::to_string(kMostValues));
    }
    return number;
  }

  neural::DataFileReader lines_;
};

void check(const NamedTable& table) {
  if (table.name.empty() || table.name.find_first_of(" \t\r\n") != std::string::npos) {
    throw std::invalid_argument("'" + table.name +
                                "' cannot be written as the name of a table: it must be one word.");
  }
  if (table.values.states() == 0 || table.values.actions() == 0) {
    throw std::invalid_argument("The table '" + table.name +
                                "' has no values, and cannot be written.");
  }
  for (std::size_t row = 0; row < table.values.states(); ++row) {
    const auto values = table.values.row(row);
    if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); })) {
      throw std::invalid_argument("The table '" + table.name + "' has a value in row " +
                                  std::to_string(row + 1) +
                                  " that is not finite, and cannot be written.");
    }
  }
}

}  // namespace

ValueTable::ValueTable(std::size_t states, std::size_t actions)
    : states_(states), actions_(actions) {
  if (actions > 0 && states > kMostValues / actions) {
    throw std::invalid_argument("A table of " + std::to_string(states) + " x " +
                                std::to_string(actions) + " values is too large; it may have " +
                                std::to_string(kMostValues) + ".");
  }
  values_.resize(states * actions);
}

std::size_t ValueTable::best(std::size_t state) const {
  const auto values = row(state);
  return static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
}

std::string values_text(const Values& values) {
  if (values.tables.empty()) {
    throw std::invalid_argument("A file of values without a table cannot be written.");
  }
  std::string text = first_line(kValues) + remark_lines(values.about);
  for (const NamedTable& table : values.tables) {
    check(table);
    text += "table " + table.name + ' ' + std::to_string(table.values.states()) + ' ' +
            std::to_string(table.values.actions()) + '\n';
    for (std::size_t row = 0; row < table.values.states(); ++row) {
      text += "row " + std::to_string(row + 1);
      for (const double value : table.values.row(row)) {
        text += ' ';
        text += base::NumberText(value).view();
      }
      text += '\n';
    }
  }
  return text + "end\n";
}

Values parse_values(std::string_view text, const std::string& name) {
  return ValuesReader(text, name).read();
}

Values read_values(const std::string& path) {
  return parse_values(neural::read_data_file(kValues, path), path);
}

bool looks_like_values(const std::string& path) { return neural::looks_like(kValues, path); }

void write_values(const Values& values, const std::string& path) {
  neural::write_data_file(kValues, path, values_text(values));
}

}  // namespace elsie::learning
