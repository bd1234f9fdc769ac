// The program's answers, kept apart from what plugins print.
#pragma once

#include <iosfwd>
#include <string>

namespace elsie::program {

/// The stream for the program's answers in words: the original standard output. It cleans them by
/// files::clean(), because names and messages may come from files of any origin. Plugins that
/// print write to standard error instead, so that their output does not mix with a table or JSON
/// object. See keep_output().
std::ostream& out();
/// The same for programs: JSON, XML. Nothing is changed.
std::ostream& data_out();
/// Standard error, cleaned likewise.
std::ostream& err();
/// The descriptor of out(), for terminal queries.
int out_descriptor();

/// Keeps standard output for out(), and redirects its number to standard error. Changes `arguments`
/// that name standard output as a file (/dev/stdout) accordingly. Must be called once, before
/// plugins are loaded.
void keep_output(int count, char** arguments);

/// Undoes that, for a program that takes this one's place.
void give_output_back();

/// The file of this program.
std::string program_path();

}  // namespace elsie::program
