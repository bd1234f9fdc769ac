#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <sys/stat.h>

#include "elsie/api/behavior.h"
#include "elsie/api/coordinator.h"
#include "elsie/api/sensor.h"
#include "elsie/plugin/error.h"
#include "elsie/testing/linked.h"

#include "support.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::plugin;
using namespace elsie::plugin::test;
using Catch::Contains;
using elsie::test::wheels;
namespace fs = std::filesystem;

namespace {

class Linked final : public Behavior {
 public:
  Response respond(const Perception&) override { return wheels(1, 2); }
};

class NoBehavior final : public Component {};

}  // namespace

ELSIE_BEHAVIOR(Linked, "linked", "Is part of the test program");

TEST_CASE("A host finds the plugins of a library, of each kind") {
  Folder folder;
  folder.with("good");
  const Host host = host_of(folder);
  for (const PluginKind kind :
       {PluginKind::sensor, PluginKind::behavior, PluginKind::coordinator}) {
    REQUIRE(host.find(kind, "good"));
    CHECK(host.find(kind, "good")->kind == kind);
    CHECK(host.all(kind).size() == 1);
    CHECK(host.file_of(kind, "good") == folder / "good.so");
  }
  CHECK(host.find(PluginKind::sensor, "good")->produces.at(0).kind == "light");
  CHECK(host.find(PluginKind::coordinator, "good")->version == "2.5");
  CHECK_FALSE(host.find(PluginKind::behavior, "better"));
}

TEST_CASE("Objects of loaded plugins do their work") {
  Folder folder;
  folder.with("good");
  const Host host = host_of(folder);
  const auto behavior = host.create<Behavior>(PluginKind::behavior, "good");
  CHECK(answer(*behavior).left == 3.0);
  host.find(PluginKind::behavior, "good")->parameters.at(0).set(*behavior, 5.0);
  CHECK(answer(*behavior).left == 5.0);

  const auto sensor = host.create<Sensor>(PluginKind::sensor, "good");
  sensor->update({});
  CHECK(*static_cast<const double*>(sensor->reading()) == 7.0);

  CHECK(host.create<Coordinator>(PluginKind::coordinator, "good"));
  CHECK(host.create<Component>(PluginKind::coordinator, "good"));
}

TEST_CASE("The report tells what was found in each file") {
  Folder folder;
  folder.with("good");
  write(folder / "notes.txt", "to be read later");
  const Host host = host_of(folder);
  REQUIRE(host.report().directories.size() == 1);
  CHECK(host.report().directories[0].problem.empty());
  CHECK(host.report().warnings.empty());
  const FileReport good = report_of(host, "good.so");
  CHECK(good.status == FileStatus::loaded);
  CHECK_THAT(good.abi_word, Contains("api="));
  CHECK(good.sentence.empty());
  REQUIRE(good.plugins.size() == 3);
  CHECK(good.plugins[0].kind == PluginKind::sensor);
  CHECK(good.plugins[2].version == "2.5");
  const FileReport notes = report_of(host, "notes.txt");
  CHECK(notes.status == FileStatus::ignored);
  CHECK(notes.sentence == "its name ends in neither .so nor .py");
}

TEST_CASE("A script is for plugins only if a class of it derives from one of Elsie's") {
  Folder folder;
  write(folder / "tool.py", "import elsie\n\nclass Tool(Base):\n    pass\n");
  const Host host = host_of(folder);
  const FileReport tool = report_of(host, "tool.py");
  CHECK(tool.status == FileStatus::ignored);
  CHECK(tool.sentence == "no class of it derives from elsie.Behavior or another plugin of Elsie");
  CHECK(host.report().warnings.empty());
}

TEST_CASE("A search path may name one library, and then no other of its folder is loaded") {
  Folder folder;
  folder.with("good").with("twin_a");
  const Host host({{folder / "good.so", "given"}});
  REQUIRE(host.report().directories.size() == 1);
  REQUIRE(host.report().directories[0].files.size() == 1);
  CHECK(host.report().directories[0].files[0].status == FileStatus::loaded);
  CHECK(host.report().directories[0].problem.empty());
}

