#include "usage.h"

#include <algorithm>
#include <regex>
#include <vector>

#include <CLI/CLI.hpp>

#include "elsie/base/near_name.h"
#include "elsie/base/words.h"

#include "command.h"

namespace elsie::program {

namespace {

const CLI::App& subcommand_of(const CLI::App& program, const std::vector<std::string>& not_built,
                              const std::string& word) {
  std::vector<std::string> names = not_built;
  std::string list;
  for (const CLI::App* command : program.get_subcommands({})) {
    if (command->get_name() == word) {
      return *command;
    }
    names.push_back(command->get_name());
    list += (list.empty() ? "" : ", ") + command->get_name();
  }
  throw BadInput("there is no subcommand '" + word + "'" + base::did_you_mean(word, names) +
                 "\nthere are: " + list +
                 (not_built.empty() ? "" : "; not built: " + base::joined(not_built)));
}

}  // namespace

void check_words(const CLI::App& program, const std::vector<std::string>& not_built, int argc,
                 char** argv) {
  if (argc < 2 || argv[1][0] == '-') {
    return;
  }
  const CLI::App& command = subcommand_of(program, not_built, argv[1]);
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      names.push_back("--" + name);
    }
  }
  for (int i = 2; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--") {
      return;
    }
    const std::string name = word.substr(0, word.find('='));
    if (word.starts_with("--") && std::find(names.begin(), names.end(), name) == names.end()) {
      throw BadInput("`elsie " + command.get_name() + "` has no option '" + name + "'" +
                     base::did_you_mean(name, names) + "\n`elsie " + command.get_name() +
                     " --help` lists them");
    }
  }
}

std::string usage_message(const CLI::App* command, const CLI::Error& error) {
  std::string message = error.what();
  std::smatch found;
  if (std::regex_match(message, found,
                       std::regex("(.*): At Most (\\d+) required but received (\\d+)"))) {
    message = found.str(1) + " is given " + found.str(3) + " times; it may be given once";
  } else if (std::regex_match(message, found, std::regex("(.*): 1 required (.*) missing"))) {
    message = found.str(1) + " takes a value, which is missing";
  } else if (std::regex_match(message, found, std::regex("Could not convert: (\\S+) = (.*)"))) {
    message = found.str(1) + ": '" + found.str(2) + "' is not a number of the kind that it takes";
  } else if (std::regex_match(message, found, std::regex("(\\S+) is required"))) {
    message = found.str(1) + " is missing";
  } else if (std::regex_match(message, found,
                              std::regex("(.*): Value (.*) not in range (\\S+) to (\\S+)"))) {
    message = found.str(1) + ": '" + found.str(2) + "' is not a whole number from " + found.str(3) +
              " to " + found.str(4);
  } else if (message == "A subcommand is required") {
    message = "a subcommand is missing";
  } else if (std::regex_match(
                 message, found,
                 std::regex("The following arguments? (was|were) not expected: (.*)"))) {
    message = "nothing is expected where '" + found.str(2) + "' is";
  }
  std::string name = command->get_name();
  for (const CLI::App* chosen : command->get_subcommands()) {
    name += " " + chosen->get_name();
  }
  return "elsie: " + message + "\nRun `" + name + " --help` for more information.\n";
}

}  // namespace elsie::program
