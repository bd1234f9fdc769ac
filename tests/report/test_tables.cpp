// The report as text: for a terminal, as CSV, JUnit's XML, JSON.
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "elsie/files/clean_text.h"

#include "hostile.h"

using namespace elsie::report;
using Catch::Contains;
using namespace elsie::test;

TEST_CASE("A row of CSV for each run; its numbers are read back bit for bit") {
  MadeExperiment made_up = made_from({{1.0 / 3.0, 1e-300, 12345678901234567890.0, 0.1}});
  made_up.cells[0].runs[0].seed = std::numeric_limits<std::uint64_t>::max();
  made_up.cells[0].runs[3].measures["path_length_m"] = std::nullopt;
  const Made made(made_up);
  const auto rows = parsed_csv(csv_report(made.findings()));
  REQUIRE(rows.size() == 5);
  const auto column = [&](const std::string& name) {
    const auto found = std::find(rows[0].begin(), rows[0].end(), name);
    REQUIRE(found != rows[0].end());
    return static_cast<std::size_t>(found - rows[0].begin());
  };
  for (const auto& row : rows) REQUIRE(row.size() == rows[0].size());
  CHECK(rows[1][column("run")] == "1");
  CHECK(rows[1][column("seed")] == "18446744073709551615");
  CHECK(rows[1][column("scheme")] == "a");
  CHECK(rows[1][column("outcome")] == "success");
  const double values[] = {1.0 / 3.0, 1e-300, 12345678901234567890.0};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string& text = rows[i + 1][column("path_length_m")];
    double value = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    CHECK(std::bit_cast<std::uint64_t>(value) == std::bit_cast<std::uint64_t>(values[i]));
  }
  CHECK(rows[4][column("path_length_m")].empty());
}

TEST_CASE("CSV distinguishes two columns of one name, and quotes what it must") {
  MadeExperiment made_up = hostile();
  made_up.factors[1] = "seed";
  const auto rows = parsed_csv(csv_report(Made(made_up).findings()));
  CHECK(std::count(rows[0].begin(), rows[0].end(), "seed") == 1);
  CHECK(std::count(rows[0].begin(), rows[0].end(), "factor:seed") == 1);
  CHECK(rows[1][1] == elsie::files::clean(kHostile));
}

TEST_CASE("Runs that are still to be done have a row of CSV, too") {
  MadeExperiment made_up = made_from({{1, 2}});
  made_up.cells[0].runs[1].end_as("pending");
  const auto rows = parsed_csv(csv_report(Made(made_up).findings()));
  REQUIRE(rows.size() == 3);
  CHECK(rows[2][4] == "pending");
}

TEST_CASE("JUnit: a test case for each expectation and one for the runs") {
  elsie::experiment::Expectation met = expectation_of("short enough", "path_length_m");
  met.at_most = 3.0;
  elsie::experiment::Expectation missed = met;
  missed.name = "very short";
  missed.at_most = 1.5;
  Questions questions;
  questions.expectations = {met, missed};
  MadeExperiment made_up = made_from({{1, 2, 3}, {2, 2, 2}});
  const std::string xml = junit_report(Made(made_up, questions).findings(), "results.db");
  CHECK_THAT(xml, Contains("<testsuites name=\"elsie\" tests=\"4\" failures=\"1\" errors=\"0\""));
  CHECK_THAT(xml, Contains("<testsuite name=\"made up\" tests=\"4\" failures=\"1\""));
  CHECK_THAT(xml, Contains("timestamp=\"2026-03-01T12:00:00\""));
  CHECK_THAT(xml, Contains("<testcase classname=\"made up\" name=\"short enough\" time=\"0\">\n"
                           "      <system-out>met: mean path_length_m of a is 2 m (3 runs)"));
  CHECK_THAT(xml,
             Contains("<failure message=\"mean path_length_m of a is 2 m (3 runs), expected at "
                      "most 1.5 m (and 1 more)\" type=\"expectation\">"));
  CHECK_THAT(xml, Contains("name=\"every run ended normally\" time=\"0\"/>"));
  const std::string schema =
      "--schema '" + elsie::test::source_path("tests/report/junit.xsd") + "'";
  CHECK(xmllint(xml, schema).empty());
}

TEST_CASE("JUnit and JSON: runs that crashed, and those still to be done, are a failure") {
  MadeExperiment made_up = made_from({{1, 2, 3}});
  made_up.cells[0].runs[0].state = "crash";
  made_up.cells[0].runs[0].signal = "SIGSEGV";
  made_up.cells[0].runs[0].plugin = "wander";
  made_up.cells[0].runs[0].measures.clear();
  made_up.cells[0].runs[1].end_as("pending");
  CHECK_THAT(json_report(Made(made_up).findings()),
             Contains("\"ending\": \"crash by SIGSEGV in plugin 'wander'\""));
  const std::string xml = junit_report(Made(made_up).findings(), "my results.db");
  CHECK_THAT(xml, Contains("1 of 3 runs ended abnormally; 1 of 3 runs is still to be done"));
  CHECK_THAT(xml, Contains("run 1 (a, seed 1): crash by SIGSEGV in plugin 'wander'; elsie "
                           "replay 'my results.db' 1"));
}

TEST_CASE("Runs that are in no database, or all equal, are reported in every form") {
  MadeExperiment made_up = made_from({{1, 2, 3}, {2, 2, 2}});
  for (auto& run : made_up.cells[1].runs) run.state_hash = "00000000000000aa";
  made_up.all_runs = 10;
  const Findings findings = Made(made_up).findings();
  CHECK_FALSE(findings.good());
  CHECK_THAT(junit_report(findings, "x.sqlite"),
             Contains("4 of 10 runs are not in this database\" type=\"run\""));
  CHECK_THAT(json_report(findings), Contains("\"missing\": 4"));
  CHECK_THAT(
      terminal_report(findings, "x.sqlite", 120),
      Contains("6 runs: 2 cells, 3 seeds; 4 of 10 runs are not in this database") &&
          Contains(
              "in 1 of 2 cells all seeds gave one and the same run: nothing there is random (b)"));
}

