#include "page.h"

#include <string_view>

#include "elsie/report/report.h"
#include "elsie/results/hash.h"

#include "markup.h"
#include "numbers.h"

namespace elsie::report {

std::string command(const PageContext& page, const Run& run) {
  return "<code class=\"command\">" + escaped(replay_command(page.database, run.id)) + "</code>";
}

std::string ending_tag(const Run& run) {
  if (run.broken()) {
    return "<em class=\"tag bad\">" + std::string(to_string(run.state)) + "</em>";
  }
  if (!run.ended()) {
    return "<em class=\"tag\">to do</em>";
  }
  switch (run.outcome.value_or(Outcome::failure)) {
    case Outcome::success:
      return "success";
    case Outcome::time_limit:
      return "<em class=\"tag bad\">time limit</em>";
    default:
      return "<em class=\"tag bad\">failure</em>";
  }
}

std::string anchor(std::size_t cell) { return "cell-" + std::to_string(cell + 1); }

namespace {

// "sha256-...", in base64: the policy's word for a script that may run.
std::string policy_hash(const std::string& script) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::string hex = results::sha256(script);
  std::string text = "sha256-";
  unsigned bits = 0, count = 0;
  for (std::size_t i = 0; i < hex.size(); i += 2) {
    bits = (bits << 8U) | static_cast<unsigned>(std::stoi(hex.substr(i, 2), nullptr, 16));
    for (count += 8; count >= 6; count -= 6) {
      text += kDigits[(bits >> (count - 6)) & 63U];
    }
  }
  if (count > 0) {
    text += kDigits[(bits << (6 - count)) & 63U];
  }
  while (text.size() % 4 != 3) {
    text += '=';
  }
  return text;
}

}  // namespace

std::string html_report(const Findings& findings, const ResultsFile& file,
                        const std::string& database) {
  Inks inks = choose_inks(findings);
  add_behaviors(file, findings, inks);
  const PageContext page{findings, file, database, inks};
  const std::string title = escaped(findings.results.experiment);
  const std::string script = "\n" + std::string(kPageScript);
  // The policy has the browser refuse whatever a label could try to slip in, and all of the
  // network.
  return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
         "'unsafe-inline'; script-src '" +
         policy_hash(script) +
         "'; img-src data:; base-uri 'none'; form-action 'none'\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<meta name=\"color-scheme\" content=\"light dark\">\n"
         "<meta name=\"generator\" content=\"elsie report\">\n"
         "<link rel=\"icon\" href=\"data:,\">\n<title>" +
         title + " \xe2\x80\x93 elsie report</title>\n<style>\n" + kPageStyle +
         "</style>\n</head>\n<body>\n<main>\n" + answer_section(page) + comparison_sections(page) +
         cell_sections(page) + methods_section(page) + "</main>\n<script>" + script +
         "</script>\n</body>\n</html>\n";
}

}  // namespace elsie::report
