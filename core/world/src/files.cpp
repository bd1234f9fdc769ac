#include "files.h"

#include <filesystem>

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
  return fs::path(from.line > 0 ? from.file : main_file_).parent_path().string();
}

std::optional<std::string> Files::find(const std::string& name, const Location& from) const {
  const auto beside = file_in(folder(from), name);
  return beside ? beside : find_data(name);
}

std::optional<std::string> Files::find_data(const std::string& name) const {
  for (const std::string& directory : data_directories_) {
    if (auto found = file_in(directory, name)) {
      return found;
    }
  }
  return std::nullopt;
}

std::string Files::places(const Location& from) const {
  const std::string beside = folder(from);
  return "in the folder " + (beside.empty() ? "." : beside) +
         (data_directories_.empty() ? "" : " or " + data_places());
}

std::string Files::data_places() const {
  if (data_directories_.empty()) {
    return "in any data directory (none is given)";
  }
  std::string list;
  for (const std::string& directory : data_directories_) {
    list += (list.empty() ? "" : ", ") + directory;
  }
  return (data_directories_.size() == 1 ? "in the data directory " : "in the data directories ") +
         list;
}

std::string Files::absolute(const std::string& file) {
  std::error_code error;
  const fs::path path = fs::canonical(file, error);
  return error ? fs::absolute(file).lexically_normal().string() : path.string();
}

}  // namespace elsie::world
