// Messages for command lines that cannot be understood.
#pragma once

#include <string>

namespace CLI {
class App;
class Error;
}  // namespace CLI

namespace elsie::program {

/// The first argument must be a subcommand or an option, and what looks like an option must be one
/// of the subcommand. Throws BadInput, which says which one was meant.
void check_words(const CLI::App& program, int argc, char** argv);

/// A sentence for what the command line's parser found.
std::string usage_message(const CLI::App* command, const CLI::Error& error);

}  // namespace elsie::program
