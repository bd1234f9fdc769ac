// Finds the files that a world file names.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "elsie/world/description.h"

namespace elsie::world {

class Files {
 public:
  /// `edits_from` and `found` are as in ReadOptions; `known` is ReadOptions::files.
  Files(std::string main_file, std::vector<std::string> data_directories,
        std::string edits_from = "", std::map<std::string, std::string> known = {},
        std::map<std::string, std::string>* found = nullptr)
      : main_file_(std::move(main_file)),
        data_directories_(std::move(data_directories)),
        overrides_from_(std::move(edits_from)),
        known_(std::move(known)),
        found_(found) {}

  /// Finds the regular file that the text at `from` calls `name`: in the folder of that text's file
  /// (for an edit: of the world file, or of the file with the edits), else in the data
  /// directories. The path is normalized, but not absolute.
  std::optional<std::string> find(const std::string& name, const Location& from) const;
  /// Searches only the data directories: for default files, which no world file names.
  std::optional<std::string> find_data(const std::string& name) const;

  /// The name to be written in the world file for `found`, which find() returned for the name
  /// `written` (perhaps in a template): the same name if it leads to the same file there, else a
  /// name relative to a data directory or the world's folder, else the absolute path.
  std::string name_for_world(const std::string& found, const std::string& written) const;

  /// A sentence that says why find() found nothing for the value of an attribute: it is a
  /// directory, or does not exist, with places().
  std::string why_not(const Location& from, const std::string& attribute,
                      const std::string& value) const;
  /// The places in which find() searched for the value of an attribute, in words. Suggests a better
  /// value if a data directory has a file with the end of that name ("robots/scout.xml" for
  /// "../robots/scout.xml"), or the folder has a file with a similar name.
  std::string places(const Location& from, const std::string& attribute,
                     const std::string& value) const;
  /// The places in which find_data() searched, in words.
  std::string data_places() const;

  /// The absolute path of a file, without symbolic links if it exists.
  static std::string absolute(const std::string& file);

 private:
  /// Searches these folders, then the data directories.
  std::optional<std::string> search(const std::string& name,
                                    std::vector<std::string> folders) const;
  std::string folder(const Location& from) const;
  std::string advice(const std::string& attribute, const std::string& value) const;
  bool given_by_hand(const Location& from) const;

  std::string main_file_;
  std::vector<std::string> data_directories_;
  std::string overrides_from_;
  std::map<std::string, std::string> known_;  // by name, searched first
  std::map<std::string, std::string>* found_;
};

/// "; did you mean 'worlds/maze.xml'?" for a file that is missing in these folders. Suggests the
/// regular file with the nearest name in the first folder that has one; "" if none has.
std::string did_you_mean_file(const std::string& missing, const std::vector<std::string>& folders);

}  // namespace elsie::world
