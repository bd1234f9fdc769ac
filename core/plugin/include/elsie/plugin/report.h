// What a host found in its directories, for `elsie plugins`, `elsie check` and messages.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "elsie/api/declaration.h"
#include "elsie/plugin/search_path.h"

namespace elsie::plugin {

enum class FileStatus {
  loaded,   // a plugin library in use
  ignored,  // not a plugin library, or one without new plugins
  refused   // a plugin library, or a file that seems to be one, that cannot be used
};

/// One plugin of a library.
struct FoundPlugin {
  PluginKind kind = PluginKind::behavior;
  std::string name;
  std::string version;
  std::filesystem::path shadowed_by;  // the file whose plugin is used instead; or ""
};

struct FileReport {
  std::filesystem::path path;
  FileStatus status = FileStatus::ignored;
  std::string abi_word;  // "": none was found
  std::vector<FoundPlugin> plugins;
  std::string sentence;  // why it is ignored or refused, without the path; "" when loaded
  bool is_former =
      false;  // in a renewed host: the new file is refused or missing, the old one used
};

struct DirectoryReport {
  SearchDirectory directory;
  std::string problem;            // "does not exist"...; "" when it was searched
  std::vector<FileReport> files;  // in the order of their names
};

struct Report {
  std::vector<DirectoryReport> directories;
  std::vector<std::string> warnings;  // sentences on refused files and plugins of one name
};

}  // namespace elsie::plugin