TEST_CASE("Directories that cannot be searched are reported with the reason") {
  Folder folder;
  folder.with("good");
  write(folder / "notes.txt", std::string_view("no folder"));
  const Host host({{folder / "nothing", "given"},
                   {folder / "notes.txt", "given"},
                   {folder.path(), "given"},
                   {folder.path() / ".", "given"}});
  const auto& directories = host.report().directories;
  REQUIRE(directories.size() == 4);
  CHECK(directories[0].problem == "does not exist");
  CHECK(directories[1].problem == "is not a directory");
  CHECK(directories[2].problem.empty());
  CHECK(directories[3].problem == "is the same directory as " + folder.path().string());
  CHECK(host.find(PluginKind::behavior, "good"));
  CHECK(host.report().warnings.empty());
}

TEST_CASE("Of two plugins of one name the first directory's is used, with a warning") {
  Folder first;
  Folder second;
  first.with("twin_b");
  second.with("twin_a");
  const Host host = host_of(first, second);
  CHECK(host.find(PluginKind::behavior, "twin")->description == "The second twin");
  REQUIRE(host.report().warnings.size() == 1);
  CHECK(host.report().warnings[0] ==
        "behavior 'twin' is in both " + (first / "twin_b.so").string() + " and " +
            (second / "twin_a.so").string() + "; the first one is used");
  const FileReport loser = report_of(host, "twin_a.so");
  CHECK(loser.status == FileStatus::ignored);
  CHECK_THAT(loser.sentence, Contains("earlier libraries have, too"));
  REQUIRE(loser.plugins.size() == 1);
  CHECK(loser.plugins[0].shadowed_by == first / "twin_b.so");
  CHECK_FALSE(is_loaded(second / "twin_a.so"));
}

TEST_CASE("Of two plugins of one name in one directory the first file's is used") {
  Folder folder;
  folder.with("twin_b").with("twin_a");
  const Host host = host_of(folder);
  CHECK(host.find(PluginKind::behavior, "twin")->description == "The first twin");
  CHECK(host.report().warnings.size() == 1);
}

TEST_CASE("A library that is there under two names is loaded once, without a warning") {
  Folder first;
  Folder second;
  first.with("good");
  fs::create_symlink(first / "good.so", first / "link.so");
  fs::create_hard_link(first / "good.so", second / "hard.so");
  const Host host = host_of(first, second);
  CHECK(report_of(host, "good.so").status == FileStatus::loaded);
  for (const char* const name : {"link.so", "hard.so"}) {
    CHECK(report_of(host, name).status == FileStatus::ignored);
    CHECK(report_of(host, name).sentence == "is the same file as " + (first / "good.so").string());
  }
  CHECK(host.report().warnings.empty());
}

TEST_CASE("A library is found through a symbolic link") {
  Folder folder;
  fs::create_symlink(fixture("good"), folder / "linked.so");
  CHECK(host_of(folder).find(PluginKind::behavior, "good"));
}

TEST_CASE("Each of two libraries runs its own helper class of the same name") {
  Folder folder;
  folder.with("helper_a").with("helper_b");
  const Host host = host_of(folder);
  const auto a = host.create<Behavior>(PluginKind::behavior, "helper_a");
  const auto b = host.create<Behavior>(PluginKind::behavior, "helper_b");
  CHECK(answer(*a).left == 1.0);
  CHECK(answer(*b).left == 2.0);
  // Nor do they share a static member.
  CHECK(answer(*a).right == 2.0);
  CHECK(answer(*b).right == 4.0);
}

