#include "elsie/plugin/host.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

#include <sys/stat.h>

#include "elsie/api/registration.h"
#include "elsie/base/near_name.h"
#include "elsie/base/thrown.h"
#include "elsie/base/words.h"
#include "elsie/plugin/abi_word.h"
#include "elsie/plugin/call.h"
#include "elsie/plugin/declaration_check.h"
#include "elsie/plugin/error.h"
#include "elsie/plugin/file_fingerprint.h"
#include "elsie/plugin/inspection.h"
#include "elsie/plugin/kind_name.h"
#include "elsie/plugin/script.h"

#include "library.h"
#include "text.h"

namespace elsie::plugin {
namespace {

namespace fs = std::filesystem;

/// A plugin in use. The declaration refers to the library's code, so it is the later member: it is
/// destroyed first.
struct Entry {
  std::shared_ptr<const Library> library;
  fs::path file;
  Declaration declaration;
};

using EntryRef = std::shared_ptr<const Entry>;
using Registry = std::map<std::pair<PluginKind, std::string>, EntryRef>;

/// A loaded file with all its plugins, including those that others shadow.
struct LoadedFile {
  Fingerprint fingerprint;
  std::string abi_word;
  std::vector<EntryRef> plugins;
};
using LoadedFiles = std::map<fs::path, LoadedFile>;
using FileId = std::pair<dev_t, ino_t>;  // the same whatever the path

/// The plugins that the core registers itself: every host has them before all others.
const std::vector<EntryRef>& built_in() {
  static const std::vector<EntryRef> entries = [] {
    std::vector<Declaration> declarations;
    elsie::detail::declare_plugins(declarations);
    std::vector<EntryRef> made;
    for (Declaration& declaration : declarations) {
      made.push_back(std::make_shared<const Entry>(Entry{nullptr, {}, std::move(declaration)}));
    }
    return made;
  }();
  return entries;
}

}  // namespace

struct Host::State {
  Registry registry;
  std::map<FileId, fs::path> seen;  // directories and libraries
  LoadedFiles loaded;
  std::map<fs::path, fs::path> sources;  // of libraries that were compiled from one file
  Report report;
  MakeCopy copy;
  const State* before = nullptr;  // only while a host is renewed

  const Entry* entry(PluginKind kind, std::string_view name) const {
    const auto at = registry.find({kind, std::string(name)});
    return at == registry.end() ? nullptr : at->second.get();
  }
  void add(const EntryRef& entry) {
    registry.emplace(std::pair(entry->declaration.kind, entry->declaration.name), entry);
  }

  /// The file that the user knows of a library: its source, if it was compiled from one.
  const fs::path& known_as(const fs::path& file) const {
    const auto source = sources.find(file);
    return source == sources.end() ? file : source->second;
  }
  void search(std::vector<SearchDirectory> all);
  std::string list(const SearchDirectory& directory, std::vector<fs::path>& files);
  FileReport examine(const fs::path& file);
  void load(FileReport& file);
  bool inspect(FileReport& file) const;
  std::optional<LoadedFile> load_anew(FileReport& file);
  LoadedFiles former() const;
  void keep(const LoadedFiles::value_type& old, FileReport& file);
  void enter(LoadedFile found, FileReport& file);
};

/// Lists the directory's files in the order of their names, or the entry itself if it is a library.
/// Returns a sentence if it cannot or should not be listed.
std::string Host::State::list(const SearchDirectory& directory, std::vector<fs::path>& files) {
  struct stat status {};
  if (stat(directory.path.c_str(), &status) != 0) {
    return errno == ENOENT ? "does not exist"
                           : "cannot be read: " + std::generic_category().message(errno);
  }
  if (S_ISREG(status.st_mode) && may_hold_plugins(directory.path)) {
    files.push_back(directory.path);
    return "";
  }
  if (!S_ISDIR(status.st_mode)) return "is not a directory";
  const auto [known, is_new] = seen.try_emplace({status.st_dev, status.st_ino}, directory.path);
  if (!is_new) return "is the same directory as " + known->second.string();
  std::error_code error;
  for (fs::directory_iterator at(directory.path, error), end; !error && at != end;
       at.increment(error)) {
    files.push_back(at->path());
  }
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return a.filename().native() < b.filename().native();
  });
  return error ? "cannot be read: " + error.message() : "";
}

