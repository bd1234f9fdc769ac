// A schema in a file, with xmllint to check texts against it.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "places.h"

namespace elsie::test {

class SchemaJudge {
 public:
  /// `name`: the file's name while the judge lives.
  SchemaJudge(const std::string& schema, const std::string& name) : schema_(build_path(name)) {
    std::ofstream(schema_) << schema;
  }
  ~SchemaJudge() { std::filesystem::remove(schema_); }
  SchemaJudge(const SchemaJudge&) = delete;
  SchemaJudge& operator=(const SchemaJudge&) = delete;

  bool accepts(const std::string& file) const {
    const std::string command =
        "xmllint --noout --nonet --schema '" + schema_ + "' '" + file + "' >/dev/null 2>&1";
    return std::system(command.c_str()) == 0;
  }

 private:
  std::string schema_;
};

}  // namespace elsie::test