TEST_CASE("A hundred libraries are loaded in one go") {
  Folder folder;
  std::vector<std::byte> bytes = bytes_of(fixture("one_of_many"));
  const std::string name = "one_of_many_000";
  const auto old_name = std::as_bytes(std::span(name));
  const auto at = std::search(bytes.begin(), bytes.end(), old_name.begin(), old_name.end());
  REQUIRE(at != bytes.end());
  for (int i = 0; i < 100; ++i) {
    const std::string number = std::to_string(100 + i).substr(1);
    std::copy_n(std::as_bytes(std::span(number)).begin(), 2, at + 13);
    write(folder / ("library_" + number + ".so"), bytes);
  }
  const Host host = host_of(folder);
  const auto all = host.all(PluginKind::behavior);
  REQUIRE(all.size() == 100);
  CHECK(std::is_sorted(all.begin(), all.end(), [](const Declaration* a, const Declaration* b) {
    return a->name < b->name;
  }));
  CHECK(all[42]->name == "one_of_many_042");
  CHECK(host.report().warnings.empty());
}

TEST_CASE("A missing plugin is explained with the nearest name") {
  Folder folder;
  folder.with("good");
  const Host host = host_of(folder);
  CHECK(host.explain_missing(PluginKind::behavior, "godo") ==
        "there is no behavior 'godo'; did you mean 'good'?");
  CHECK_THROWS_MATCHES(
      host.create<Behavior>(PluginKind::behavior, "godo"), PluginError,
      Catch::Matchers::Message("there is no behavior 'godo'; did you mean 'good'?"));
}

TEST_CASE("A missing plugin that is like none is explained by where was searched") {
  Folder folder;
  folder.with("twin_a").with("new_api");
  const Host host({{folder.path(), "given"}, {"/nowhere", "given"}});
  CHECK_THAT(
      host.explain_missing(PluginKind::behavior, "new_api"),
      Contains("searched were " + folder.path().string() + " and /nowhere (does not exist)") &&
          Contains("refused there: " + (folder / "new_api.so").string() + " was built for"));
  CHECK_THAT(host.explain_missing(PluginKind::sensor, "twin"), Contains("'twin' is a behavior"));
  CHECK(Host().explain_missing(PluginKind::sensor, "x") ==
        "there is no sensor 'x'; no directory was searched; if it is elsewhere, name its file with "
        "--plugin FILE, or its folder with --plugin-path DIR or in ELSIE_PLUGIN_PATH");
}

TEST_CASE("Plugins that are linked into the program can be added") {
  Host host;
  testing::add_linked(host);
  REQUIRE(host.find(PluginKind::behavior, "linked"));
  CHECK(host.file_of(PluginKind::behavior, "linked").empty());
  CHECK(answer(*host.create<Behavior>(PluginKind::behavior, "linked")).right == 2.0);
  CHECK_THROWS_MATCHES(testing::add_linked(host), PluginError,
                       Catch::Matchers::Message("behavior 'linked' exists already"));
}

TEST_CASE("A plugin with a faulty declaration is not added") {
  Host host;
  CHECK_THROWS_AS(host.add(declare<Linked>(PluginKind::behavior, "Bad Name", "Is refused")),
                  PluginError);
  CHECK(host.all(PluginKind::behavior).empty());
}

TEST_CASE("An object of the wrong class is refused") {
  Host host;
  host.add(declare<NoBehavior>(PluginKind::behavior, "nothing", "Is no behaviour"));
  CHECK_THROWS_MATCHES(host.create<Behavior>(PluginKind::behavior, "nothing"), PluginError,
                       Catch::Matchers::Message(
                           "behavior 'nothing' could not be made: its class is not derived from "
                           "that of a behavior"));
}

TEST_CASE("The plugins of the core are in every host, and stay the same in a renewed one") {
  Host host;
  const Declaration* const built_in = host.find(PluginKind::drive, "differential");
  REQUIRE(built_in);
  CHECK(host.file_of(PluginKind::drive, "differential").empty());
  CHECK(host.renewed({}).find(PluginKind::drive, "differential") == built_in);
  CHECK_THROWS_WITH(host.add(*built_in), Catch::Contains("drive 'differential' exists already"));
}
