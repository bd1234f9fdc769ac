// Every form of a report on databases that are hardly a study.
#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "elsie/base/utf8.h"

#include "edge_cases.h"
#include "hostile.h"

using namespace elsie::report;
using namespace elsie::test;
using Catch::Contains;

namespace {

Findings findings_of(const std::string& name) {
  for (const EdgeCase& edge : edge_cases()) {
    if (edge.name == name) {
      return Made(edge.experiment, edge_questions()).findings();
    }
  }
  throw std::invalid_argument("there is no edge case '" + name + "'");
}

}  // namespace

TEST_CASE("Every form is well-formed in every case") {
  for (const EdgeCase& edge : edge_cases()) {
    CAPTURE(edge.name);
    const Made made(edge.experiment, edge_questions());
    const Findings findings = made.findings();
    const std::string text = terminal_report(findings, "my results.db");
    const std::string html = made.html();
    for (const std::string& form : {text, html}) {
      for (const std::string odd : {" nan", "-nan", ">nan", " inf<", ">inf", "inf ±"}) {
        CHECK_THAT(form, !Contains(odd));
      }
    }
    CHECK(xmllint(junit_report(findings, "my results.db"),
                  "--schema '" + source_path("tests/report/junit.xsd") + "'")
              .empty());
    const auto json = nlohmann::json::parse(json_report(findings));
    CHECK(json["cells"].size() == findings.cells.size());
    const auto rows = parsed_csv(csv_report(findings));
    REQUIRE(rows.size() == findings.runs() + 1);
    CHECK(std::all_of(rows.begin(), rows.end(),
                      [&](const auto& row) { return row.size() == rows[0].size(); }));
  }
}

TEST_CASE("When every run crashed, an expectation says so") {
  const Findings findings = findings_of("all crashed");
  CHECK(findings.verdicts[0].trouble ==
        "no run has a measure 'path_length_m': all 6 runs crashed, the first of them run 1 (a, "
        "seed 1)");
  CHECK(findings.verdicts[1].trouble.empty());
  CHECK(findings.verdicts[1].claims[0].sentence ==
        "success rate of a is 0 (0 of 3; 3 runs ended abnormally), expected at least 1");
}

TEST_CASE("Runs that ended badly in several ways are counted by these") {
  MadeExperiment experiment = made_from({{1, 2, 3}, {2, 3}});
  for (auto& cell : experiment.cells) {
    for (auto& run : cell.runs) {
      run.state = run.seed == 1 ? "hang" : "crash";
      run.measures.clear();
    }
  }
  const auto trouble = [&] {
    return Made(experiment, edge_questions()).findings().verdicts[0].trouble;
  };
  CHECK(trouble() ==
        "no run has a measure 'path_length_m': all 5 runs ended abnormally (3 crashed, 2 "
        "hung), the first of them run 1 (a, seed 1)");
  experiment.cells[1].runs[1].state = "pending";
  CHECK(trouble() ==
        "no run has a measure 'path_length_m': 4 of 5 runs ended abnormally (2 crashed, 2 "
        "hung), the first of them run 1 (a, seed 1), and 1 is still to be done");
  experiment.cells[1].runs[1].state = "done";
  CHECK(trouble() ==
        "no run that ended normally has a measure 'path_length_m'; 4 of 5 runs ended abnormally "
        "(2 crashed, 2 hung), the first of them run 1 (a, seed 1)");
  experiment.cells = {experiment.cells[0]};
  experiment.cells[0].runs = {experiment.cells[0].runs[0]};
  CHECK(trouble() == "no run has a measure 'path_length_m': the only run hung: run 1 (a, seed 1)");
}

TEST_CASE("When nothing is done yet, an expectation says so") {
  const Findings findings = findings_of("all pending");
  CHECK(findings.verdicts[0].trouble == "no run has a measure 'path_length_m' yet: none is done");
  CHECK(findings.verdicts[0].open());
  CHECK(findings.verdicts[1].claims[0].sentence ==
        "success rate of a is not known yet: not all runs of a are done, 3 are still to be done; "
        "expected at least 1");
}

