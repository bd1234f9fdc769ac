// Runs the command-line program as a user does.
#pragma once

#include <filesystem>
#include <string>

#include "folder.h"

namespace elsie::test {

struct ProgramRun {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// A new folder for each test, with the shipped data next to it; removed at the end.
class Workplace {
 public:
  Workplace();

  /// Runs a shell command line in the folder, with `elsie` on the path.
  ProgramRun sh(const std::string& command) const;
  /// Runs `elsie` with these arguments.
  ProgramRun elsie(const std::string& arguments) const { return sh("elsie " + arguments); }

  std::filesystem::path file(const std::string& name) const { return folder_ / name; }
  void write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const;

 private:
  Folder folder_;
};

}  // namespace elsie::test
