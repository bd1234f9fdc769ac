// made_up_study DATABASE PAGE [CASE]: writes a made-up study, or one of edge_cases(), and its page,
// to be viewed in a browser. Prints the report for a terminal.
#include <cstdio>
#include <exception>
#include <fstream>
#include <string>

#include "elsie/report/report.h"

#include "edge_cases.h"

int main(int count, char** words) {
  try {
    if (count < 3) return 2;
    elsie::test::MadeExperiment study = elsie::test::made_study();
    for (const elsie::test::EdgeCase& edge : elsie::test::edge_cases()) {
      if (count > 3 && edge.name == words[3]) study = edge.experiment;
    }
    elsie::test::write_database(study, words[1]);
    const elsie::report::ResultsFile file(words[1]);
    elsie::report::Questions questions;
    auto& met = questions.expectations.emplace_back();
    met.name = "fusion completes every case";
    met.measure = "success";
    met.statistic = elsie::experiment::Statistic::rate;
    met.where = {{"coordinator", {"fusion"}}};
    met.at_least = 1.0;
    auto& shorter = questions.expectations.emplace_back();
    shorter.name = "fusion's path is much shorter";
    shorter.measure = "path_length_m";
    shorter.where = {{"coordinator", {"fusion"}}};
    shorter.relation = elsie::experiment::Relation::ratio;
    shorter.reference = {{"coordinator", "arbitration"}};
    shorter.at_most = 0.6;
    shorter.confidence = 0.95;
    auto& arbitration = questions.expectations.emplace_back();
    arbitration.name = "arbitration succeeds, too";
    arbitration.measure = "success";
    arbitration.statistic = elsie::experiment::Statistic::rate;
    arbitration.where = {{"coordinator", {"arbitration"}}};
    arbitration.at_least = 0.8;
    if (count > 3) questions = elsie::test::edge_questions();
    const auto findings = elsie::report::find(file.results(), questions);
    std::ofstream(words[2]) << elsie::report::html_report(findings, file, "results.db");
    std::fputs(elsie::report::terminal_report(findings, "results.db").c_str(), stdout);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "made_up_study: %s\n", error.what());
    return 1;
  }
}
