// Following plugins on disk.
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>

#include <catch2/catch.hpp>

#include "elsie/build/private_copy.h"
#include "elsie/build/watch.h"
#include "elsie/plugin/host.h"

#include "support.h"
#include "variable.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::build;
using namespace elsie::plugin;
using namespace elsie::plugin::test;
using Catch::Contains;

namespace {

namespace fs = std::filesystem;
using elsie::test::wheels;
using std::chrono::milliseconds;

Host copies_of(const Folder& folder) {
  return Host({{folder.path(), "given"}}, build::private_copy);
}
Host renewed(const Host& host, const Folder& folder) {
  return host.renewed({{folder.path(), "given"}});
}

/// Waits until the condition holds, for two minutes at most.
template <class Condition>
void wait_until(const Condition& holds) {
  for (int i = 0; i < 12000 && !holds(); ++i) {
    std::this_thread::sleep_for(milliseconds(10));
  }
  REQUIRE(holds());
}

/// What the watch has found, once it has.
std::optional<Renewal> found(Watch& watch) {
  std::optional<Renewal> renewal;
  wait_until([&] { return renewal || (renewal = watch.take()); });
  return renewal;
}
/// The same, where it has a host to go on with.
std::optional<Renewal> found_host(Watch& watch) {
  auto renewal = found(watch);
  REQUIRE(renewal->host);
  return renewal;
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

long entries(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

/// A plugin of the fixtures' name "good", whose parameter has this default; its maximum is 10.
std::string own_good(const std::string& gain) {
  return "#include <elsie/api/behavior.h>\n"
         "class Good final : public elsie::Behavior {\n public:\n  double gain = " +
         gain +
         ";\n  elsie::Response respond(const elsie::Perception&) override {\n"
         "    return elsie::WheelPair().motion({gain, gain});\n  }\n};\n"
         "ELSIE_BEHAVIOR(Good, \"good\", \"Of the user's own\",\n"
         "    elsie::parameter(\"gain\", &Good::gain, {.max = 10.0, .meaning = \"rate\"}));\n";
}

}  // namespace

TEST_CASE("A copy that other users could replace before it is loaded is refused") {
  Folder folder, temporary;
  folder.with("twin_a");
  fs::permissions(temporary.path(), fs::perms::all);
  const Variable there("TMPDIR", temporary.path());
  const Host host = copies_of(folder);
  CHECK_FALSE(host.find(PluginKind::behavior, "twin"));
  CHECK_THAT(host.report().warnings.at(0),
             Contains("twin_a.so: the folder ") && Contains(" for copies of plugins is in ") &&
                 Contains(", which may be written by other users") && Contains("TMPDIR"));
  CHECK(entries(temporary.path()) == 0);
}

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

TEST_CASE("An old library whose new file is refused stays ahead of later files") {
  Folder folder;
  folder.with("twin_a", "a.so").with("twin_b", "b.so");
  const Host before = copies_of(folder);
  CHECK(twin(before) == "The first twin");
  write_text(folder / "a.so", "half a libr");
  const Host after = renewed(before, folder);
  CHECK(twin(after) == "The first twin");
  REQUIRE(after.report().warnings.size() == 2);
  CHECK_THAT(after.report().warnings[0], Contains("a.so: ") && Contains("is still in use"));
  CHECK_THAT(after.report().warnings[1], Contains("b.so; the first one is used"));
}

TEST_CASE("The files of copies are not in memory, and the copies go with their last object") {
  Folder folder, temporary;
  const Variable there("TMPDIR", temporary.path());
  folder.with("good");
  std::optional<Host> host = copies_of(folder);
  CHECK_FALSE(is_loaded(folder / "good.so"));
  auto object = host->create<Behavior>(PluginKind::behavior, "good");
  host.reset();
  CHECK(answer(*object).left == 3.0);
  CHECK(entries(temporary.path()) == 1);
  object.reset();
  CHECK(entries(temporary.path()) == 0);
}

TEST_CASE("Plugins that are linked into the program are in a renewed host too") {
  class Linked final : public Behavior {
    Response respond(const Perception&) override { return wheels(8, 8); }
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
  auto renewal = found_host(watch);
  CHECK(renewal->problems.empty());
  CHECK(renewal->files == std::vector<fs::path>{folder / "twin.so"});
  CHECK(twin(*renewal->host) == "The second twin");
  CHECK(twin(watch.host()) == "The first twin");
  watch.accept(*std::move(renewal));
  CHECK(twin(watch.host()) == "The second twin");

  folder.with("inline_static");
  renewal = found_host(watch);
  CHECK(renewal->host->find(PluginKind::behavior, "inline_static"));
  watch.accept(*std::move(renewal));

  write_text(folder / "twin.so", "half a libr");
  renewal = found(watch);
  CHECK_FALSE(renewal->host);
  REQUIRE(renewal->problems.size() == 1);
  CHECK_THAT(renewal->problems[0], Contains("twin.so") && Contains("is still in use"));
  CHECK(twin(watch.host()) == "The second twin");
}

TEST_CASE("A watch compiles a source when it or a header of its own changes") {
  Folder here, cache;
  setenv("ELSIE_CACHE", cache.path().c_str(), 1);
  write_text(here / "speed.h", "constexpr double kSpeed = 3.0;\n");
  write_text(here / "straight.cpp", source("return elsie::WheelPair().motion({kSpeed, kSpeed});"));
  Watch watch({{here / "straight.cpp", "--plugin"}}, milliseconds(20));
  CHECK(speed(watch.host(), "straight") == 3.0);
  write_text(here / "speed.h", "constexpr double kSpeed = 4.5;\n");
  auto renewal = found_host(watch);
  CHECK(renewal->files == std::vector<fs::path>{here / "straight.cpp"});
  CHECK(speed(*renewal->host, "straight") == 4.5);
  watch.accept(*std::move(renewal));

  // What the compiler says comes as it is; the old one stays.
  write_text(here / "straight.cpp", source("return nothing_known;"));
  renewal = found(watch);
  CHECK_FALSE(renewal->host);
  REQUIRE(renewal->problems.size() == 1);
  CHECK_THAT(renewal->problems[0], Contains("straight.cpp:5:") && Contains("nothing_known"));
  CHECK(speed(watch.host(), "straight") == 4.5);

  // What is taken back is said, too.
  write_text(here / "straight.cpp", source("return elsie::WheelPair().motion({kSpeed, kSpeed});"));
  renewal = found(watch);
  CHECK_FALSE(renewal->host);
  CHECK(renewal->problems.empty());
  CHECK(renewal->restored == std::vector<fs::path>{here / "straight.cpp"});

  write_text(here / "straight.cpp", source("return elsie::WheelPair().motion({kSpeed, 0});"));
  renewal = found_host(watch);
  CHECK(renewal->problems.empty());
  watch.accept(*std::move(renewal));

  // A header that was not there yet when it was wanted.
  write_text(
      here / "straight.cpp",
      "#include \"turn.h\"\n" + source("return elsie::WheelPair().motion({kSpeed, kTurn});"));
  renewal = found(watch);
  CHECK_FALSE(renewal->host);
  REQUIRE(renewal->problems.size() == 1);
  CHECK_THAT(renewal->problems[0], Contains("turn.h: No such file"));
  write_text(here / "turn.h", "constexpr double kTurn = 9.0;\n");
  renewal = found_host(watch);
  CHECK(answer(*renewal->host->create<Behavior>(PluginKind::behavior, "straight")).right == 9.0);
  unsetenv("ELSIE_CACHE");
}

TEST_CASE("A watch builds again what is saved while it compiles, also at its start") {
  Folder here, cache;
  const Variable there("ELSIE_CACHE", cache.path());
  // A compiler that reads everything, and then finds that the user has saved a file.
  write_text(here / "compiler",
             "#!/bin/sh\nc++ \"$@\"; result=$?\ncd " + here.path().string() +
                 "\nif [ \"$1\" != --version ] && [ -e saved.h ]; then mv saved.h speed.h; fi\n"
                 "exit $result\n");
  fs::permissions(here / "compiler", fs::perms::owner_all);
  const Variable compiler("CXX", here / "compiler");
  write_text(here / "speed.h", "constexpr double kSpeed = 3.0;\n");
  write_text(here / "saved.h", "constexpr double kSpeed = 4.0;\n");
  write_text(here / "straight.cpp", source("return elsie::WheelPair().motion({kSpeed, kSpeed});"));
  Watch watch({{here / "straight.cpp", "--plugin"}}, milliseconds(20));
  CHECK(speed(watch.host(), "straight") == 4.0);

  // Two quick saves: the second one comes while the first one is compiled.
  write_text(here / "saved.h", "constexpr double kSpeed = 6.0;\n");
  write_text(here / "speed.h", "constexpr double kSpeed = 5.0;\n");
  double last = 0.0;
  for (int i = 0; i < 3 && last != 6.0; ++i) {
    auto renewal = found_host(watch);
    last = speed(*renewal->host, "straight");
    watch.accept(*std::move(renewal));
  }
  CHECK(last == 6.0);
}

TEST_CASE("Of a source whose library is refused the old one goes on, not another of its name") {
  Folder here, cache, others;
  const Variable there("ELSIE_CACHE", cache.path());
  const bool is_shadowed = GENERATE(true, false);
  CAPTURE(is_shadowed);
  others.with("twin_a", "twin.so");
  if (is_shadowed) {
    others.with("good");  // which answers 3
  }
  write_text(here / "mine.cpp", own_good("4.0"));
  Watch watch({{here / "mine.cpp", "--plugin"}, {others.path(), "given"}}, milliseconds(20));
  CHECK(speed(watch.host(), "good") == 4.0);

  write_text(here / "mine.cpp", own_good("40.0"));
  auto renewal = found(watch);
  CHECK_FALSE(renewal->host);
  REQUIRE(renewal->problems.size() == 1);
  CHECK_THAT(renewal->problems[0], Catch::StartsWith((here / "mine.cpp").string() + ": ") &&
                                       Contains("is declared wrongly") &&
                                       Contains("is still in use"));
  CHECK(renewal->kept == std::vector<fs::path>{here / "mine.cpp"});

  // Nor does a change elsewhere bring the other one in; not even one after the other.
  for (const std::string twin : {"twin_b", "twin_a"}) {
    write(others / "twin.so", bytes_of(fixture(twin)));
    renewal = found_host(watch);
    CHECK(renewal->files == std::vector<fs::path>{others / "twin.so"});
    CHECK(speed(*renewal->host, "good") == 4.0);
    watch.accept(*std::move(renewal));
  }

  write_text(here / "mine.cpp", own_good("5.0"));
  renewal = found_host(watch);
  CHECK(renewal->files == std::vector<fs::path>{here / "mine.cpp"});
  CHECK(speed(*renewal->host, "good") == 5.0);
}

TEST_CASE("What was not taken is not lost; a watch ends a compiler that is at work") {
  Folder here, cache, others;
  // A compiler that says when it has read all, and on request never ends.
  const std::string done = (here / "done").string(), endless = (here / "endless").string();
  write_text(here / "compiler",
             "#!/bin/sh\nc++ \"$@\"; result=$?\n"
             "if [ \"$1\" = --version ]; then exit $result; fi\n"
             "if [ -e " +
                 endless + " ]; then echo >> " + done +
                 "; sleep 1000; fi\n"
                 "echo >> " +
                 done + "; exit $result\n");
  fs::permissions(here / "compiler", fs::perms::owner_all);
  const Variable compiler("CXX", here / "compiler");
  const Variable there("ELSIE_CACHE", cache.path());
  const auto wait_for_compilers = [&](std::size_t count) {
    wait_until([&] { return bytes_of(here / "done").size() >= count; });
    REQUIRE(bytes_of(here / "done").size() == count);
  };
  // A source that is saved before the build looks at it again is compiled again at once, and what
  // was wrong with the first text is forgotten. A build that has ended has removed its own files.
  const auto wait_for_builds = [&](std::size_t count) {
    wait_for_compilers(count);
    const auto is_at_work = [&] {
      std::error_code ignored;  // a file may vanish under the iterator
      fs::recursive_directory_iterator at(cache.path(), ignored), end;
      for (; !ignored && at != end; at.increment(ignored)) {
        if (at->path().filename().string().starts_with("new.")) {
          return true;
        }
      }
      return false;
    };
    wait_until([&] { return !is_at_work(); });
    REQUIRE(bytes_of(here / "done").size() == count);
  };
  write_text(here / "mine.cpp", own_good("4.0"));
  others.with("twin_a", "twin.so");
  std::optional<Watch> watch;
  watch.emplace(
      std::vector<SearchDirectory>{{here / "mine.cpp", "--plugin"}, {others.path(), "given"}},
      milliseconds(20));
  write_text(here / "mine.cpp", own_good("nothing_known"));
  wait_for_builds(2);
  // What comes from here on is noticed after what the compiler says was left to be taken.
  write_text(here / "mine.cpp", own_good("nothing_either"));
  write(others / "twin.so", bytes_of(fixture("twin_b")));
  wait_for_builds(3);
  write_text(here / "endless", "");
  write_text(here / "mine.cpp", own_good("6.0"));
  wait_for_compilers(4);
  const auto renewal = found(*watch);
  REQUIRE(renewal->problems.size() == 2);
  CHECK_THAT(renewal->problems[0], Contains("nothing_known"));
  CHECK_THAT(renewal->problems[1], Contains("nothing_either"));
  CHECK(renewal->kept == std::vector<fs::path>{here / "mine.cpp"});
  REQUIRE(renewal->host);
  CHECK(twin(*renewal->host) == "The second twin");
  const auto start = std::chrono::steady_clock::now();
  watch.reset();
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(300));
}

TEST_CASE("A hundred libraries in a row leave nothing open and no copies") {
  Folder folder, temporary;
  const Variable there("TMPDIR", temporary.path());
  folder.with("twin_a", "twin.so");
  const long open_files = entries("/proc/self/fd");
  {
    Watch watch({{folder.path(), "given"}}, milliseconds(2));
    for (int i = 0; i < 100; ++i) {
      write(folder / "next", bytes_of(fixture(i % 2 == 0 ? "twin_b" : "twin_a")));
      fs::rename(folder / "next", folder / "twin.so");
      auto renewal = found_host(watch);
      watch.accept(*std::move(renewal));
      // The old one goes once the thread, which has left the new one, is done with it too.
      wait_until([&] { return entries(temporary.path()) == 1; });
    }
  }
  CHECK(entries("/proc/self/fd") == open_files);
  CHECK(entries(temporary.path()) == 0);
}

TEST_CASE("What does not survive a trial is not loaded, and not tried again before it changes") {
  Folder folder;
  folder.with("good").with("twin_a", "twin.so");
  std::atomic<int> trials = 0;
  fs::path tried;
  Watch watch({{folder.path(), "given"}}, milliseconds(20), {},
              [&](const fs::path&, const fs::path& known_as, const std::stop_token&) {
                ++trials;
                tried = known_as;
                return std::string("did not return, while it was loaded\nthe stack");
              });
  CHECK(trials == 0);
  write(folder / "twin.so", bytes_of(fixture("twin_b")));
  auto renewal = found(watch);
  CHECK_FALSE(renewal->host);
  CHECK(renewal->kept == std::vector<fs::path>{folder / "twin.so"});
  REQUIRE(renewal->problems.size() == 2);
  CHECK(renewal->problems[0] == (folder / "twin.so").string() +
                                    ": did not return, while it was loaded; the library that was "
                                    "there before is still in use");
  CHECK(renewal->problems[1] == "the stack");
  CHECK(trials == 1);
  CHECK(tried == folder / "twin.so");

  // Another change does not wait for it once more.
  fs::remove(folder / "good.so");
  renewal = found(watch);
  CHECK(trials == 1);
  CHECK(twin(watch.host()) == "The first twin");
}

TEST_CASE("A draft that is saved while it is tried is used in its last version") {
  Folder folder, drafts;
  folder.with("good");
  drafts.with("twin_a", "twin.so");
  Watch watch(
      {{folder.path(), "given"}}, milliseconds(20), {},
      [&, is_saved = false](const fs::path&, const fs::path&, const std::stop_token&) mutable {
        if (!std::exchange(is_saved, true)) {
          write(drafts / "twin.so", bytes_of(fixture("twin_b")));
        }
        return std::string();
      });
  watch.add(drafts / "twin.so");
  auto renewal = found_host(watch);
  if (twin(*renewal->host) == "The first twin") {
    watch.accept(*std::move(renewal));
    renewal = found_host(watch);
  }
  CHECK(twin(*renewal->host) == "The second twin");
}

TEST_CASE("A trial ends when its file changes again, and with the watch") {
  Folder folder;
  folder.with("twin_a", "twin.so");
  std::atomic<int> trials = 0;
  std::optional<Watch> watch;
  watch.emplace(std::vector<SearchDirectory>{{folder.path(), "given"}}, milliseconds(20),
                std::vector<fs::path>(),
                [&](const fs::path&, const fs::path&, const std::stop_token& stop) {
                  const bool is_endless = ++trials != 2;
                  while (is_endless && !stop.stop_requested()) {
                    std::this_thread::sleep_for(milliseconds(1));
                  }
                  return std::string();
                });
  write(folder / "twin.so", bytes_of(fixture("inline_static")));
  wait_until([&] { return trials == 1; });
  write(folder / "twin.so", bytes_of(fixture("twin_b")));
  auto renewal = found_host(*watch);
  CHECK(renewal->problems.empty());
  CHECK(twin(*renewal->host) == "The second twin");
  watch->accept(*std::move(renewal));
  write(folder / "twin.so", bytes_of(fixture("twin_a")));
  wait_until([&] { return trials == 3; });
  watch.reset();
}
