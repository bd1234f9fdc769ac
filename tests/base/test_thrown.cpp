// What is said of an exception.
#include <stdexcept>

#include <catch2/catch.hpp>

#include "elsie/base/thrown.h"

using namespace elsie;

namespace {

struct Wordless final : std::exception {
  const char* what() const noexcept override { return nullptr; }
};

template <class Exception>
std::string said_of(const Exception& exception) {
  try {
    throw exception;
  } catch (...) {
    return base::what_was_thrown();
  }
}

}  // namespace

TEST_CASE("An exception says its text, or else its type") {
  CHECK(said_of(std::runtime_error("out of ideas")) == "out of ideas");
  CHECK(said_of(std::runtime_error("")) == "an exception of type std::runtime_error");
  CHECK_THAT(said_of(Wordless()),
             Catch::StartsWith("an exception of type ") && Catch::EndsWith("Wordless"));
  CHECK(said_of(42) == "an exception of type int");
}

TEST_CASE("The place of a throw is that which the program knows, if it watches") {
  CHECK(base::place_of_throw().empty());
  base::watch_throws([] { return std::string("respond() at shy.cpp:7"); });
  CHECK(base::place_of_throw() == "respond() at shy.cpp:7");
  base::watch_throws(nullptr);
}
