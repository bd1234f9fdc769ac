#include "elsie/build/source_build.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include <unistd.h>

#include "elsie/plugin/abi_word.h"
#include "elsie/plugin/own_library.h"
#include "elsie/process/run_process.h"

#include "build_cache.h"
#include "file_sight.h"

namespace elsie::build {
namespace {

namespace fs = std::filesystem;

/// The number of attempts when a source is saved during compilation.
constexpr int kMostTries = 4;

/// Identifies a program's or library's version.
std::string stamp_of(const fs::path& file) {
  std::error_code error;
  const auto size = fs::file_size(file, error);
  const auto time = fs::last_write_time(file, error);
  return file.string() + ' ' + std::to_string(size) + ' ' +
         std::to_string(time.time_since_epoch().count());
}

std::optional<fs::path> in_path(const std::string& program) {
  if (program.find('/') != std::string::npos) {
    return fs::exists(program) ? std::optional<fs::path>(program) : std::nullopt;
  }
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path file = fs::path(folder) / program;
    if (access(file.c_str(), X_OK) == 0) {
      return fs::canonical(file);
    }
  }
  return std::nullopt;
}

std::vector<std::string> words_of(const char* text) {
  std::istringstream in(text ? text : "");
  return {std::istream_iterator<std::string>(in), {}};
}

/// The file's name as an argument that is no option, as "-o.cpp" would be. Throws BuildError for
/// "@list.cpp", which GCC takes for a file of options in any folder.
std::string operand(const fs::path& file) {
  if (file.filename().string().starts_with('@')) {
    throw BuildError("'" + file.string() +
                     "' cannot be compiled: compilers take a name that begins with '@' for a list "
                     "of options; rename it");
  }
  const std::string name = file.string();
  return name.starts_with('-') ? "./" + name : name;
}

/// The folder with elsie/api/, next to the library, installed or in the build folder.
fs::path headers_of(const fs::path& library) {
  const fs::path folder = library.parent_path().parent_path() / "include";
  if (!fs::exists(folder / "elsie" / "api" / "behavior.h")) {
    throw plugin::PluginError("there are no headers of Elsie in " + folder.string() +
                              ", so that no plugin can be compiled; install them");
  }
  return folder;
}

/// The compiler and its command line without the names of source and output.
class Compiler {
 public:
  Compiler() : words_(words_of(std::getenv("CXX"))) {
    if (words_.empty()) {
      words_ = {"c++"};
    }
    const auto program = in_path(words_.front());
    if (!program) {
      throw plugin::PluginError(
          "there is no compiler '" + words_.front() +
          "' to compile a plugin with; install g++ (on Debian: apt install g++), or "
          "name another one in the environment variable CXX");
    }
    library_ = fs::canonical(plugin::file_of_this_library());
    const auto add = [this](std::initializer_list<const char*> words) {
      words_.insert(words_.end(), words.begin(), words.end());
    };
    add({"-std=c++20", "-O2", "-g1", "-fPIC", "-shared", "-fvisibility=hidden",
         "-fvisibility-inlines-hidden", "-ffp-contract=off", "-Wall", "-Wextra",
         "-Woverloaded-virtual"});
    if (isatty(STDERR_FILENO)) {
      add({"-fdiagnostics-color=always"});
    }
    if (plugin::host_abi_word().find("sanitizer=address") != std::string_view::npos) {
      add({"-fsanitize=address,undefined"});
    } else {
      add({"-Wl,--no-undefined"});
    }
    words_.push_back("-I" + headers_of(library_).string());
    // The user's flags come last and so override ours; libraries come after the source that needs
    // them.
    for (const char* const variable : {"CXXFLAGS", "LDFLAGS", "LDLIBS"}) {
      for (const std::string& word : words_of(std::getenv(variable))) {
        const bool is_library = word.starts_with("-l") || word.ends_with(".a");
        (is_library ? libraries_ : flags_).push_back(word);
      }
    }
    stamp_ = stamp_of(*program) + '\n' + stamp_of(library_) + '\n' + stamp_of(base()) + '\n' +
             stamp_of(inference());
  }

  /// A text that identifies the compiler and its flags.
  std::string identity() const {
    std::string text = stamp_;
    for (const auto* words : {&words_, &flags_, &libraries_}) {
      for (const std::string& word : *words) {
        text += '\n' + word;
      }
    }
    return text;
  }

  /// Returns the compiler's warnings. Throws BuildError.
  std::string compile(const fs::path& source, const fs::path& output, const fs::path& dependencies,
                      const std::stop_token& stop) const {
    // Its messages are in English, so that windows find the lines that they name.
    std::vector<std::string> command{"env", "-u", "LC_ALL", "LC_MESSAGES=C"};
    if (const char* const all = std::getenv("LC_ALL")) {
      command.push_back(std::string("LC_CTYPE=") + all);
    }
    command.insert(command.end(), words_.begin(), words_.end());
    const auto version = process::run_process({words_.front(), "--version"});
    if (version && version->output.find("clang") == std::string::npos) {
      // An inline static of a template would keep the library loaded for ever.
      command.push_back("-fno-gnu-unique");
      command.push_back("-Wsuggest-override");
    }
    command.insert(command.end(), flags_.begin(), flags_.end());
    for (const std::string& word :
         {std::string("-MMD"), std::string("-MF"), dependencies.string(), std::string("-o"),
          output.string(), operand(source), "-Wl,--as-needed,-rpath," + folder().string(),
          library_.string(), base().string(), inference().string()}) {
      command.push_back(word);
    }
    command.insert(command.end(), libraries_.begin(), libraries_.end());
    const auto result = process::run_process(command, stop);
    if (!result) {
      throw plugin::PluginError("the compiler '" + words_.front() + "' could not be started");
    }
    if (result->exit_code != 0) {
      throw BuildError(result->output + source.string() + " could not be compiled (" +
                       words_.front() + " ended with " + std::to_string(result->exit_code) +
                       "); fix the errors above and try again");
    }
    return result->output;
  }

