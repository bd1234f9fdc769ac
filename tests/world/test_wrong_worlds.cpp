// The worlds in wrong/ have one mistake each; beside each lies the message that it must give.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include "fixture.h"
#include "folder.h"

using namespace elsie;
using namespace elsie::test;
namespace fs = std::filesystem;

namespace {

std::string message_of_wrong(const std::string& file) {
  world::ReadOptions reading;
  reading.data_directories = {kFolder + "data"};
  reading.check_plugins = true;
  try {
    world::read_world(file, host(), reading);
    return "accepted";
  } catch (const world::WorldError& error) {
    std::string text = error.what();
    for (std::size_t at; (at = text.find(kFolder)) != std::string::npos;) {
      text.erase(at, kFolder.size());
    }
    return text;
  }
}

// A file for one test.
class Draft {
 public:
  explicit Draft(const std::string& text) { std::ofstream(path_, std::ios::binary) << text; }
  ~Draft() { fs::remove(path_); }
  const std::string& path() const { return path_; }

 private:
  std::string path_ = test::build_path("wrong_world.xml");
};

}  // namespace

TEST_CASE("Each wrong world gives its message") {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(kFolder + "wrong")) {
    fs::path file = entry.path();
    if (file.extension() == ".xml") {
      ++count;
      CAPTURE(file.filename().string());
      const std::string message = message_of_wrong(file.string());
      CHECK(message + "\n" == text_of(file.replace_extension(".txt").string()));
      CHECK(std::count(message.begin(), message.end(), '\n') == 0);
    }
  }
  CHECK(count >= 100);
}

TEST_CASE("Nesting of any depth is refused in words") {
  for (const int depth : {60, 10'000, 100'000}) {
    std::string text;
    for (int i = 0; i < depth; ++i) {
      text += "<world>";
    }
    CHECK_THROWS_WITH(
        world::parse_world(text, "deep.xml", host()),
        "deep.xml:1: elements are nested deeper than 50 levels; no world needs that many");
  }
}

TEST_CASE("What is no file is refused in words") {
  CHECK(message_of_wrong(kFolder + "wrong") == "wrong: this is a directory; expected an XML file");
  CHECK(message_of_wrong(kFolder + "data/everythin.xml") ==
        "data/everythin.xml: there is no such file; did you mean 'everything.xml'?");
  CHECK(message_of_wrong(kFolder + "nowhere/at_all.xml") ==
        "nowhere/at_all.xml: there is no such file");
  const Folder folder;
  fs::create_symlink("loop.xml", folder / "loop.xml");
  fs::create_symlink("gone.xml", folder / "link.xml");
  CHECK_THAT(message_of_wrong((folder / "loop.xml").string()),
             Catch::EndsWith("loop.xml: this is a link that leads back to itself; expected an XML "
                             "file"));
  CHECK_THAT(message_of_wrong((folder / "link.xml").string()),
             Catch::EndsWith("link.xml: this is a link to 'gone.xml', but there is no such file"));
  CHECK(message_of_wrong("/dev/null") ==
        "/dev/null: this is a device, not a file; expected an XML file");
  CHECK(message_of_wrong("") == "'': the name of a file is missing; expected that of an XML file");
}

TEST_CASE("A file that no world can fill is not read") {
  const Draft draft("<world format='1'/>");
  fs::resize_file(draft.path(), (std::uintmax_t{256} << 20) + 1);
  CHECK_THAT(message_of_wrong(draft.path()),
             Catch::EndsWith(
                 ": this is 268.5 MB long; files of up to 256 MB are read; expected an XML file"));
}

TEST_CASE("An element with very many attributes is refused soon") {
  std::string text = "<world format='1'\n";
  for (int i = 0; i < 20000; ++i) {
    text += " a" + std::to_string(i) + "='1'\n";
  }
  const Draft draft(text + "/>");
  CHECK_THAT(message_of_wrong(draft.path()),
             Catch::EndsWith(":501: <world> has more than 500 attributes; no element has so many"));
}

TEST_CASE("Markup characters in values do not hide that there are very many attributes") {
  for (const std::string value : {"<=", "><x", "><x='"}) {
    CAPTURE(value);
    std::string text = "<world format='1'";
    for (int i = 0; i < 300'000; ++i) {
      text += " a" + std::to_string(i) + "=\"" + value + "\"";
    }
    const Draft draft(text + "/>");
    CHECK_THAT(message_of_wrong(draft.path()), Catch::Contains("a quote may be missing"));
  }
}

TEST_CASE("A file with very many mistakes is reported in full, and soon") {
  std::string text = "<world format='1'><obstacles>\n";
  for (int i = 0; i < 30'000; ++i) {
    text += "<static_box x='a'/>\n";
  }
  try {
    world::parse_world(text + "</obstacles></world>", "many.xml", host());
    FAIL("accepted");
  } catch (const world::WorldError& error) {
    REQUIRE(error.problems().size() == 30'000);
    CHECK(error.problems().back().line == 30'001);
  }
}
