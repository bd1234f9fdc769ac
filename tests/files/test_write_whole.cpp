// Files that are written whole or not at all.
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <catch2/catch.hpp>
#include <sys/stat.h>
#include <unistd.h>

#include "elsie/files/replacement.h"
#include "elsie/files/write_whole.h"

#include "folder.h"

namespace fs = std::filesystem;
namespace files = elsie::files;
using elsie::test::Folder;

namespace {

std::string read(const fs::path& name) {
  std::ifstream in(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void write(const fs::path& name, const std::string& text) { std::ofstream(name) << text; }

unsigned mode_of(const fs::path& file) {
  return static_cast<unsigned>(fs::status(file).permissions());
}

}  // namespace

TEST_CASE("A file is made, and replaced by another one; nothing is left over") {
  const Folder here;
  CHECK(files::write_whole(here / "a", "one") == 0);
  CHECK(read(here / "a") == "one");
  fs::create_hard_link(here / "a", here / "old");
  CHECK(files::write_whole(here / "a", "two", files::Durable::yes) == 0);
  CHECK(read(here / "a") == "two");
  CHECK(read(here / "old") == "one");  // who has it open reads on
  CHECK(here.files() == 2);
}

TEST_CASE("A link stays one, and what it points to is written") {
  const Folder here;
  fs::create_directory(here / "far");
  write(here / "far/a", "one");
  fs::create_symlink("far/a", here / "link");
  fs::create_symlink("link", here / "link_to_link");
  CHECK(files::write_whole(here / "link_to_link", "two") == 0);
  CHECK(fs::is_symlink(here / "link_to_link"));
  CHECK(fs::is_symlink(here / "link"));
  CHECK_FALSE(fs::is_symlink(here / "far/a"));
  CHECK(read(here / "far/a") == "two");

  SECTION("even if there is nothing yet") {
    fs::create_symlink(here / "far/b", here / "new");
    CHECK(files::end_of_links(here / "new") == here / "far/b");
    CHECK(files::write_whole(here / "new", "three") == 0);
    CHECK(fs::is_symlink(here / "new"));
    CHECK(read(here / "far/b") == "three");
  }
  SECTION("but a circle of links leads nowhere") {
    fs::create_symlink("round", here / "about");
    fs::create_symlink("about", here / "round");
    CHECK(files::end_of_links(here / "round") == here / "round");
  }
}

TEST_CASE("Pipes and devices are written to as they are") {
  const Folder here;
  CHECK(files::write_whole("/dev/null", "nothing", files::Durable::yes) == 0);
  CHECK(fs::is_character_file("/dev/null"));
  CHECK(files::write_whole("/dev/full", "too much") == ENOSPC);
  fs::create_symlink("/dev/full", here / "full.png");
  CHECK(files::write_whole(here / "full.png", "too much") == ENOSPC);
  CHECK(fs::is_symlink(here / "full.png"));
}

TEST_CASE("What cannot be written leaves the file as it was") {
  const Folder here;
  CHECK(files::write_whole(here / "none/a", "one") == ENOENT);
  fs::create_directory(here / "folder");
  CHECK(files::write_whole(here / "folder", "one") == EISDIR);
  CHECK(here.files() == 1);
}

TEST_CASE("The permissions of a file that is replaced stay; the mask holds for a new one") {
  const Folder here;
  for (const unsigned mode : {0600U, 0444U, 0755U, 0640U}) {
    const fs::path file = here / "a";
    fs::remove(file);
    write(file, "one");
    REQUIRE(chmod(file.c_str(), mode) == 0);
    CHECK(files::write_whole(file, "two") == 0);
    CHECK(read(file) == "two");
    CHECK(mode_of(file) == mode);
  }
  const mode_t mask = umask(027);
  CHECK(files::write_whole(here / "new", "one") == 0);
  umask(mask);
  CHECK(mode_of(here / "new") == 0640U);
}

TEST_CASE("What another program writes replaces a file likewise, or leaves it as it was") {
  const Folder here;
  const fs::path file = here / "a";
  write(file, "one");
  REQUIRE(chmod(file.c_str(), 0600) == 0);
  SECTION("it is whole") {
    files::Replacement part(file);
    REQUIRE(part.error() == 0);
    CHECK(mode_of(part.path()) == 0600U);  // nobody reads what nobody may
    write(part.path(), "two");
    CHECK(read(file) == "one");
    REQUIRE(chmod(part.path().c_str(), 0666) == 0);
    CHECK(part.replace() == 0);
    CHECK(read(file) == "two");
    CHECK(mode_of(file) == 0600U);
  }
  SECTION("it is given up") {
    {
      const files::Replacement part(file);
      write(part.path(), "tw");
    }
    CHECK(read(file) == "one");
  }
  SECTION("there is no room for it") {
    files::Replacement part(here / "none/b");
    CHECK(part.error() == ENOENT);
    CHECK(part.replace() == ENOENT);
  }
  CHECK(here.files() == 1);
}
