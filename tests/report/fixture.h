// An open results database with made-up runs.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "elsie/report/margins.h"
#include "elsie/report/report.h"

#include "folder.h"
#include "made_up.h"
#include "places.h"

namespace elsie::test {

/// The margin of one group by itself: only its seeds have to be complete.
inline report::Margin margin_of(const report::Findings& findings, const report::Response& response,
                                const std::vector<std::size_t>& cells) {
  return report::margin_of(findings, response, report::balanced(findings, response, {cells}, {}),
                           0);
}

/// The response of this name; throws std::invalid_argument if there is none.
inline report::Response response_of(const report::Findings& findings, const std::string& name) {
  for (const report::Response& response : report::responses(findings)) {
    if (response.name == name) return response;
  }
  throw std::invalid_argument("there is no " + name);
}

/// Why questions about factors are refused; "" if they are answered.
inline std::string refusal(const report::Findings& findings, const report::Asked& asked) {
  try {
    report::answer(findings, asked);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

class Made {
 public:
  explicit Made(const MadeExperiment& experiment, report::Questions asked = {})
      : questions(std::move(asked)) {
    write_database(experiment, path);
  }

  report::Findings findings() const {
    return report::find(report::ResultsFile(path).results(), questions);
  }
  std::string html(const std::string& called = "results.db") const {
    const report::ResultsFile file(path);
    return report::html_report(report::find(file.results(), questions), file, called);
  }

  const Folder folder{};
  const std::filesystem::path path = folder / "made_up.db";
  report::Questions questions;
};

/// An expectation that asks for nothing yet.
inline experiment::Expectation expectation_of(
    const std::string& name, const std::string& measure,
    experiment::Statistic statistic = experiment::Statistic::mean) {
  experiment::Expectation expectation;
  expectation.name = name;
  expectation.measure = measure;
  expectation.statistic = statistic;
  return expectation;
}

/// Questions with one expectation.
inline report::Questions expecting(const experiment::Expectation& expectation) {
  report::Questions questions;
  questions.expectations.push_back(expectation);
  return questions;
}

}  // namespace elsie::test
