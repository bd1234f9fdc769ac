// What a host found in its directories: for `elsie plugins`, `elsie check` and messages.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "elsie/api/declaration.h"
#include "elsie/plugin/search_path.h"

namespace elsie::plugin {

enum class FileStatus {
  loaded,   // a plugin library in use
  ignored,  // not a plugin library, or one that brings nothing new; worth a note at debug level
  refused   // a plugin library, or what seems to be one, that cannot be used; worth a warning
};

/// One plugin of a library.
struct FoundPlugin {
  PluginKind kind = PluginKind::behavior;
  std::string name;
  std::string version;
  std::filesystem::path
      shadowed_by;  // the file whose plugin of this name is used instead; or empty
};

struct FileReport {
  std::filesystem::path path;
  FileStatus status = FileStatus::ignored;
  std::string abi_word;  // empty when none was found
  std::vector<FoundPlugin> plugins;
  std::string sentence;    // why it is ignored or refused, without the path; empty when loaded
  bool is_former = false;  // of a renewed host: refused or gone, what was there before is in use
};

struct DirectoryReport {
  SearchDirectory directory;
  std::string problem;            // "does not exist"...; empty when it was searched
  std::vector<FileReport> files;  // in the order of their names
};

struct Report {
  std::vector<DirectoryReport> directories;
  std::vector<std::string> warnings;  // sentences: refused files, plugins of the same name
};

}  // namespace elsie::plugin
