// The program's subcommands and options from their declarations, for the manual page and the
// shells' completion.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace elsie::program {

/// An option, or a positional argument.
struct OptionFacts {
  std::vector<std::string> names;  // "--seed", "-s"; for a positional argument its name
  std::string value;               // name of its value; "" for a flag
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

/// All subcommands in the help, in its order.
std::vector<CommandFacts> commands_of(const CLI::App& program);

}  // namespace elsie::program