/// The libraries that the previous host had loaded from the next place of the search path.
LoadedFiles Host::State::former() const {
  LoadedFiles former;
  const std::size_t place = report.directories.size();
  if (!before || place >= before->report.directories.size()) return former;
  for (const FileReport& old : before->report.directories[place].files) {
    const auto known = before->loaded.find(old.path);
    if (known != before->loaded.end()) former.insert(*known);
  }
  return former;
}

/// Keeps an old library in use, because its file is gone or cannot be used; `file` says why.
void Host::State::keep(const LoadedFiles::value_type& old, FileReport& file) {
  report.warnings.push_back(known_as(old.first).string() + ": " + file.sentence +
                            "; the library that was there before is still in use");
  file = {};
  file.path = old.first;
  file.abi_word = old.second.abi_word;
  file.is_former = true;
  enter(old.second, file);
}

void Host::State::search(std::vector<SearchDirectory> all) {
  for (SearchDirectory& directory : all) {
    if (!directory.source.empty()) {
      sources.insert_or_assign(directory.path, directory.source);
    }
    const bool is_library = may_hold_plugins(directory.path);  // a new path for each build
    LoadedFiles former = this->former();
    DirectoryReport found{std::move(directory), "", {}};
    std::vector<fs::path> files;
    found.problem = list(found.directory, files);
    for (const fs::path& path : files) {
      FileReport& file = found.files.emplace_back(examine(path));
      const auto old = is_library ? former.begin() : former.find(path);
      if (old != former.end() && file.plugins.empty()) keep(*old, file);
      if (old != former.end()) former.erase(old);
      if (file.status == FileStatus::refused) {
        report.warnings.push_back(known_as(path).string() + ": " + file.sentence);
      }
    }
    for (const auto& old : former) {
      FileReport& gone = found.files.emplace_back();
      gone.sentence = "is gone";
      keep(old, gone);
    }
    report.directories.push_back(std::move(found));
  }
}

FileReport Host::State::examine(const fs::path& path) {
  FileReport file;
  file.path = path;
  if (!may_hold_plugins(path)) {
    file.sentence = "its name ends in neither .so nor .py";
    return file;
  }
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) {
    file.status = FileStatus::refused;
    file.sentence = errno == ENOENT ? "is a link to a file that does not exist"
                                    : "cannot be read: " + std::generic_category().message(errno);
    return file;
  }
  if (S_ISREG(status.st_mode)) {
    const auto [known, is_new] = seen.try_emplace({status.st_dev, status.st_ino}, path);
    if (!is_new) {
      file.sentence = "is the same file as " + known->second.string();
      return file;
    }
  }
  load(file);
  return file;
}

void Host::State::load(FileReport& file) {
  const auto known = before ? before->loaded.find(file.path) : LoadedFiles::const_iterator();
  if (before && known != before->loaded.end() &&
      fingerprint_of(file.path) == known->second.fingerprint) {
    file.abi_word = known->second.abi_word;
    enter(known->second, file);
  } else if (auto found = load_anew(file)) {
    enter(*std::move(found), file);
  }
}

/// Whether a file is to be loaded; otherwise `file` says why not.
bool Host::State::inspect(FileReport& file) const {
  if (is_script(file.path)) {
    file.abi_word = host_abi_word();
    try {
      if (declares_plugins(file.path)) return true;
      file.sentence = "no class of it derives from elsie.Behavior or another plugin of Elsie";
    } catch (const std::exception& error) {
      file.status = FileStatus::refused;
      file.sentence = error.what();
    }
    return false;
  }
  Inspection inspection = inspect_file(file.path);
  file.abi_word = std::move(inspection.abi_word);
  if (inspection.kind != FileKind::plugin_library) {
    file.status = inspection.kind == FileKind::other ? FileStatus::ignored : FileStatus::refused;
    file.sentence = std::move(inspection.sentence);
    return false;
  }
  if (auto mismatch = abi_mismatch(host_abi_word(), file.abi_word)) {
    file.status = FileStatus::refused;
    file.sentence = std::move(*mismatch);
    return false;
  }
  return true;
}

