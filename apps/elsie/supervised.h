// The program under its supervisor (apps/supervisor): announces its exit code, and keeps plugins'
// output apart from its answers.
#pragma once

#include <iosfwd>
#include <string>

namespace elsie::program {

/// Finds the supervisor's pipe, if there is one, and announces the exit codes of this process on
/// it. Must be called first, before anything is loaded.
void meet_supervisor();

/// The stream for the program's answers in words: the original standard output. It cleans them by
/// output::clean(), because names and messages may come from files of any origin. Plugins that
/// print write to standard error instead, so that their output does not mix with a table or JSON
/// object. See keep_output().
std::ostream& out();
/// The same for programs: JSON, XML. Nothing is changed.
std::ostream& data_out();
/// Standard error, cleaned likewise.
std::ostream& err();
/// The descriptor of out(), for signal handlers and terminal queries.
int out_descriptor();

/// Keeps standard output for out(), and redirects its number to standard error. Changes `arguments`
/// that name standard output as a file (/dev/stdout) accordingly. Must be called once, before
/// plugins are loaded.
void keep_output(int count, char** arguments);

/// The path of the program that the user started, which is the supervisor's.
const std::string& program_path();
/// Must be called with argv[0] before plugins are loaded.
void set_program_path(const char* first_argument);

}  // namespace elsie::program
