// The program's subcommands and options, as its own declaration of them has it: what the manual
// page and the shells' completion are written from.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace elsie::program {

/// An option, or a positional argument.
struct OptionFacts {
  std::vector<std::string> names;  // "--seed", "-s"; a positional argument's name alone
  std::string value;               // what it takes, "" when it is a switch
  std::string meaning;
  bool positional = false;
  bool takes_file = false;  // or a directory
  std::vector<std::string> choices;
};

struct CommandFacts {
  std::string name;
  std::string meaning;
  std::string footer;
  std::vector<OptionFacts> options;
};

/// All subcommands that help lists, in its order.
std::vector<CommandFacts> commands_of(const CLI::App& program);

}  // namespace elsie::program
