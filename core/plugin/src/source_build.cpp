#include "elsie/plugin/source_build.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>

#include <unistd.h>

#include "elsie/plugin/abi_word.h"
#include "elsie/plugin/own_library.h"
#include "elsie/plugin/process.h"

namespace elsie::plugin {
namespace {

namespace fs = std::filesystem;

/// FNV-1a, 64 bits: to tell contents apart, not to guard them.
class Hash {
 public:
  Hash& add(std::string_view bytes) {
    for (const char c : bytes) {
      value_ = (value_ ^ static_cast<unsigned char>(c)) * 1099511628211u;
    }
    value_ = (value_ ^ 0xffu) * 1099511628211u;  // "ab", "c" is not "a", "bc"
    return *this;
  }
  std::string text() const {
    std::ostringstream out;
    out << std::hex << value_;
    return out.str();
  }

 private:
  std::uint64_t value_ = 14695981039346656037u;
};

std::optional<std::string> content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    return std::nullopt;
  }
  return std::string{std::istreambuf_iterator<char>(in), {}};
}

/// Of a program or library: enough to see that it was replaced.
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

/// The folder that has elsie/api/: beside the library when installed, or when in the build folder.
fs::path headers_of(const fs::path& library) {
  const fs::path folder = library.parent_path().parent_path() / "include";
  if (!fs::exists(folder / "elsie" / "api" / "behavior.h")) {
    throw PluginError("there are no headers of Elsie in " + folder.string() +
                      ", so that no plugin can be compiled; install them");
  }
  return folder;
}

/// The compiler and everything on its command line but the names of source and output.
class Compiler {
 public:
  Compiler() : words_(words_of(std::getenv("CXX"))) {
    if (words_.empty()) {
      words_ = {"c++"};
    }
    const auto program = in_path(words_.front());
    if (!program) {
      throw PluginError("there is no compiler '" + words_.front() +
                        "' to compile a plugin with; install g++ (on Debian: apt install g++), or "
                        "name another one in the environment variable CXX");
    }
    library_ = fs::canonical(file_of_this_library());
    const auto add = [this](std::initializer_list<const char*> words) {
      words_.insert(words_.end(), words.begin(), words.end());
    };
    add({"-std=c++20", "-O2", "-g", "-fPIC", "-shared", "-fvisibility=hidden",
         "-fvisibility-inlines-hidden", "-ffp-contract=off", "-Wall", "-Wextra"});
    if (isatty(STDERR_FILENO)) {
      add({"-fdiagnostics-color=always"});
    }
    words_.push_back("-I" + headers_of(library_).string());
    for (const std::string& word : words_of(std::getenv("CXXFLAGS"))) {
      words_.push_back(word);
    }
    if (host_abi_word().find("sanitizer=address") != std::string_view::npos) {
      add({"-fsanitize=address,undefined"});
    } else {
      add({"-Wl,--no-undefined"});
    }
    stamp_ = stamp_of(*program) + '\n' + stamp_of(library_);
  }

  /// The same text for the same result from the same source.
  std::string identity() const {
    std::string text = stamp_;
    for (const std::string& word : words_) {
      text += '\n' + word;
    }
    return text;
  }

  /// Throws BuildError.
  void compile(const fs::path& source, const fs::path& output, const fs::path& dependencies,
               const std::stop_token& stop) const {
    std::vector<std::string> command = words_;
    const auto version = run_process({words_.front(), "--version"});
    if (version && version->output.find("clang") == std::string::npos) {
      // An inline static of a template would keep the library in memory for ever.
      command.push_back("-fno-gnu-unique");
    }
    for (const std::string& word :
         {std::string("-MMD"), std::string("-MF"), dependencies.string(), std::string("-o"),
          output.string(), source.string(), library_.string()}) {
      command.push_back(word);
    }
    const auto result = run_process(command, stop);
    if (!result) {
      throw PluginError("the compiler '" + words_.front() + "' could not be started");
    }
    if (result->exit_code != 0) {
      throw BuildError(result->output + source.string() + " could not be compiled (" +
                       words_.front() + " ended with " + std::to_string(result->exit_code) +
                       "); mend what it says above and try again");
    }
  }

 private:
  std::vector<std::string> words_;
  fs::path library_;
  std::string stamp_;
};

/// The prerequisites of a rule in make's language, as compilers write it.
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

/// Scratch files are "new.", the process that writes them, and a suffix.
constexpr std::string_view kScratch = "new.";

/// Whether the process that wrote a scratch file is gone.
bool is_left_behind(const std::string& name) {
  pid_t process = 0;
  const char* const number = name.data() + std::min(kScratch.size(), name.size());
  const auto read = std::from_chars(number, name.data() + name.size(), process);
  return name.starts_with(kScratch) && read.ec == std::errc() && process > 0 &&
         kill(process, 0) != 0 && errno == ESRCH;
}

/// The files of a folder of the cache, the last used first. None when there is anything else in it:
/// then it is not the cache's.
std::vector<fs::path> cached_files(const fs::path& folder) {
  std::vector<std::pair<fs::file_time_type, fs::path>> found;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    const bool known =
        name == "inputs" || name.starts_with(kScratch) || at->path().extension() == ".so";
    if (!known || !at->is_regular_file(error)) {
      return {};
    }
    found.emplace_back(at->last_write_time(error), at->path());
  }
  std::sort(found.rbegin(), found.rend());
  std::vector<fs::path> files;
  for (auto& [time, file] : found) {
    files.push_back(std::move(file));
  }
  return files;
}