/// Loads a file. Returns none when it cannot be used, with the reason in `file`.
std::optional<LoadedFile> Host::State::load_anew(FileReport& file) {
  LoadedFile found;
  // Taken before the file is read, so that later writes change the fingerprint.
  found.fingerprint = fingerprint_of(file.path).value_or(Fingerprint());
  if (!inspect(file)) return std::nullopt;
  file.status = FileStatus::refused;
  LoadedLibrary library =
      is_script(file.path)
          ? load_script(file.path, copy)
          : load_library(file.path, known_as(file.path).string(), file.abi_word, copy);
  if (!library.missing.empty()) {
    file.status = FileStatus::ignored;
    file.sentence = "is written in Python, and " + library.missing;
    report.warnings.push_back(file.path.string() + ": " + file.sentence + "; it is left out");
    return std::nullopt;
  }
  if (!library.warning.empty()) {
    report.warnings.push_back(known_as(file.path).string() + ": " + library.warning);
  }
  if (!library.problem.empty()) {
    file.sentence = std::move(library.problem);
  } else if (library.declarations.empty()) {
    file.sentence = is_script(file.path)
                        ? "declares no plugin; a class whose name begins with '_' is none"
                        : "declares no plugin; is an ELSIE_SENSOR, ELSIE_BEHAVIOR, "
                          "ELSIE_COORDINATOR, ELSIE_MEASURE, ELSIE_RULE or ELSIE_DRIVE missing?";
  } else if (const auto faults = check_declarations(library.declarations); !faults.empty()) {
    file.sentence = "is declared wrongly: " + joined(faults, "; ");
  } else {
    found.abi_word = file.abi_word;
    for (Declaration& declaration : library.declarations) {
      found.plugins.push_back(
          std::make_shared<const Entry>(Entry{library.library, file.path, std::move(declaration)}));
    }
    return found;
  }
  return std::nullopt;
}

void Host::State::enter(LoadedFile found, FileReport& file) {
  std::size_t used = 0;
  for (const EntryRef& ref : found.plugins) {
    const Declaration& declaration = ref->declaration;
    FoundPlugin& plugin = file.plugins.emplace_back(
        FoundPlugin{declaration.kind, declaration.name, declaration.version, {}});
    if (const Entry* const first = entry(plugin.kind, plugin.name)) {
      plugin.shadowed_by = first->library ? known_as(first->file) : fs::path("the program itself");
      report.warnings.push_back(title(plugin.kind, plugin.name) + " is in both " +
                                plugin.shadowed_by.string() + " and " +
                                known_as(file.path).string() + "; the first one is used");
      continue;
    }
    add(ref);
    ++used;
  }
  if (used > 0) {  // otherwise the library is unloaded
    loaded.insert_or_assign(file.path, std::move(found));
  }
  file.status = used > 0 ? FileStatus::loaded : FileStatus::ignored;
  file.sentence = used > 0 ? "" : "has only plugins that earlier libraries have, too";
}

void Release::operator()(Component* object) {
  // An empty pointer keeps its deleter, which must not keep the library loaded.
  const std::shared_ptr<const Library> last = std::move(library);
  Call call({.library = last ? last->file().c_str() : nullptr,
             .doing = "while its object was destroyed"});
  call.start_clock();
  delete object;
}

Host::Host() : state_(std::make_unique<State>()) {
  for (const EntryRef& entry : built_in()) {
    state_->add(entry);
  }
}

Host::Host(std::vector<SearchDirectory> directories, MakeCopy copy) : Host() {
  state_->copy = std::move(copy);
  state_->search(std::move(directories));
}

Host Host::renewed(std::vector<SearchDirectory> directories) const {
  Host host;
  host.state_->copy = state_->copy;
  host.state_->before = state_.get();
  host.state_->sources = state_->sources;
  host.state_->search(std::move(directories));
  host.state_->before = nullptr;
  for (const auto& [key, entry] : state_->registry) {
    if (!entry->library) {
      host.state_->add(entry);
    }
  }
  return host;
}