TEST_CASE("A page of runs that are pending, or crashed, claims no more than is known") {
  for (const EdgeCase& edge : edge_cases()) {
    const std::string html = Made(edge.experiment, edge_questions()).html();
    if (edge.name == "all pending") {
      CHECK_THAT(html, Contains("<span>No run is done yet</span></h2>"));
      CHECK_THAT(html, Contains("No run is done yet.</p>") && !Contains("No run stands out"));
      CHECK_THAT(html, Contains("there is nothing to compare but success"));
      CHECK_THAT(html, !Contains("0\xc2\xa0\xe2\x80\x93\xc2\xa0"
                                 "100\xc2\xa0%"));
    } else if (edge.name == "all crashed") {
      const std::string plain = Made(edge.experiment).html();
      CHECK_THAT(plain, Contains("<span>No run ended normally</span></h2>"));
    } else if (edge.name == "one run") {
      CHECK_THAT(html, !Contains("id=\"distributions\"") && Contains("id=\"comparison\""));
    }
  }
}

TEST_CASE("A table for a terminal has no empty column, and none that is endless") {
  CHECK_THAT(terminal_report(findings_of("all crashed"), "r.db"),
             !Contains("mean +- standard deviation"));
  const std::string text = terminal_report(findings_of("long names"), "r.db");
  const std::string table =
      text.substr(text.find("\n\n"), text.find("mean +-") - text.find("\n\n"));
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    CHECK(elsie::base::characters(line) <= 130);
  }
}

TEST_CASE("Cells whose levels begin alike keep names that differ, in the table and in figures") {
  const std::string text = terminal_report(findings_of("alike names"), "r.db");
  const std::string table =
      text.substr(text.find("\n\n") + 2, text.rfind("\n\n") - text.find("\n\n"));
  std::set<std::string> names;
  std::istringstream lines(table.substr(0, table.find("\n\n")));
  for (std::string line; std::getline(lines, line);) {
    CHECK(elsie::base::characters(line.substr(0, line.find("  "))) <= 60);
    names.insert(line.substr(0, line.find("  ")));
  }
  CHECK(names.size() == 1 + 6);  // the head
  CHECK_THAT(text, Contains("fusion by vect\xe2\x80\xa6 memory of 1 s, "
                            "feed_forward_n\xe2\x80\xa6hidden_layer_4  "));
  for (const EdgeCase& edge : edge_cases()) {
    if (edge.name != "alike names") continue;
    CHECK_THAT(Made(edge.experiment).html(),
               Contains(">fusion by v\xe2\x80\xa6ory of 1 s, feed_forwar\xe2\x80\xa6"
                        "en_layer_4</text>"));
  }
}

TEST_CASE("Unusable values are left out, and shown as they are") {
  const Findings findings = findings_of("odd values");
  const auto measure = [&](const std::string& name) -> const MeasureFindings& {
    for (std::size_t i = 0; i < findings.measures.size(); ++i) {
      if (findings.results.measures[findings.measures[i]].name == name) {
        return findings.cells[0].measures[i];
      }
    }
    throw std::invalid_argument(name);
  };
  CHECK(measure("always_null").values.empty());
  CHECK(measure("sometimes_null").values == std::vector<double>{1.0, 3.0, 5.0});
  CHECK(measure("boundless").values.empty());
  CHECK(measure("huge").values.empty());
  CHECK(measure("tiny").values.size() == 6);
  CHECK_THAT(csv_report(findings), Contains(",1.7e+308,") && Contains(",inf,"));
}

TEST_CASE("A shell accepts the command of a run for any name of the database") {
  const Made made(made_from({{1, 2, 3, 4, 5, 60}}));
  const std::string called = "my \"best\" <runs>, it's 5 & more/r 1.db";
  CHECK_THAT(made.html(called),
             Contains("<td>outlier: path length 60 m</td><td><code class=\"command\">elsie replay "
                      "'my &quot;best&quot; &lt;runs&gt;, it'\\''s 5 &amp; more/r 1.db' 6</code>"));
}
