#pragma once

#include <filesystem>

#include "elsie/report/results.h"
#include "elsie/results/database_file.h"

namespace elsie::report {

namespace sqlite = results::sqlite;

struct ResultsFile::State {
  explicit State(const std::filesystem::path& path)
      : file(path), connection(results::open_to_read(path)) {}

  template <class Action>
  auto reading(Action action) {
    return results::guarded(file, "could not be read", action);
  }

  std::filesystem::path file;
  sqlite::Connection connection;
};

}  // namespace elsie::report
