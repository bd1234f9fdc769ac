// elsie completion: the script with which a shell completes the words of a command line.
#include <iostream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "elsie/base/words.h"
#include "elsie/process/shell_word.h"

#include "command.h"
#include "command_tree.h"
#include "streams.h"

namespace elsie::program {

namespace {

void write_bash_command(std::ostream& out, const CommandFacts& command) {
  std::vector<std::string> words;
  out << "    " << command.name << ")\n      case $previous in\n";
  for (const OptionFacts& option : command.options) {
    if (option.positional) {
      continue;
    }
    words.insert(words.end(), option.names.begin(), option.names.end());
    if (!option.choices.empty()) {
      out << "        " << base::joined(option.names, "|") << ") COMPREPLY=($(compgen -W "
          << process::shell_word(base::joined(option.choices, " "))
          << " -- \"$word\")); return ;;\n";
    } else if (option.takes_file) {
      out << "        " << base::joined(option.names, "|")
          << ") COMPREPLY=($(compgen -f -- \"$word\")); "
          << "return ;;\n";
    } else if (!option.value.empty()) {
      out << "        " << base::joined(option.names, "|") << ") return ;;\n";
    }
  }
  out << "      esac\n      options=" << process::shell_word(base::joined(words, " ")) << " ;;\n";
}

void write_bash(std::ostream& out, const std::vector<CommandFacts>& commands) {
  std::vector<std::string> names;
  for (const CommandFacts& command : commands) {
    names.push_back(command.name);
  }
  out << "# Completion of elsie for bash.\n"
         "_elsie() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} options=\n"
         "  COMPREPLY=()\n"
         "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
         "    COMPREPLY=($(compgen -W "
      << process::shell_word(base::joined(names, " ") + " --help --version")
      << " -- \"$word\"))\n    return\n  fi\n  case ${COMP_WORDS[1]} in\n";
  for (const CommandFacts& command : commands) {
    write_bash_command(out, command);
  }
  out << "  esac\n"
         "  case ${COMP_WORDS[1]} in\n"
         "    describe) [[ $word == -* ]] || {\n"
         "      COMPREPLY=($(compgen -W \"world experiment $(elsie plugins --names 2>/dev/null)\" "
         "-- "
         "\"$word\")); return; } ;;\n"
         "    schema) [[ $word == -* ]] || {\n"
         "      COMPREPLY=($(compgen -W \"world experiment\" -- \"$word\")); return; } ;;\n"
         "  esac\n"
         "  if [[ $word == -* ]]; then\n"
         "    COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))\n"
         "  else\n"
         "    COMPREPLY=($(compgen -f -- \"$word\"))\n"
         "  fi\n"
         "}\n"
         "complete -o filenames -F _elsie elsie\n";
}

/// A description in the square brackets of zsh's _arguments.
std::string bracketed(std::string_view text) {
  std::string out;
  for (const char c : text) {
    out +=
        c == '[' || c == ']' || c == ':' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  }
  return out;
}

void write_zsh_command(std::ostream& out, const CommandFacts& command) {
  out << "    " << command.name << ")\n      _arguments";
  for (const OptionFacts& option : command.options) {
    if (option.positional) {
      out << " \\\n        " << process::shell_word("*:" + option.names.front() + ":_files");
      continue;
    }
    for (const std::string& name : option.names) {
      std::string words = "*" + name + "[" + bracketed(option.meaning) + "]";
      if (!option.choices.empty()) {
        words += ":" + option.value + ":(" + base::joined(option.choices, " ") + ")";
      } else if (!option.value.empty()) {
        words += ":" + bracketed(option.value) + ":" + (option.takes_file ? "_files" : "");
      }
      out << " \\\n        " << process::shell_word(words);
    }
  }
  out << " ;;\n";
}

void write_zsh(std::ostream& out, const std::vector<CommandFacts>& commands) {
  out << "#compdef elsie\n"
         "_elsie() {\n"
         "  local -a commands\n"
         "  commands=(";
  for (const CommandFacts& command : commands) {
    out << "\n    " << process::shell_word(command.name + ":" + command.meaning);
  }
  out << ")\n"
         "  if (( CURRENT == 2 )); then\n    _describe command commands\n    return\n  fi\n"
         "  local command=$words[2]\n  shift words\n  (( CURRENT-- ))\n"
         "  case $command in\n";
  for (const CommandFacts& command : commands) {
    write_zsh_command(out, command);
  }
  out << "  esac\n}\n_elsie \"$@\"\n";
}

}  // namespace

void add_completion_command(CLI::App& program, Job& job) {
  CLI::App* command = program.add_subcommand("completion", "Print completion for a shell");
  command->footer(
      "\nExamples:\n  source <(elsie completion bash)\n"
      "  elsie completion zsh > ~/.zfunc/_elsie\n");
  auto shell = std::make_shared<std::string>();
  command->add_option("SHELL", *shell, "bash or zsh")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh"}));
  command->callback([&job, &program, shell] {
    job = [&program, shell] {
      (*shell == "bash" ? write_bash : write_zsh)(out(), commands_of(program));
      return kSuccess;
    };
  });
}

}  // namespace elsie::program
