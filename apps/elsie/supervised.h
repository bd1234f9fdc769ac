// The program under its supervisor (apps/supervisor): how it tells its exit code, and where its
// answers go.
#pragma once

#include <iosfwd>
#include <string>

namespace elsie::program {

/// Finds the supervisor's pipe, if there is one, and has the exit codes of this process announced
/// on it. First of all, before anything is loaded.
void meet_supervisor();

/// Where the program's answers go: standard output as it was when the program began. Plugins that
/// print write to standard error instead, so that a table or a JSON object that another program
/// reads is not mixed with what they print. See keep_output().
std::ostream& out();
/// The descriptor of out(), for handlers of signals and questions about the terminal.
int out_descriptor();

/// Keeps standard output for out(), and gives its number to standard error. `arguments` that name
/// standard output as a file (/dev/stdout) are changed to name what was kept. Once, before plugins
/// are loaded.
void keep_output(int count, char** arguments);

/// The path of the program that a user starts, which is the supervisor's.
const std::string& program_path();
/// Before plugins are loaded: argv[0].
void set_program_path(const char* first_argument);

}  // namespace elsie::program
