// Files that grow as a run goes on.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "elsie/base/error.h"
#include "elsie/files/output_file.h"

#include "../support/full_disk.h"

namespace fs = std::filesystem;
using elsie::files::OutputFile;

namespace {

class TemporaryFile {
 public:
  TemporaryFile() {
    std::string name = (fs::temp_directory_path() / "elsie-file-test-XXXXXX").string();
    const int file = mkstemp(name.data());
    REQUIRE(file >= 0);
    close(file);
    path = name;
  }
  ~TemporaryFile() { fs::remove(path); }
  std::string read() const {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }

  fs::path path;
};

}  // namespace

TEST_CASE("A file grows, and is closed with the last bytes") {
  const TemporaryFile file;
  OutputFile out("log 'x'");
  CHECK_FALSE(out.is_open());
  out.create(file.path);
  out.write("a");
  out.write_piece("bc");
  CHECK(out.size() == 3);
  out.close("d");
  CHECK_FALSE(out.is_open());
  CHECK(file.read() == "abcd");
}

TEST_CASE("A piece is in a full file whole or not at all; other bytes as far as there is room") {
  const TemporaryFile file;
  std::string content;
  {
    OutputFile out("log 'x'");
    out.create(file.path);
    out.write("12345678");
    const elsie::test::FullDisk limit(10);
    SECTION("a piece") {
      CHECK_THROWS_WITH(out.write_piece("abcd"), "log 'x' could not be written: File too large");
      CHECK_THROWS_AS(out.write_piece("a"), std::runtime_error);  // not after a gap
      out.write_now({"b"});
      out.close();
      content = "12345678";
    }
    SECTION("bytes") {
      CHECK_THROWS_WITH(out.write("abcd"), "log 'x' could not be written: File too large");
      CHECK_THROWS_WITH(out.close("e"), "log 'x' could not be written to its end: File too large");
      CHECK_FALSE(out.is_open());
      content = "12345678ab";
    }
  }
  CHECK(file.read() == content);
}

TEST_CASE("The last bytes of an emergency come behind the others, and nothing after them") {
  const TemporaryFile file;
  OutputFile out("log 'x'");
  out.create(file.path);
  out.write("a");
  out.write_now({"b", "c"});
  CHECK_THROWS_AS(out.write_piece("d"), std::runtime_error);
  CHECK(file.read() == "abc");
}

TEST_CASE("A module's own error can be thrown") {
  OutputFile out("log '/none/x'",
                 [](const std::string& sentence) { throw std::domain_error(sentence); });
  CHECK_THROWS_AS(out.create("/none/x"), std::domain_error);
  CHECK_THROWS_WITH(out.create("/none/x"),
                    "log '/none/x' cannot be created: No such file or directory");
}

TEST_CASE("A file that another one is writing is refused, and stays as it is") {
  const TemporaryFile file;
  OutputFile first("recording 'x'");
  first.create(file.path);
  first.write("of the first");
  OutputFile second("recording 'x'");
  CHECK_THROWS_AS(second.create(file.path), elsie::base::BadInput);
  CHECK_THROWS_WITH(second.create(file.path),
                    Catch::Contains("recording 'x' is being written by another run"));
  CHECK_FALSE(second.is_open());
  first.close();
  CHECK(file.read() == "of the first");
  second.create(file.path);
  second.close();
  CHECK(file.read().empty());
  OutputFile one("log"), other("log");  // a device has no content to lose
  one.create("/dev/null");
  CHECK_NOTHROW(other.create("/dev/null"));
}
