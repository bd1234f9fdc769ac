// A results database of made-up runs, opened.
#pragma once

#include <filesystem>
#include <string>

#include "elsie/report/report.h"

#include "made_up.h"
#include "places.h"

namespace elsie::test {

class Made {
 public:
  explicit Made(const MadeExperiment& experiment, report::Questions asked = {})
      : path(build_path("tests/report/made_up_" + std::to_string(++count) + ".db")),
        questions(std::move(asked)) {
    std::filesystem::create_directories(path.parent_path());
    write_database(experiment, path);
  }
  ~Made() { std::filesystem::remove(path); }
  Made(const Made&) = delete;
  Made& operator=(const Made&) = delete;

  report::Findings findings() const {
    return report::find(report::ResultsFile(path).results(), questions);
  }
  std::string html(const std::string& called = "results.db") const {
    const report::ResultsFile file(path);
    return report::html_report(report::find(file.results(), questions), file, called);
  }

  std::filesystem::path path;
  report::Questions questions;

 private:
  inline static int count = 0;
};

/// A study with one expectation.
inline report::Questions expecting(const experiment::Expectation& expectation) {
  report::Questions questions;
  questions.expectations.push_back(expectation);
  return questions;
}

}  // namespace elsie::test
