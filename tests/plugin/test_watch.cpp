// Following plugins on disk.
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>

#include <catch2/catch.hpp>

#include "elsie/plugin/host.h"
#include "elsie/plugin/watch.h"

#include "support.h"

using namespace elsie;
using namespace elsie::plugin;
using namespace elsie::plugin::test;
using Catch::Contains;

namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

Host copies_of(const Folder& folder) { return Host({{folder.path(), "given"}}, Loading::copies); }
Host renewed(const Host& host, const Folder& folder) {
  return host.renewed({{folder.path(), "given"}});
}

/// What the watch has found, once it has; none after two minutes.
std::optional<Renewal> found(Watch& watch) {
  for (int i = 0; i < 12000; ++i) {
    if (auto renewal = watch.take()) {
      return renewal;
    }
    std::this_thread::sleep_for(milliseconds(10));
  }
  return std::nullopt;
}

/// What the first or second twin says of itself.
std::string twin(const Host& host) { return host.find(PluginKind::behavior, "twin")->description; }

double speed(const Host& host, const char* name) {
  return answer(*host.create<Behavior>(PluginKind::behavior, name)).left;
}

std::string source(const std::string& body) {
  return "#include <elsie/api/behavior.h>\n#include \"speed.h\"\n"
         "class Straight final : public elsie::Behavior {\n"
         "  elsie::Response respond(const elsie::Perception&) override {\n" +
         body + "\n  }\n};\nELSIE_BEHAVIOR(Straight, \"straight\", \"Drives straight on\");\n";
}

void write_text(const fs::path& file, const std::string& text) {
  write(file, std::string_view(text));
}

}  // namespace

TEST_CASE("A renewed host shares what has not changed, and loads what has beside the old one") {
  Folder folder;
  folder.with("good").with("twin_a", "twin.so");
  std::optional<Host> before = copies_of(folder);
  fs::remove(folder / "twin.so");
  folder.with("twin_b", "twin.so");
  const Host after = renewed(*before, folder);
  CHECK(after.find(PluginKind::behavior, "good") == before->find(PluginKind::behavior, "good"));
  CHECK(after.find(PluginKind::behavior, "twin") != before->find(PluginKind::behavior, "twin"));
  CHECK(twin(*before) == "The first twin");
  CHECK(twin(after) == "The second twin");
  before.reset();
  CHECK(speed(after, "good") == 3.0);
}

TEST_CASE("The files of copies are not in memory, and the copies go with their last object") {
  Folder folder;
  folder.with("good");
  std::optional<Host> host = copies_of(folder);
  CHECK_FALSE(is_loaded(folder / "good.so"));
  auto object = host->create<Behavior>(PluginKind::behavior, "good");
  host.reset();
  CHECK(answer(*object).left == 3.0);
}

TEST_CASE("Plugins that are linked into the program are in a renewed host too") {
  class Linked final : public Behavior {
    Response respond(const Perception&) override { return MotorCommand{8, 8}; }
  };
  Folder folder;
  Host host = copies_of(folder);
  host.add(declare<Linked>(PluginKind::behavior, "linked", "For a test"));
  CHECK(speed(renewed(host, folder), "linked") == 8.0);
}

TEST_CASE("A watch finds libraries that are new, replaced or overwritten") {
  Folder folder;
  folder.with("good").with("twin_a", "twin.so");
  Watch watch({{folder.path(), "given"}}, milliseconds(20));
  CHECK_FALSE(watch.take());
  CHECK(twin(watch.host()) == "The first twin");
  write(folder / "twin.so", bytes_of(fixture("twin_b")));  // in place
  auto renewal = found(watch);
  REQUIRE(renewal);
  CHECK(renewal->problems.empty());
  REQUIRE(renewal->host);
  CHECK(renewal->files == std::vector<fs::path>{folder / "twin.so"});
  CHECK(twin(*renewal->host) == "The second twin");
  CHECK(twin(watch.host()) == "The first twin");
  watch.accept(*std::move(renewal));
  CHECK(twin(watch.host()) == "The second twin");

  folder.with("inline_static");
  renewal = found(watch);
  REQUIRE(renewal);
  REQUIRE(renewal->host);
  CHECK(renewal->host->find(PluginKind::behavior, "inline_static"));
  watch.accept(*std::move(renewal));

  write_text(folder / "twin.so", "half a libr");
  renewal = found(watch);
  REQUIRE(renewal);
  CHECK_FALSE(renewal->host);
  REQUIRE(renewal->problems.size() == 1);
  CHECK_THAT(renewal->problems[0], Contains("twin.so") && Contains("is still in use"));
  CHECK(twin(watch.host()) == "The second twin");
}

TEST_CASE("A watch compiles a source when it or a header of its own changes") {
  Folder here, cache;
  setenv("ELSIE_CACHE", cache.path().c_str(), 1);
  write_text(here / "speed.h", "constexpr double kSpeed = 3.0;\n");
  write_text(here / "straight.cpp", source("return elsie::MotorCommand{kSpeed, kSpeed};"));
  Watch watch({{here / "straight.cpp", "--plugin"}}, milliseconds(20));
  CHECK(speed(watch.host(), "straight") == 3.0);
  write_text(here / "speed.h", "constexpr double kSpeed = 4.5;\n");
  auto renewal = found(watch);
  REQUIRE(renewal);
  REQUIRE(renewal->host);
  CHECK(renewal->files == std::vector<fs::path>{here / "straight.cpp"});
  CHECK(speed(*renewal->host, "straight") == 4.5);
  watch.accept(*std::move(renewal));

  // What the compiler says comes as it is; the old one stays.
  write_text(here / "straight.cpp", source("return nothing_known;"));
  renewal = found(watch);
  REQUIRE(renewal);
  CHECK_FALSE(renewal->host);
  REQUIRE(renewal->problems.size() == 1);
  CHECK_THAT(renewal->problems[0], Contains("straight.cpp:5:") && Contains("nothing_known"));
  CHECK(speed(watch.host(), "straight") == 4.5);

  write_text(here / "straight.cpp", source("return elsie::MotorCommand{kSpeed, 0};"));
  renewal = found(watch);
  REQUIRE(renewal);
  REQUIRE(renewal->host);
  CHECK(renewal->problems.empty());
  watch.accept(*std::move(renewal));

  // A header that was not there yet when it was wanted.
  write_text(here / "straight.cpp",
             "#include \"turn.h\"\n" + source("return elsie::MotorCommand{kSpeed, kTurn};"));
  renewal = found(watch);
  REQUIRE(renewal);
  CHECK_FALSE(renewal->host);
  REQUIRE(renewal->problems.size() == 1);
  CHECK_THAT(renewal->problems[0], Contains("turn.h: No such file"));
  write_text(here / "turn.h", "constexpr double kTurn = 9.0;\n");
  renewal = found(watch);
  REQUIRE(renewal);
  REQUIRE(renewal->host);
  CHECK(answer(*renewal->host->create<Behavior>(PluginKind::behavior, "straight")).right == 9.0);
  unsetenv("ELSIE_CACHE");
}
