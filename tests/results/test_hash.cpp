#include <string>

#include <catch2/catch.hpp>

#include "elsie/results/hash.h"

#include "folder.h"

using namespace elsie;
using Catch::Contains;

TEST_CASE("SHA-256 is that of the standard") {
  // FIPS 180-2, appendix B.1; and the empty text.
  CHECK(results::sha256("abc") ==
        "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(results::sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST_CASE("The hash of a file is that of its bytes") {
  const test::Folder folder;
  std::string several_pieces;
  while (several_pieces.size() < 1'000'000) {
    several_pieces += std::to_string(several_pieces.size());
  }
  for (const std::string& text : {std::string(), std::string("a\0b", 3), several_pieces}) {
    CHECK(results::file_sha256(folder.write("some", text)) == results::sha256(text));
    CHECK(results::file_content(folder.file("some")) == text);
  }
}

TEST_CASE("A file that cannot be read is named") {
  const test::Folder folder;
  CHECK_THROWS_WITH(results::file_sha256(folder.file("none")),
                    Contains("none' cannot be read: No such file"));
  CHECK(results::file_content(folder.write("two\nlines", std::string("a\0b", 3))) ==
        std::string("a\0b", 3));
  CHECK_THROWS_WITH(results::file_content(folder.file("none")),
                    Contains("none' cannot be read: No such file"));
}
