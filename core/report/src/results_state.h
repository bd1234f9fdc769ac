#pragma once

#include <string>

#include "elsie/report/results.h"

#include "sqlite.h"

namespace elsie::report {

struct ResultsFile::State {
  explicit State(const std::string& file) : connection(file) {}

  Connection connection;
};

}  // namespace elsie::report
