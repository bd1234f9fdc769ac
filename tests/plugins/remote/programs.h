// Small programs for robots to ask, written for the shell.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "elsie/testing/behavior.h"

#include "folder.h"

namespace elsie::test {

using Json = nlohmann::json;

/// A program that does this for each line with a time; `line` has the line. It answers {} to others
/// until it is told the end.
inline std::string program(const std::string& at_each_time) {
  return "while read -r line; do case $line in *'\"time\":'*) " + at_each_time +
         ";; *'\"end\"'*) ;; *) echo '{}';; esac; done";
}
/// A program that answers this.
inline std::string answering(const std::string& answer) {
  return program("printf '%s\\n' '" + answer + "'");
}
/// The same, which also writes what it reads to this file.
inline std::string noting(const std::string& file, const std::string& answer = "{}") {
  return "while read -r line; do printf '%s\\n' \"$line\" >> '" + file +
         "'; case $line in *'\"time\":'*) printf '%s\\n' '" + answer +
         "';; *'\"end\"'*) ;; *) echo '{}';; esac; done";
}

/// The objects in the lines of a text.
inline std::vector<Json> lines_of(const std::string& text) {
  std::vector<Json> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(Json::parse(line));
  return lines;
}

/// A behaviour that asks this program.
class Remote : public testing::Behavior {
 public:
  explicit Remote(const std::string& command, double timeout_s = 20.0)
      : testing::Behavior("remote", {{"command", command}, {"timeout", timeout_s}}) {}
};

/// Its answer to nothing in particular.
inline Response answer_of(const std::string& command) {
  return Remote(command).respond(testing::Situation());
}

/// What is wrong with a program; empty: nothing.
inline std::string fault_of(const std::string& command, double timeout_s = 20.0) {
  try {
    Remote(command, timeout_s).respond(testing::Situation());
    return {};
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace elsie::test
