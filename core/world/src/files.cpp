#include "elsie/world/files.h"

#include <filesystem>
#include <set>

#include "elsie/base/near_name.h"
#include "elsie/base/words.h"

namespace elsie::world {

namespace fs = std::filesystem;

namespace {

std::optional<std::string> file_in(const std::string& folder, const std::string& name) {
  const fs::path path = (fs::path(folder) / name).lexically_normal();
  std::error_code error;
  return fs::is_regular_file(path, error) ? std::optional(path.string()) : std::nullopt;
}

}  // namespace

std::string Files::folder(const Location& from) const {
  const bool in_a_file = from.is_edit() && !overrides_from_.empty();
  return fs::path(from.line > 0 ? from.file.text()
                  : in_a_file   ? overrides_from_
                                : main_file_)
      .parent_path()
      .string();
}

// A name on a command line may be relative to the current folder.
bool Files::given_by_hand(const Location& from) const {
  return from.is_edit() && overrides_from_.empty();
}

std::optional<std::string> Files::find(const std::string& name, const Location& from) const {
  std::vector<std::string> folders{folder(from)};
  if (given_by_hand(from)) {
    folders.emplace_back(".");
  }
  return search(name, std::move(folders));
}

std::optional<std::string> Files::find_data(const std::string& name) const {
  return search(name, {});
}

std::optional<std::string> Files::search(const std::string& name,
                                         std::vector<std::string> folders) const {
  const auto known = known_.find(name);
  auto path = known == known_.end() ? std::nullopt : std::optional(known->second);
  folders.insert(folders.end(), data_directories_.begin(), data_directories_.end());
  for (auto folder = folders.begin(); !path && folder != folders.end(); ++folder) {
    path = file_in(*folder, name);
  }
  if (path && found_) {
    found_->try_emplace(name, absolute(*path));
  }
  return path;
}

std::string Files::name_for_world(const std::string& found, const std::string& written) const {
  const std::string target = absolute(found);
  const auto leads_there = [&](const std::string& name) {
    const auto file = find(name, Location{});
    return file && absolute(*file) == target;
  };
  if (leads_there(written)) return written;
  for (const std::string& directory : data_directories_) {
    const std::string name =
        fs::path(target).lexically_relative(absolute(directory)).generic_string();
    if (!name.empty() && !name.starts_with("..") && leads_there(name)) return name;
  }
  // Both paths must be relative, as the user wrote them, or both absolute.
  const fs::path from = folder(Location{});
  for (const fs::path& name :
       {fs::path(found).lexically_relative(from.lexically_normal()),
        fs::path(target).lexically_relative(absolute(from.empty() ? "." : from.string()))}) {
    if (!name.empty() && leads_there(name.generic_string())) return name.generic_string();
  }
  return target;
}

std::string Files::why_not(const Location& from, const std::string& attribute,
                           const std::string& value) const {
  if (value.empty()) return "expected the path of a file";
  std::vector<std::string> folders{folder(from)};
  folders.insert(folders.end(), data_directories_.begin(), data_directories_.end());
  for (const std::string& each : folders) {
    const fs::path path = fs::path(each) / value;
    std::error_code error;
    if (fs::is_directory(path, error)) {
      return "'" + path.lexically_normal().string() +
             "' is a directory; expected the path of a file";
    }
  }
  return "there is no such file; looked " + places(from, attribute, value);
}

std::string Files::places(const Location& from, const std::string& attribute,
                          const std::string& value) const {
  const std::string beside = folder(from);
  const std::string hint = advice(attribute, value);
  return "in the folder " + (beside.empty() ? "." : beside) +
         (given_by_hand(from) && !beside.empty() ? ", in the current folder" : "") +
         (data_directories_.empty() ? "" : " or " + data_places()) +
         (hint.empty() ? did_you_mean_file(value, {beside}) : hint);
}

std::string Files::advice(const std::string& attribute, const std::string& value) const {
  const fs::path path = fs::path(value).lexically_normal();
  std::string advice;
  fs::path end;  // gets longer in every iteration; the longest that leads to a file is the best
  for (auto part = path.end(); part != path.begin();) {
    --part;
    if (*part == ".." || *part == path.root_directory()) break;
    end = end.empty() ? *part : *part / end;
    if (const auto found = find_data(end.string())) {
      advice =
          "; there is '" + *found + "': write " + attribute + "=\"" + end.generic_string() + "\"";
    }
  }
  return advice;
}

std::string Files::data_places() const {
  if (data_directories_.empty()) return "in any data directory (none is given)";
  return (data_directories_.size() == 1 ? "in the data directory " : "in the data directories ") +
         base::joined(data_directories_);
}

std::string Files::absolute(const std::string& file) {
  std::error_code error;
  const fs::path path = fs::canonical(file, error);
  return error ? fs::absolute(file).lexically_normal().string() : path.string();
}

std::string did_you_mean_file(const std::string& missing, const std::vector<std::string>& folders) {
  for (const std::string& folder : folders) {
    const fs::path path = fs::path(folder) / missing;
    std::set<std::string> names;
    std::error_code error;
    for (fs::directory_iterator i(path.has_parent_path() ? path.parent_path() : ".", error), end;
         !error && i != end; i.increment(error)) {
      std::error_code ignored;
      if (i->is_regular_file(ignored)) {
        names.insert(i->path().filename().string());
      }
    }
    const auto near = base::nearest_name(path.filename().string(),
                                         std::vector<std::string_view>(names.begin(), names.end()));
    if (near) return "; did you mean '" + fs::path(missing).replace_filename(*near).string() + "'?";
  }
  return "";
}

}  // namespace elsie::world
