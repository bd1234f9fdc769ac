// Finding the files that a world file names.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "elsie/world/description.h"

namespace elsie::world {

class Files {
 public:
  /// `overrides_from`: ReadOptions::overrides_from. `known`: ReadOptions::files.
  Files(std::string main_file, std::vector<std::string> data_directories,
        std::string overrides_from = "", std::map<std::string, std::string> known = {})
      : main_file_(std::move(main_file)),
        data_directories_(std::move(data_directories)),
        overrides_from_(std::move(overrides_from)),
        known_(std::move(known)) {}

  /// The regular file called `name` in the text at `from`: in the folder of that file (for an
  /// override: of the world file, or of that in which overrides stand), else in the data
  /// directories. Its path is as short as the names that it was made of.
  std::optional<std::string> find(const std::string& name, const Location& from) const;
  /// The same in the data directories only: for defaults, which no file names.
  std::optional<std::string> find_data(const std::string& name) const;

  /// What the world file may call a file that find() found as `found` when some file (a template,
  /// perhaps) called it `written`: that same name if it means the same file there, else one that
  /// starts in a data directory or in the world's folder. Absolute only when `written` is, or
  /// nothing else leads there.
  std::string name_for_world(const std::string& found, const std::string& written) const;

  /// Why find() found nothing for the value of an attribute, as a sentence: what stands there is a
  /// directory, or nothing does; then with places().
  std::string why_not(const Location& from, const std::string& attribute,
                      const std::string& value) const;
  /// Where find() looked for the value of an attribute, in words; and what to write instead when a
  /// data directory has a file under the end of that name, "robots/scout.xml" for
  /// "../robots/scout.xml", or the folder has one of nearly that name.
  std::string places(const Location& from, const std::string& attribute,
                     const std::string& value) const;
  /// Where find_data() looked, in words.
  std::string data_places() const;

  /// The one absolute path of a file that exists.
  static std::string absolute(const std::string& file);

 private:
  std::string folder(const Location& from) const;
  std::string advice(const std::string& attribute, const std::string& value) const;
  bool given_by_hand(const Location& from) const;

  std::string main_file_;
  std::vector<std::string> data_directories_;
  std::string overrides_from_;
  std::map<std::string, std::string> known_;  // by name; they come first
};

/// The regular file in the folder of one that is not there whose name is most like it; "": none is.
std::string near_file(const std::string& missing);

}  // namespace elsie::world
