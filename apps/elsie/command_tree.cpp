#include "command_tree.h"

#include <sstream>

#include <CLI/CLI.hpp>

namespace elsie::program {

namespace {

/// "FILE.png|FILE.svg" from the option's type; "{a,b}" and the words of checks are for the help
/// only.
std::string value_of(const CLI::Option& option) {
  if (option.get_items_expected_max() == 0) {
    return "";
  }
  const std::string type = option.get_type_name();
  const std::string name = type.substr(0, type.find(':'));
  return name.empty() ? "VALUE" : name;
}

/// "a" and "b" of "TEXT:{a,b}".
std::vector<std::string> choices_of(const CLI::Option& option) {
  std::vector<std::string> choices;
  const std::string type = option.get_type_name();
  const std::size_t open = type.find('{');
  const std::size_t close = type.find('}', open == std::string::npos ? 0 : open);
  if (open == std::string::npos || close == std::string::npos) {
    return choices;
  }
  std::istringstream list(type.substr(open + 1, close - open - 1));
  for (std::string choice; std::getline(list, choice, ',');) {
    choices.push_back(choice.substr(0, choice.find("->")));
  }
  return choices;
}

bool names_file(const std::string& value) {
  for (const char* word : {"FILE", "DIR", "SOURCE", "WORLD", "TRACE", "MODEL", "TEMPLATE"}) {
    if (value.find(word) != std::string::npos) {
      return true;
    }
  }
  return false;
}

OptionFacts facts_of(const CLI::Option& option) {
  OptionFacts facts;
  facts.positional = option.get_positional();
  for (const std::string& name : option.get_snames()) {
    facts.names.push_back("-" + name);
  }
  for (const std::string& name : option.get_lnames()) {
    facts.names.push_back("--" + name);
  }
  if (facts.positional) {
    facts.names = {option.get_name(true)};
  }
  facts.value = value_of(option);
  facts.meaning = option.get_description();
  facts.takes_file = names_file(facts.positional ? facts.names.front() : facts.value);
  facts.choices = choices_of(option);
  return facts;
}

}  // namespace

std::vector<CommandFacts> commands_of(const CLI::App& program) {
  std::vector<CommandFacts> commands;
  for (const CLI::App* command : program.get_subcommands({})) {
    if (command->get_group().empty()) {
      continue;  // hidden
    }
    CommandFacts facts{command->get_name(), command->get_description(), command->get_footer(), {}};
    for (const CLI::Option* option : command->get_options()) {
      facts.options.push_back(facts_of(*option));
    }
    commands.push_back(std::move(facts));
  }
  return commands;
}

}  // namespace elsie::program