/// Removes what nobody has asked for in a long time. What is in use elsewhere stays in memory.
void sweep(const fs::path& cache) {
  const auto limit = fs::file_time_type::clock::now() - std::chrono::hours(24 * kCacheDays);
  std::error_code error;
  std::vector<fs::path> folders;
  for (fs::directory_iterator at(cache, error), end; !error && at != end; at.increment(error)) {
    if (fs::exists(at->path() / "inputs", error) &&
        fs::last_write_time(at->path() / "inputs", error) < limit) {
      folders.push_back(at->path());
    }
  }
  for (const fs::path& folder : folders) {
    for (const fs::path& file : cached_files(folder)) {
      fs::remove(file, error);
    }
    fs::remove(folder, error);  // if nothing is left
  }
}

/// What one source was compiled to last, and from which contents.
class CacheEntry {
 public:
  CacheEntry(const fs::path& source, const Compiler& compiler, const fs::path& cache)
      : cache_(cache),
        folder_(cache / (source.stem().string() + '-' +
                         Hash().add(source.string()).add(compiler.identity()).text())),
        stem_(source.stem().string()) {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) {
      throw PluginError("the folder " + folder_.string() +
                        " for compiled plugins cannot be made: " + error.message() +
                        "; name another one in the environment variable ELSIE_CACHE");
    }
  }

  /// The library, if nothing changed since.
  std::optional<SourceBuild> find() const {
    std::ifstream record(folder_ / "inputs");
    SourceBuild build;
    build.from_cache = true;
    std::string name;
    if (!std::getline(record, name)) {
      return std::nullopt;
    }
    build.library = folder_ / name;
    for (std::string hash, file; record >> hash && std::getline(record >> std::ws, file);) {
      const auto content = content_of(file);
      if (!content || Hash().add(*content).text() != hash) {
        return std::nullopt;
      }
      build.inputs.emplace_back(file);
    }
    if (!fs::exists(build.library)) {
      return std::nullopt;
    }
    std::error_code ignored;  // in a cache that is only read
    const auto now = fs::file_time_type::clock::now();
    fs::last_write_time(folder_ / "inputs", now, ignored);
    return build;
  }

  /// Where the compiler may write; another one for each process.
  fs::path scratch(const char* suffix) const {
    return folder_ / (std::string(kScratch) + std::to_string(getpid()) + suffix);
  }

  /// Takes over what the compiler wrote.
  SourceBuild keep(const fs::path& library, std::vector<fs::path> inputs) const {
    Hash all;
    std::string record;
    for (const fs::path& file : inputs) {
      const std::string hash = Hash().add(content_of(file).value_or("")).text();
      all.add(hash);
      record += hash + ' ' + file.string() + '\n';
    }
    const std::string name = stem_ + '-' + all.text() + ".so";
    const fs::path text = scratch(".inputs");
    std::ofstream(text) << name << '\n' << record;
    fs::rename(library, folder_ / name);
    fs::rename(text, folder_ / "inputs");
    tidy(folder_ / name);
    return {folder_ / name, std::move(inputs), false};
  }

 private:
  /// Removes the libraries that are too many, and what compilers left that were killed.
  void tidy(const fs::path& newest) const {
    std::size_t libraries = 1;
    std::error_code ignored;
    for (const fs::path& file : cached_files(folder_)) {
      const std::string name = file.filename().string();
      const bool is_scratch = name.starts_with(kScratch);
      if (is_scratch ? is_left_behind(name)
                     : file.extension() == ".so" && file != newest && ++libraries > kMostBuilds) {
        fs::remove(file, ignored);
      }
    }
    sweep(cache_);
  }

  fs::path cache_;
  fs::path folder_;
  std::string stem_;
};

fs::path checked(const fs::path& source) {
  std::error_code error;
  if (!is_source(source)) {
    throw PluginError("'" + source.string() +
                      "' is no C++ source: its name should end in .cpp, .cc or .cxx");
  }
  const fs::path full = fs::canonical(source, error);
  if (error || !fs::is_regular_file(full)) {
    throw PluginError("'" + source.string() + "' " +
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
  const auto variable = [](const char* name) {
    const char* const value = std::getenv(name);
    return fs::path(value ? value : "");
  };
  if (const fs::path own = variable("ELSIE_CACHE"); !own.empty()) {
    return own;
  }
  if (const fs::path user = variable("XDG_CACHE_HOME"); !user.empty()) {
    return user / "elsie";
  }
  if (const fs::path home = variable("HOME"); !home.empty()) {
    return home / ".cache" / "elsie";
  }
  return fs::temp_directory_path() / "elsie";
}

SourceBuild build_source(const fs::path& source, const fs::path& cache, const std::stop_token& stop,
                         const std::function<void()>& begins) {
  const fs::path file = checked(source);
  const Compiler compiler;
  const CacheEntry entry(file, compiler, fs::absolute(cache));
  if (auto found = entry.find()) {
    return *std::move(found);
  }
  if (begins) {
    begins();
  }
  const fs::path library = entry.scratch(".so");
  const fs::path dependencies = entry.scratch(".d");
  try {
    // Under the name that the user gave, which is the one that the messages have.
    compiler.compile(source, library, dependencies, stop);
    std::vector<fs::path> inputs = prerequisites(content_of(dependencies).value_or(""));
    for (fs::path& input : inputs) {
      input = fs::absolute(input);
    }
    fs::remove(dependencies);
    return entry.keep(library, std::move(inputs));
  } catch (...) {
    std::error_code ignored;
    fs::remove(library, ignored);
    fs::remove(dependencies, ignored);
    throw;
  }
}

}  // namespace elsie::plugin
