// Messages for wrong command lines.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class Error;
}  // namespace CLI

namespace elsie::program {

/// Checks that the first argument is a subcommand or an option, and that options exist. Throws
/// BadInput with the nearest word.
void check_words(const CLI::App& program, int argc, char** argv);

/// A sentence for an error of the command line's parser.
std::string usage_message(const CLI::App* command, const CLI::Error& error);

}  // namespace elsie::program
