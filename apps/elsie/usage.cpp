#include "usage.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "elsie/base/near_name.h"

#include "command.h"

namespace elsie::program {

namespace {

const CLI::App& subcommand_of(const CLI::App& program, const std::string& word) {
  std::vector<std::string> names;
  std::string list;
  for (const CLI::App* command : program.get_subcommands({})) {
    if (command->get_name() == word) {
      return *command;
    }
    if (!command->get_group().empty()) {  // `elsie session`, which windows start, is not listed
      names.push_back(command->get_name());
      list += (list.empty() ? "" : ", ") + command->get_name();
    }
  }
  throw BadInput("there is no subcommand '" + word + "'" + base::did_you_mean(word, names) +
                 "\nthere are: " + list);
}

/// Splits a text at these words, of which it must begin with the first and end with the last.
/// Returns what is between them, or nothing.
std::vector<std::string> values_between(std::string_view text,
                                        const std::vector<std::string_view>& words) {
  if (!text.starts_with(words.front()) || !text.ends_with(words.back())) {
    return {};
  }
  text.remove_prefix(words.front().size());
  std::vector<std::string> values;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::size_t at = i + 1 < words.size() ? text.find(words[i]) : text.rfind(words[i]);
    if (at == std::string_view::npos) {
      return {};
    }
    values.emplace_back(text.substr(0, at));
    text.remove_prefix(at + words[i].size());
  }
  return values;
}

}  // namespace

void check_words(const CLI::App& program, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') {
    return;
  }
  const std::string subcommand = argv[1];
  const CLI::App& command = subcommand_of(program, subcommand);
  if (command.get_prefix_command()) return;  // the words are for another program
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
  std::vector<std::string> found;
  const auto has = [&](const std::vector<std::string_view>& words) {
    found = values_between(message, words);
    return !found.empty();
  };
  if (message == "A subcommand is required") {
    message = "a subcommand is missing";
  } else if (has({"The following argument was not expected: ", ""}) ||
             has({"The following arguments were not expected: ", ""})) {
    message = "nothing is expected where '" + found[0] + "' is";
  } else if (has({"Could not convert: ", " = ", ""})) {
    message = found[0] + ": '" + found[1] + "' is not a number of the kind that it takes";
  } else if (has({"", ": At Most ", " required but received ", ""})) {
    message = found[0] + " is given " + found[2] + " times; it may be given once";
  } else if (has({"", ": 1 required ", " missing"})) {
    message = found[0] + " takes a value, which is missing";
  } else if (has({"", " is required"})) {
    message = found[0] + " is missing";
  }
  std::string name = command->get_name();
  for (const CLI::App* chosen : command->get_subcommands()) {
    name += " " + chosen->get_name();
  }
  return "elsie: " + message + "\nRun `" + name + " --help` for more information.\n";
}

}  // namespace elsie::program