TEST_CASE("JUnit: a check of every experiment is distinct from an expectation of the same name") {
  elsie::experiment::Expectation expectation =
      expectation_of("every run ended normally", "path_length_m");
  expectation.at_most = 10.0;
  const std::string xml =
      junit_report(Made(made_from({{1, 2}}), expecting(expectation)).findings(), "x.sqlite");
  CHECK_THAT(xml, Contains("classname=\"made up\" name=\"every run ended normally\"") &&
                      Contains("classname=\"made up (runs)\" name=\"every run ended normally\""));
}

TEST_CASE("The message of a run is not repeated") {
  MadeExperiment made_up = made_from({{1, 2, 3, 4}});
  for (auto& run : made_up.cells[0].runs) {
    run.state = "crash";
    run.signal = "SIGSEGV";
    run.plugin = "x";
    run.robot = "r1";
    run.step = 50;
    run.measures.clear();
  }
  auto& runs = made_up.cells[0].runs;
  runs[0].message = "plugin 'x' of robot 'r1' crashed with SIGSEGV in step 50";
  runs[1].message = "plugin 'x' of robot 'r1' crashed with SIGSEGV in step 501";
  runs[2].message = "the process was ended by SIGSEGV";
  const Made made(made_up);
  const std::string xml = junit_report(made.findings(), "r.db");
  const std::string text = terminal_report(made.findings(), "r.db");
  CHECK_THAT(text, Contains("crash: plugin 'x' of robot 'r1' crashed with SIGSEGV in step 50\n"));
  CHECK_THAT(text, Contains("crash at step 50: plugin 'x' of robot 'r1' crashed with SIGSEGV in "
                            "step 501\n"));
  CHECK_THAT(xml, Contains("crash in plugin 'x' of robot 'r1' at step 50: the "
                           "process was ended by SIGSEGV; elsie replay r.db 3"));
  CHECK_THAT(xml, Contains("crash by SIGSEGV in plugin 'x' of robot 'r1' at step "
                           "50; elsie replay r.db 4"));
}

TEST_CASE("JSON has it all") {
  elsie::experiment::Expectation expectation = expectation_of("short", "path_length_m");
  expectation.at_most = 1.0;
  const Made made(made_from({{1, 2, 3, 4, 5, 60}}), expecting(expectation));
  const auto json = nlohmann::json::parse(json_report(made.findings()));
  CHECK(json["experiment"] == "made up");
  CHECK(json["good"] == false);
  CHECK(json["cells"][0]["levels"]["scheme"] == "a");
  CHECK(json["cells"][0]["successes"] == 6);
  CHECK(json["cells"][0]["measures"]["path_length_m"]["mean"] == 12.5);
  CHECK(json["cells"][0]["measures"]["path_length_m"]["interval"].size() == 2);
  CHECK(json["cells"][0]["outliers"][0]["value"] == 60.0);
  CHECK(json["expectations"][0]["met"] == false);
  CHECK(json["expectations"][0]["cells"][0]["value"] == 12.5);
  CHECK(nlohmann::json::accept(
      json_report(Made(hostile(), expecting(hostile_expectation())).findings())));
}

TEST_CASE("The terminal shows cells, measures, what was expected, what went wrong") {
  MadeExperiment made_up = made_from({{29.4, 29.5, 29.6}, {64.0, 65.0, 66.0}});
  made_up.cells[1].runs[0].state = "hang";
  made_up.cells[1].runs[0].message = "It did not end within 600 s.";
  made_up.cells[1].runs[0].measures.clear();
  elsie::experiment::Expectation expectation = expectation_of("short", "path_length_m");
  expectation.at_most = 40.0;
  const std::string text =
      terminal_report(Made(made_up, expecting(expectation)).findings(), "results.db");
  CHECK(text ==
        "made up\n"
        "6 runs: 2 cells, 3 seeds; 1 ended abnormally\n"
        "scheme moves success by 0.33 (which may be chance)\n"
        "\n"
        "cell   success   failed         path_length_m\n"
        "a          3/3        0   29.50 +- 0.10\n"
        "b          2/3        1   65.50 +- 0.71 (n 2)\n"
        "\n"
        "mean +- standard deviation over the runs of a cell that ended normally\n"
        "(n 2): over 2 runs, as the others of the cell have no value\n"
        "\n"
        "Expectations\n"
        "  NOT MET  short: mean path_length_m: at most 40 m\n"
        "           mean path_length_m of b is 65.5 m (2 runs; 1 run ended abnormally), "
        "expected at most 40 m\n"
        "\n"
        "Runs that ended abnormally\n"
        "  run 4 (b, seed 1): hang: It did not end within 600 s.\n"
        "    elsie replay results.db 4\n");
}

TEST_CASE("A table that is too wide for the terminal becomes several") {
  MadeExperiment made_up = made_from({{1, 2}});
  for (auto& run : made_up.cells[0].runs) {
    for (int i = 0; i < 8; ++i) run.measures["measure_number_" + std::to_string(i)] = i;
  }
  const std::string text = terminal_report(Made(made_up).findings(), "r.db", 60);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("measure_number") != std::string::npos) CHECK(line.size() <= 60);
  }
  CHECK_THAT(text, Contains("measure_number_7"));
}
