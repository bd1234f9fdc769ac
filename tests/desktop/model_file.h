// Files of fuzzy models, for tests.
#pragma once

#include <QTemporaryFile>
#include <string>

#include <catch2/catch.hpp>

namespace elsie::desktop {

/// A file of a model, as long as it lives.
class ModelFile {
 public:
  explicit ModelFile(const char* text) {
    REQUIRE(file_.open());
    file_.write(text);
    file_.close();
  }
  std::string name() const { return file_.fileName().toStdString(); }

 private:
  QTemporaryFile file_;
};

}  // namespace elsie::desktop
