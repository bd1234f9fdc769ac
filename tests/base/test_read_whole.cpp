// Files that are read whole: what is no file, or too large for one, is refused before it is opened.
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>
#include <sys/stat.h>

#include "elsie/base/read_whole.h"

#include "folder.h"

using Catch::Contains;
using elsie::base::read_whole;
using elsie::base::why_unreadable;
namespace fs = std::filesystem;

TEST_CASE("What is in a file is read byte by byte") {
  const elsie::test::Folder folder;
  const std::string content("a\0\r\nb", 5);
  std::ofstream(folder / "file", std::ios::binary) << content;
  CHECK(why_unreadable(folder / "file").empty());
  CHECK(read_whole(folder / "file", 5) == content);
}

TEST_CASE("A pipe, a device and a folder are refused without being opened") {
  const elsie::test::Folder folder;
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  CHECK(why_unreadable(folder / "pipe") == "is a pipe, not a file");
  CHECK_THROWS_WITH(read_whole(folder / "pipe", 100), "is a pipe, not a file");
  CHECK(why_unreadable("/dev/zero") == "is a device, not a file");
  CHECK(why_unreadable(folder.path()) == "is a directory");
  CHECK(why_unreadable(folder / "none") == "cannot be read: No such file or directory");
  CHECK(why_unreadable("") == "has no name");
}

TEST_CASE("The system's reason is given when reading fails") {
  // A regular file for all that is known of it, and nothing is mapped at its beginning.
  CHECK(why_unreadable("/proc/self/mem").empty());
  CHECK_THROWS_WITH(read_whole("/proc/self/mem", 100), "cannot be read: Input/output error");
}

TEST_CASE("A file that is larger than what can be read is refused by its size") {
  const elsie::test::Folder folder;
  std::ofstream(folder / "sparse").close();
  fs::resize_file(folder / "sparse", 1'100'000'000);
  CHECK_THROWS_WITH(read_whole(folder / "sparse", 32'000'000),
                    "is 1100 MB long; files of up to 32 MB are read");
  fs::resize_file(folder / "sparse", 32'000'001);
  CHECK(why_unreadable(folder / "sparse", 32'000'000) ==
        "is 32.1 MB long; files of up to 32 MB are read");
  CHECK(why_unreadable(folder / "sparse").empty());
}