 private:
  fs::path folder() const { return library_.parent_path(); }
  fs::path base() const { return folder() / "libelsie-base.so"; }
  fs::path inference() const { return folder() / "libelsie-inference.so"; }

  std::vector<std::string> words_;      // the compiler and our flags
  std::vector<std::string> flags_;      // the user's
  std::vector<std::string> libraries_;  // the user's
  fs::path library_;
  std::string stamp_;
};

/// The prerequisites of a rule of make, as compilers write it.
std::vector<fs::path> prerequisites(const std::string& rule) {
  std::vector<fs::path> files;
  std::string word;
  const auto end_word = [&] {
    if (!word.empty()) {
      files.emplace_back(word);
    }
    word.clear();
  };
  for (std::size_t i = rule.find(": ") + 1; i < rule.size(); ++i) {
    const char next = i + 1 < rule.size() ? rule[i + 1] : '\0';
    if (rule[i] == '\\' && (next == ' ' || next == '\\' || next == '#')) {
      word += rule[++i];
    } else if (rule[i] == '\\' && next == '\n') {
      ++i;
      end_word();
    } else if (rule[i] == ' ' || rule[i] == '\n') {
      end_word();
    } else {
      word += rule[i];
    }
  }
  end_word();
  return files;
}

fs::path checked(const fs::path& source) {
  std::error_code error;
  if (!is_source(source)) {
    throw plugin::PluginError("'" + source.string() +
                              "' is no C++ source: its name should end in .cpp, .cc or .cxx");
  }
  const fs::path full = fs::canonical(source, error);
  if (error || !fs::is_regular_file(full)) {
    throw plugin::PluginError("'" + source.string() + "' " +
                              (error ? "cannot be read: " + error.message() : "is no file") +
                              "; check the path");
  }
  return full;
}

}  // namespace

bool is_source(const fs::path& file) {
  const fs::path suffix = file.extension();
  return suffix == ".cpp" || suffix == ".cc" || suffix == ".cxx";
}

fs::path cache_directory() {
  if (const char* const own = std::getenv("ELSIE_CACHE"); own && *own) {
    return own;
  }
  // A relative path is invalid (XDG Base Directory Specification): it would name another folder in
  // each working directory.
  const auto absolute = [](const char* name) {
    const char* const value = std::getenv(name);
    return value && fs::path(value).is_absolute() ? fs::path(value) : fs::path();
  };
  if (const fs::path user = absolute("XDG_CACHE_HOME"); !user.empty()) {
    return user / "elsie";
  }
  if (const fs::path home = absolute("HOME"); !home.empty()) {
    return home / ".cache" / "elsie";
  }
  return fs::temp_directory_path() / ("elsie-" + std::to_string(geteuid()));
}

SourceBuild build_source(const fs::path& source, const fs::path& cache, const std::stop_token& stop,
                         const std::function<void()>& begins) {
  const fs::path file = checked(source);
  const Compiler compiler;
  const CacheEntry entry(file, compiler.identity(), fs::absolute(cache));
  if (auto found = entry.find()) {
    return *std::move(found);
  }
  if (begins) {
    begins();
  }
  const fs::path library = entry.scratch(".so");
  const fs::path dependencies = entry.scratch(".d");
  std::vector<fs::path> inputs = entry.last_inputs();
  if (std::find(inputs.begin(), inputs.end(), fs::absolute(source)) == inputs.end()) {
    inputs.push_back(fs::absolute(source));
  }
  try {
    std::optional<fs::path> changed;
    for (int i = 0; i < kMostTries; ++i) {
      const Sight before = look_at(inputs);
      const std::int64_t start_ns = instant_before_now(dependencies);
      std::optional<BuildError> refusal;
      std::string warnings;
      try {
        // By the name that the user gave, so that messages have it.
        warnings = compiler.compile(source, library, dependencies, stop);
        inputs = prerequisites(content_of(dependencies).value_or(""));
        for (fs::path& input : inputs) {
          input = fs::absolute(input);
        }
      } catch (const BuildError& error) {  // the file may have been half written
        refusal = error;
      }
      const Sight after = look_at(inputs);
      changed = changed_file(before, after, start_ns);
      if (refusal && (!changed || stop.stop_requested())) {
        throw *refusal;
      }
      if (!refusal && !changed) {
        fs::remove(dependencies);
        SourceBuild build = entry.keep(library, std::move(inputs), after);
        build.warnings = std::move(warnings);
        return build;
      }
    }
    throw BuildError(source.string() + " was compiled " + std::to_string(kMostTries) +
                     " times, and each time '" + changed->string() +
                     "' was saved meanwhile; try again once nothing writes to it any more");
  } catch (...) {
    std::error_code ignored;
    fs::remove(library, ignored);
    fs::remove(dependencies, ignored);
    throw;
  }
}

}  // namespace elsie::build
