#include <string>
#include <vector>

#include "elsie/report/report.h"

#include "markup.h"
#include "numbers.h"
#include "words.h"

namespace elsie::report {

namespace {

struct TestCase {
  std::string name;
  std::string failure;  // one sentence; empty: passed
  std::string details;  // a line for each cell or run
  std::string kind;     // kind of the failure
  bool of_expectation = false;
  bool open = false;  // the failure is only that it is not known yet
};

TestCase case_of(const Verdict& verdict) {
  TestCase test{verdict.name, "", "", "expectation", true};
  std::size_t broken = 0;
  for (const Claim& claim : verdict.claims) {
    test.details += (claim.holds  ? "met: "
                     : claim.open ? "not known yet: "
                                  : "not met: ") +
                    claim.sentence + "\n";
    // What is known to be missed comes first.
    const bool counts = !claim.holds && (verdict.open() || !claim.open);
    if (counts && broken++ == 0) {
      test.failure = claim.sentence;
    }
  }
  if (broken > 1) {
    test.failure += " (and " + std::to_string(broken - 1) + " more)";
  }
  if (!verdict.trouble.empty()) {
    test.failure = verdict.trouble;
  }
  test.open = verdict.open();
  return test;
}

TestCase every_run_ended(const Findings& findings, const std::string& database) {
  TestCase test{"every run ended normally", "", "", "run"};
  for (const Run& run : findings.results.runs) {
    if (!run.broken()) {
      continue;
    }
    test.details += name_of(findings.results, run) + ": " + ending_in_words(run) + "; " +
                    replay_command(database, run.id) + "\n";
  }
  if (findings.broken() > 0) {
    test.failure = std::to_string(findings.broken()) + " of " + counted(findings.runs(), "run") +
                   " ended abnormally";
  }
  if (findings.pending() > 0) {
    test.failure += (test.failure.empty() ? "" : "; ") + std::to_string(findings.pending()) +
                    " of " + counted(findings.runs(), "run") + " " +
                    (findings.pending() == 1 ? "is" : "are") + " still to be done";
  }
  if (findings.partial()) {
    test.failure += (test.failure.empty() ? "" : "; ") + missing_in_words(findings);
  }
  return test;
}

TestCase seeds_decide(const Findings& findings) {
  TestCase test{"equal seeds gave equal runs", "", "", "reproducibility"};
  for (const Disagreement& disagreement : findings.disagreements) {
    test.details += in_words(findings.results, disagreement) + "\n";
  }
  if (!findings.disagreements.empty()) {
    test.failure = in_words(findings.results, findings.disagreements.front());
  }
  return test;
}

}  // namespace

std::string junit_report(const Findings& findings, const std::string& database) {
  const Results& results = findings.results;
  std::vector<TestCase> tests;
  for (const Verdict& verdict : findings.verdicts) {
    tests.push_back(case_of(verdict));
  }
  tests.push_back(every_run_ended(findings, database));
  tests.push_back(seeds_decide(findings));

  std::size_t failures = 0, open = 0;
  for (const TestCase& test : tests) {
    failures += test.failure.empty() || test.open ? 0 : 1;
    open += test.open ? 1 : 0;
  }
  double wall_s = 0.0;
  for (const Run& run : results.runs) {
    wall_s += run.wall_s.value_or(0.0);
  }
  const std::string counts = " tests=\"" + std::to_string(tests.size()) + "\" failures=\"" +
                             std::to_string(failures) + "\" errors=\"0\"";
  const std::string time = " time=\"" + fixed_text(wall_s, 3) + "\"";
  const std::string suite = escaped_attribute(results.experiment);
  std::string stamp = results.created;  // ISO 8601 without a zone, as JUnit's readers expect
  if (!stamp.empty() && stamp.back() == 'Z') {
    stamp.pop_back();
  }

  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"elsie\"" +
                    counts + time + ">\n  <testsuite name=\"" + suite + "\"" + counts +
                    " skipped=\"" + std::to_string(open) + "\"" + time + " timestamp=\"" +
                    escaped_attribute(stamp) + "\">\n    <properties>\n";
  const std::vector<std::pair<std::string, std::string>> properties = {
      {"database", database},
      {"experiment file", results.file},
      {"fingerprint", results.fingerprint},
      {"elsie version", results.elsie_version},
      {"runs", std::to_string(findings.runs())},
      {"successful runs", successes_in_words(findings)}};
  for (const auto& [name, value] : properties) {
    xml += "      <property name=\"" + name + "\" value=\"" + escaped_attribute(value) + "\"/>\n";
  }
  xml += "    </properties>\n";
  for (const TestCase& test : tests) {
    // The checks that every experiment has get their own class, because an expectation may have the
    // same name.
    xml += "    <testcase classname=\"" + suite + (test.of_expectation ? "" : " (runs)") +
           "\" name=\"" + escaped_attribute(test.name) + "\" time=\"0\"";
    if (test.failure.empty() && test.details.empty()) {
      xml += "/>\n";
      continue;
    }
    xml += ">\n";
    if (test.open) {
      xml += "      <skipped message=\"" + escaped_attribute("not known yet: " + test.failure) +
             "\"/>\n";
    } else if (!test.failure.empty()) {
      xml += "      <failure message=\"" + escaped_attribute(test.failure) + "\" type=\"" +
             test.kind + "\">" + escaped(test.details.empty() ? test.failure : test.details) +
             "</failure>\n";
    } else {
      xml += "      <system-out>" + escaped(test.details) + "</system-out>\n";
    }
    xml += "    </testcase>\n";
  }
  return xml + "  </testsuite>\n</testsuites>\n";
}

}  // namespace elsie::report
