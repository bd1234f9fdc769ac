// elsie manual: the manual page, made from the program's own help.
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

#include "command.h"
#include "command_tree.h"
#include "streams.h"

namespace elsie::program {

namespace {

/// Text in roff, with its special characters escaped.
std::string roff(std::string_view text) {
  std::string out;
  bool line_begins = true;
  for (const char c : text) {
    if (line_begins && (c == '.' || c == '\'')) {
      out += "\\&";
    }
    out += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
    line_begins = c == '\n';
  }
  return out;
}

std::string names_of(const OptionFacts& option) {
  std::string names;
  for (const std::string& name : option.names) {
    names += (names.empty() ? "\\fB" : ", \\fB") + roff(name) + "\\fR";
  }
  return option.value.empty() || option.positional ? names
                                                   : names + " \\fI" + roff(option.value) + "\\fR";
}

void write_synopsis(std::ostream& out, const CommandFacts& command) {
  out << ".B elsie " << roff(command.name) << "\n[options]";
  for (const OptionFacts& option : command.options) {
    if (option.positional) {
      out << " \\fI" << roff(option.names.front()) << "\\fR";
    }
  }
  out << "\n.br\n";
}

void write_command(std::ostream& out, const CommandFacts& command) {
  out << ".SS " << roff(command.name) << '\n' << roff(command.meaning) << ".\n";
  for (const OptionFacts& option : command.options) {
    out << ".TP\n" << names_of(option) << '\n' << roff(option.meaning) << ".\n";
  }
  // Examples and remarks are unchanged from the help.
  out << ".PP\n.nf\n" << roff(command.footer) << "\n.fi\n";
}

void write_manual(std::ostream& out, const CLI::App& program) {
  const auto commands = commands_of(program);
  out << ".TH ELSIE 1 \"\" \"Elsie " ELSIE_VERSION "\" \"User Commands\"\n"
      << ".SH NAME\nelsie \\- behaviour-based mobile robot control\n.SH SYNOPSIS\n";
  for (const CommandFacts& command : commands) {
    write_synopsis(out, command);
  }
  out << ".SH DESCRIPTION\n"
         "A physics\\-based, fixed\\-step simulator in which a robot is driven by several small "
         "behaviours that run side by side, and a coordinator that turns their wishes into one "
         "motor command. Worlds are XML files; sensors, behaviours, coordinators and measures are "
         "shared "
         "libraries that are found at run time.\n"
         ".SH COMMANDS\n";
  for (const CommandFacts& command : commands) {
    write_command(out, command);
  }
  out << ".SH EXIT STATUS\n"
         ".TP\n.B 0\nSuccess.\n"
         ".TP\n.B 1\nThe run ended without reaching its goal.\n"
         ".TP\n.B 2\nBad input or usage.\n"
         ".TP\n.B 3\nA plugin failed.\n"
         ".TP\n.B 4\nAnything else, such as a full disk or an interrupt.\n"
         ".SH ENVIRONMENT\n"
         ".TP\n.B ELSIE_PLUGIN_PATH\nDirectories with plugin libraries, separated by colons.\n"
         ".TP\n.B ELSIE_DATA_PATH\nDirectories in which worlds, robot templates, fuzzy models and "
         "other "
         "data are looked for, separated by colons.\n"
         ".TP\n.B ELSIE_LOG\nThe level of messages on standard error: debug, info, warn (the "
         "default), err, off.\n";
}

}  // namespace

void add_manual_command(CLI::App& program, Job& job) {
  CLI::App* command = program.add_subcommand("manual", "Print the manual page");
  command->footer("\nExample:\n  elsie manual > elsie.1 && man ./elsie.1\n");
  command->callback([&job, &program] {
    job = [&program] {
      write_manual(out(), program);
      return kSuccess;
    };
  });
}

}  // namespace elsie::program