Host::Host(Host&&) noexcept = default;
Host& Host::operator=(Host&&) noexcept = default;
Host::~Host() = default;

const Declaration* Host::find(PluginKind kind, std::string_view name) const {
  const Entry* const entry = state_->entry(kind, name);
  return entry ? &entry->declaration : nullptr;
}

std::vector<const Declaration*> Host::all(PluginKind kind) const {
  std::vector<const Declaration*> declarations;
  for (const auto& [key, entry] : state_->registry) {
    if (key.first == kind) {
      declarations.push_back(&entry->declaration);
    }
  }
  return declarations;
}

fs::path Host::file_of(PluginKind kind, std::string_view name) const {
  const Entry* const entry = state_->entry(kind, name);
  return entry ? entry->file : fs::path();
}

std::string Host::explain_missing(PluginKind kind, std::string_view name) const {
  std::vector<std::string_view> names;
  for (const Declaration* const known : all(kind)) {
    names.push_back(known->name);
  }
  std::string text = "there is no " + title(kind, name);
  const std::string hint = base::did_you_mean(name, names);
  if (!hint.empty()) return text + hint;
  for (const PluginKind other : kPluginKinds) {
    if (other != kind && find(other, name)) {
      text += "; '" + std::string(name) + "' is " + kind_with_article(other);
    }
  }
  std::vector<std::string> searched;
  std::vector<std::string> refused;
  for (const DirectoryReport& directory : state_->report.directories) {
    const std::string problem = directory.problem.empty() ? "" : " (" + directory.problem + ")";
    searched.push_back(state_->known_as(directory.directory.path).string() + problem);
    for (const FileReport& file : directory.files) {
      if (file.status == FileStatus::refused) {
        refused.push_back(state_->known_as(file.path).string() + " " + file.sentence);
      }
    }
  }
  text += searched.empty() ? "; no directory was searched"
                           : "; searched were " + base::enumerated(searched);
  text += refused.empty() ? "" : "; refused there: " + joined(refused, "; ");
  return text +
         "; if it is elsewhere, name its file with --plugin FILE, or its folder with --plugin-path "
         "DIR or in ELSIE_PLUGIN_PATH";
}

Object<Component> Host::create_component(PluginKind kind, std::string_view name) const {
  const Entry* const entry = state_->entry(kind, name);
  if (!entry) {
    throw PluginError(explain_missing(kind, name));
  }
  std::optional<std::string> problem;
  Call call({.plugin = &entry->declaration.name,
             .library = entry->library ? entry->library->file().c_str() : nullptr,
             .doing = "while it was made"});
  call.start_clock();
  try {
    std::unique_ptr<Component> object = entry->declaration.create();
    if (const char* const changed = call.restore_arithmetic()) {
      problem = std::string("it changed ") + changed + " for the whole program";
    } else if (object) {
      return {object.release(), Release{entry->library}};
    } else {
      problem = "it made no object";
    }
  } catch (...) {
    problem = base::what_was_thrown();
  }
  // Thrown here, outside of the catch block, when the plugin's own exception is destroyed.
  const std::string file =
      entry->file.empty() ? "" : " (" + state_->known_as(entry->file).string() + ")";
  throw CreateError(title(kind, name) + file + " could not be made: " + *problem);
}

void Host::refuse_class(PluginKind kind, std::string_view name) const {
  throw PluginError(title(kind, name) +
                    " could not be made: its class is not derived from that of " + "a " +
                    std::string(kind_name(kind)));
}

void Host::add(Declaration declaration) {
  if (const auto faults = check_declaration(declaration); !faults.empty()) {
    throw PluginError(joined(faults, "; "));
  }
  if (find(declaration.kind, declaration.name)) {
    throw PluginError(title(declaration.kind, declaration.name) + " exists already");
  }
  state_->add(std::make_shared<const Entry>(Entry{nullptr, {}, std::move(declaration)}));
}

const Report& Host::report() const { return state_->report; }

}  // namespace elsie::plugin
