#include "elsie/neural/training_set.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "text.h"

namespace elsie::neural {
namespace {

constexpr const char* kExpected =
    "a training file: text with one sample a line, numbers separated by tabs or spaces";

std::string part(std::size_t count, const char* thing, const std::string& meaning) {
  return counted(count, thing) + (meaning.empty() ? "" : " (" + meaning + ")");
}

bool is_target(double number) { return number >= 0.0 && number <= 1.0; }

/// Reads the numbers of a line; adds mistakes to the problems.
void read_line(std::string_view line, int place, const Columns& columns, TrainingSet& set,
               Problems& problems) {
  const std::vector<std::string_view> words = words_of(line);
  const std::size_t expected = columns.inputs + columns.outputs;
  if (words.size() != expected) {
    // A word that is no number is reported before a wrong count.
    for (const std::string_view word : words) {
      double ignored = 0.0;
      if (const std::string wrong = read_number(word, ignored); !wrong.empty()) {
        problems.add(place, wrong + "; every line has " + std::to_string(expected) +
                                " numbers with tabs or spaces between them, and nothing else");
        return;
      }
    }
    problems.add(place,
                 (words.empty() ? std::string("an empty line") : counted(words.size(), "number")) +
                     ", expected " + std::to_string(expected) + ": " + columns.text());
    return;
  }
  std::vector<double> numbers(expected);
  bool fine = true;
  for (std::size_t i = 0; i < expected; ++i) {
    std::string wrong = read_number(words[i], numbers[i]);
    if (wrong.empty() && i >= columns.inputs && !is_target(numbers[i])) {
      wrong = "output " + std::to_string(i - columns.inputs + 1) + " is " + std::string(words[i]) +
              ", but a network's answers are in [0, 1]";
    }
    if (!wrong.empty()) {
      problems.add(place, wrong);
      fine = false;
    }
  }
  if (fine) {
    const std::span<const double> all = numbers;
    set.add(all.first(columns.inputs), all.subspan(columns.inputs));
  }
}

}  // namespace

std::string Columns::text() const {
  return part(inputs, "input", inputs_are) + ", then " + part(outputs, "output", outputs_are);
}

void TrainingSet::add(std::span<const double> inputs, std::span<const double> targets) {
  const auto finite = [](double number) { return std::isfinite(number); };
  if (inputs.size() != inputs_ || targets.size() != outputs_ ||
      !std::all_of(inputs.begin(), inputs.end(), finite) ||
      !std::all_of(targets.begin(), targets.end(), is_target)) {
    throw std::invalid_argument("A sample of this set has " + counted(inputs_, "finite input") +
                                " and " + counted(outputs_, "target") + " in [0, 1].");
  }
  numbers_.insert(numbers_.end(), inputs.begin(), inputs.end());
  numbers_.insert(numbers_.end(), targets.begin(), targets.end());
}

TrainingSet parse_training_set(std::string_view text, const Columns& columns,
                               const std::string& name) {
  require_text(text, name, kExpected);
  Problems problems(name, kMostProblems);
  TrainingSet set(columns.inputs, columns.outputs);
  const std::vector<std::string_view> lines = lines_of(text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    read_line(lines[i], static_cast<int>(i + 1), columns, set, problems);
  }
  if (lines.empty()) {
    problems.add(0, "there is no sample in it; expected on every line " + columns.text());
  }
  problems.raise<FileError>();
  return set;
}

TrainingSet read_training_set(const std::string& path, const Columns& columns) {
  return parse_training_set(read_text_file(path, kExpected), columns, path);
}

}  // namespace elsie::neural
