// elsie new: makes a folder with a new plugin, its test, and a world that uses it.
#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <CLI/CLI.hpp>

#include "elsie/base/read_whole.h"
#include "elsie/files/scratch_folder.h"
#include "elsie/files/write_whole.h"
#include "elsie/plugin/kind_name.h"
#include "elsie/simulation/measures.h"

#include "command.h"
#include "environment.h"
#include "streams.h"

namespace elsie::program {

namespace {

namespace fs = std::filesystem;
using elsie::PluginKind;

struct NewOptions {
  std::string kind;
  std::string name;
  std::string folder;
  bool in_python = false;
  PluginOptions plugins;

  std::string suffix() const { return in_python ? ".py" : ".cpp"; }
};

/// Names that are targets of CMake.
constexpr std::array<std::string_view, 9> kTaken = {
    "all", "clean", "edit_cache", "help", "install", "package", "rebuild_cache", "test", "world"};

/// Names that C++ reserves or, like main, uses, and names that the generated files use.
constexpr std::string_view kWords[] = {"active",       "alignas",
                                       "alignof",      "and",
                                       "and_eq",       "asm",
                                       "auto",         "bitand",
                                       "bitor",        "bool",
                                       "break",        "case",
                                       "catch",        "char",
                                       "char16_t",     "char32_t",
                                       "char8_t",      "class",
                                       "co_await",     "co_return",
                                       "co_yield",     "commands",
                                       "compl",        "concept",
                                       "const",        "const_cast",
                                       "consteval",    "constexpr",
                                       "constinit",    "continue",
                                       "decltype",     "default",
                                       "delete",       "do",
                                       "double",       "dynamic_cast",
                                       "else",         "elsie",
                                       "enum",         "explicit",
                                       "export",       "extern",
                                       "false",        "float",
                                       "for",          "friend",
                                       "goto",         "if",
                                       "inline",       "int",
                                       "long",         "main",
                                       "mutable",      "namespace",
                                       "new",          "nobody",
                                       "noexcept",     "not",
                                       "not_eq",       "nullptr",
                                       "operator",     "or",
                                       "or_eq",        "private",
                                       "protected",    "public",
                                       "register",     "reinterpret_cast",
                                       "requires",     "return",
                                       "seek",         "sees",
                                       "short",        "signed",
                                       "sizeof",       "stands",
                                       "static",       "static_assert",
                                       "static_cast",  "std",
                                       "struct",       "switch",
                                       "team",         "template",
                                       "testing",      "this",
                                       "thread_local", "throw",
                                       "true",         "try",
                                       "typedef",      "typeid",
                                       "typename",     "union",
                                       "unsigned",     "using",
                                       "virtual",      "void",
                                       "volatile",     "wchar_t",
                                       "while",        "xor",
                                       "xor_eq"};

void check_name(const std::string& name, bool in_python) {
  const auto fits = [](char c) { return std::islower(static_cast<unsigned char>(c)) != 0; };
  const bool sound =
      !name.empty() && fits(name.front()) && std::all_of(name.begin(), name.end(), [&](char c) {
        return fits(c) || c == '_' || (c >= '0' && c <= '9');
      });
  if (!sound) {
    throw BadInput("'" + name +
                   "' is not a name for a plugin; it should be a small letter followed by small "
                   "letters, digits and underscores, such as 'follow_wall'");
  }
  if (in_python) {
    if (name == "elsie" || name == "none" || name == "true" || name == "false") {
      throw BadInput("'" + name + "' or its class is a word that the generated files use; choose " +
                     "another name");
    }
    return;
  }
  if (std::find(kTaken.begin(), kTaken.end(), name) != kTaken.end()) {
    throw BadInput("'" + name + "' is a word of the build system; choose another name");
  }
  if (std::find(std::begin(kWords), std::end(kWords), name) != std::end(kWords)) {
    throw BadInput("'" + name +
                   "' is a word of C++ or one that the generated files use; choose another name");
  }
}

void check_free(const NewOptions& options) {
  const auto known = simulation::measures_of_every_run();
  if (options.kind == plugin::kind_name(PluginKind::measure) &&
      std::any_of(known.begin(), known.end(),
                  [&](const Quantity& one) { return one.name == options.name; })) {
    throw BadInput("every run has a value '" + options.name +
                   "' already; choose another name for the measure");
  }
  const plugin::Host host = load_plugins(options.plugins);
  for (const PluginKind kind : plugin::kPluginKinds) {
    if (plugin::kind_name(kind) == options.kind && host.find(kind, options.name)) {
      const std::string file = host.file_of(kind, options.name).string();
      throw BadInput("there is a " + options.kind + " '" + options.name + "' already (" +
                     (file.empty() ? "built in" : file) + "); choose another name");
    }
  }
}

/// "follow_wall" -> "FollowWall".
std::string class_name(const std::string& name) {
  std::string out;
  bool begins = true;
  for (const char c : name) {
    if (c != '_') {
      out += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    }
    begins = c == '_';
  }
  return out;
}

void replace_all(std::string& text, std::string_view from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

std::string filled_in(std::string text, const NewOptions& options) {
  replace_all(text, "@name@", options.name);
  replace_all(text, "@Class@", class_name(options.name));
  replace_all(text, "@kind@", options.kind);
  return text;
}

/// The templates of a kind of plugin; "any": those of all kinds.
fs::path template_folder(const std::string& kind) {
  std::string searched;
  for (const std::string& directory : data_directories()) {
    const fs::path folder = fs::path(directory) / "templates" / kind;
    if (fs::is_directory(folder)) {
      return folder;
    }
    searched += (searched.empty() ? "" : ", ") + directory;
  }
  throw BadInput("there are no templates of plugins in the data directories (" + searched +
                 "); is Elsie installed whole?");
}

constexpr std::string_view kWorld = "world.xml";
constexpr std::uintmax_t kLongestTemplate = 1'000'000;  // bytes

/// Writes all files or none.
void write_project(const NewOptions& options, const fs::path& folder) {
  try {
    const fs::path parent =
        fs::absolute(folder / "").lexically_normal().parent_path().parent_path();
    fs::create_directories(parent);
    files::ScratchFolder scratch(parent);
    const std::string language = options.in_python ? "python/" : "";
    std::vector<fs::path> folders{template_folder(language + "any"),
                                  template_folder(language + options.kind)};
    if (options.in_python) folders.push_back(template_folder(options.kind));  // its world
    for (const fs::path& templates : folders) {
      for (const auto& entry : fs::recursive_directory_iterator(templates)) {
        const std::string place = entry.path().lexically_relative(templates).string();
        if (options.in_python && &templates == &folders.back() && place != kWorld) continue;
        const fs::path made = scratch.path() / filled_in(place, options);
        if (entry.is_directory()) {
          fs::create_directories(made);
          continue;
        }
        std::string text;
        try {
          text = base::read_whole(entry.path(), kLongestTemplate);
        } catch (const std::runtime_error& why) {
          throw BadInput("the template '" + entry.path().string() + "' " + why.what());
        }
        files::write_whole_or_throw(made, filled_in(text, options));
      }
    }
    scratch.become(folder);
  } catch (const fs::filesystem_error& error) {
    throw BadInput("the folder '" + folder.string() +
                   "' cannot be made: " + error.code().message());
  }
}

int make_project(const NewOptions& options) {
  check_name(options.name, options.in_python);
  const fs::path folder = options.folder.empty() ? options.name : options.folder;
  std::error_code error;
  if (fs::exists(folder, error)) {
    throw BadInput("'" + folder.string() + "' exists already; choose another name, or --folder");
  }
  check_free(options);
  write_project(options, folder);
  out() << "A new " << options.kind << " in " << folder.string() << ":\n";
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) {
    out() << "  " << name << '\n';
  }
  out() << "Try it:\n  cd " << folder.string() << "\n  elsie run world.xml --plugin "
        << options.name << options.suffix() << '\n';
  return kSuccess;
}

}  // namespace

void add_new_command(CLI::App& program, Job& job) {
  CLI::App* command = program.add_subcommand(
      "new", "Make a folder with a new plugin, its test, and a world that uses it");
  command->footer(
      "\nExamples:\n  elsie new behavior circle_around\n"
      "  elsie new coordinator my_arbiter --folder plugins/my_arbiter\n"
      "  elsie new sensor light\n  elsie new measure detour\n  elsie new rule gate\n  elsie new "
      "drive tracks\n"
      "  elsie new localisation landmarks\n"
      "  elsie new actuator beeper\n  elsie new behavior orbit --python\n");
  auto options = std::make_shared<NewOptions>();
  command
      ->add_option("KIND", options->kind,
                   "behavior, coordinator, sensor, measure, rule, drive, localisation or actuator")
      ->required();
  command->add_option("NAME", options->name, "Its name: small letters, digits, underscores")
      ->required();
  command->add_option("--folder", options->folder, "Where to put it; default: NAME, here")
      ->type_name("DIR");
  command->add_flag("--python", options->in_python, "In Python: one file, which is not compiled");
  options->plugins.add_to(*command);
  command->callback([&job, options] {
    job = [options] {
      if (options->kind == "behaviour") {
        options->kind = "behavior";
      }
      const auto& kinds = plugin::kPluginKinds;
      if (std::none_of(kinds.begin(), kinds.end(),
                       [&](PluginKind kind) { return options->kind == plugin::kind_name(kind); })) {
        throw BadInput("'" + options->kind +
                       "' is not a plugin kind; there are behavior, coordinator, sensor, measure, "
                       "rule, drive, localisation and actuator");
      }
      if (options->in_python && (options->kind == "drive" || options->kind == "localisation")) {
        throw BadInput("--python: a " + options->kind +
                       " must be written in C++; behaviors, coordinators, sensors, measures, rules "
                       "and actuators may be in Python");
      }
      return make_project(*options);
    };
  });
}

}  // namespace elsie::program
