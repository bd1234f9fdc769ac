// A bad file in the path never stops a run, and is reported with what is wrong and what to do.
#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <sys/stat.h>

#include "elsie/plugin/error.h"

#include "support.h"

using namespace elsie;
using namespace elsie::plugin;
using namespace elsie::plugin::test;
using Catch::Contains;
using Catch::Matchers::EndsWith;
namespace fs = std::filesystem;

namespace {

/// What a host says of a fixture that lies beside a good library, which must be found all the same.
FileReport verdict(const std::string& name) {
  Folder folder;
  folder.with(name).with("good", "z_good.so");
  const Host host = host_of(folder);
  CHECK(host.find(PluginKind::behavior, "good"));
  const FileReport report = report_of(host, name + ".so");
  // Refusals are warned of, what is ignored is not.
  const bool is_warned = !host.report().warnings.empty();
  CHECK(is_warned == (report.status == FileStatus::refused));
  CHECK(report.plugins.empty());
  CHECK_FALSE(is_loaded(folder / (name + ".so")));
  return report;
}

}  // namespace

TEST_CASE("A library that cannot be used is refused with a sentence, and not left loaded") {
  struct Case {
    std::string fixture;
    std::string sentence;
  };
  const std::vector<Case> cases{
      {"other_abi", "with containers=debug, where this program has containers=plain"},
      {"old_api", "for plugin interface 0.0, which is older than this program's 0.15"},
      {"new_api", "for plugin interface 0.99, which is newer than this program's 0.15"},
      {"mixed_words", "parts with different ABI words"},
      {"no_entry", "no entry point 'elsie_plugin_library' of its own"},
      {"word_changes", "one ABI word in its file and another when loaded (api=0.0;runtime=other)"},
      {"no_plugins", "declares no plugin"},
      {"throws", "failed while it declared its plugins: the model file is missing"},
      {"throws_odd", "failed while it declared its plugins: an exception of type OddBall"},
      {"unresolved", "cannot be loaded: undefined symbol: nowhere::to_be_found(int)"},
      {"bad_default",
       "behavior 'bad_default': the default of speed is 60, but must be a number at "
       "most 50 rad/s"},
  };
  for (const Case& c : cases) {
    INFO(c.fixture);
    const FileReport report = verdict(c.fixture);
    CHECK(report.status == FileStatus::refused);
    CHECK_THAT(report.sentence, Contains(c.sentence));
  }
}

TEST_CASE("The ABI word of a refused library is reported too") {
  CHECK_THAT(verdict("other_abi").abi_word, Contains("containers=debug"));
}

TEST_CASE("A shared library that is no plugin library is ignored, and none of it ever runs") {
  CHECK(verdict("stranger").status == FileStatus::ignored);
  // Loading this one would abort the test.
  CHECK(verdict("hostile").status == FileStatus::ignored);
}

TEST_CASE("Junk in the path does no harm") {
  Folder folder;
  folder.with("good", "z_good.so");
  write(folder / "text.so", "this is not a library\n");
  write(folder / "script.so", "INPUT(libm.so.6)\n");
  write(folder / "empty.so", "");
  fs::create_directory(folder / "directory.so");
  fs::create_symlink(folder / "gone", folder / "dangling.so");
  fs::create_symlink(folder / "loop.so", folder / "loop.so");
  REQUIRE(mkfifo((folder / "pipe.so").c_str(), 0600) == 0);
  const Host host = host_of(folder);
  CHECK(host.find(PluginKind::behavior, "good"));

  const auto check = [&host](const char* name, FileStatus status, const char* sentence) {
    INFO(name);
    CHECK(report_of(host, name).status == status);
    CHECK_THAT(report_of(host, name).sentence, Contains(sentence));
  };
  check("text.so", FileStatus::ignored, "is not a shared library");
  check("script.so", FileStatus::ignored, "is not a shared library");
  check("empty.so", FileStatus::refused, "is empty");
  check("directory.so", FileStatus::ignored, "is a directory");
  check("dangling.so", FileStatus::refused, "is a link to a file that does not exist");
  check("loop.so", FileStatus::refused, "symbolic links");
  check("pipe.so", FileStatus::ignored, "is not a file");
  CHECK(host.report().warnings.size() == 3);
}

TEST_CASE("A plugin whose constructor throws is found, but cannot be made") {
  Folder folder;
  folder.with("throws_at_create");
  std::string message;
  {
    const Host host = host_of(folder);
    REQUIRE(host.find(PluginKind::behavior, "throws_at_create"));
    try {
      host.create<Behavior>(PluginKind::behavior, "throws_at_create");
    } catch (const PluginError& error) {
      message = error.what();
    }
  }
  // The host and the library are gone; the message is not.
  CHECK_FALSE(is_loaded(folder / "throws_at_create.so"));
  CHECK(message == "behavior 'throws_at_create' (" + (folder / "throws_at_create.so").string() +
                       ") could not be made: there can be only one");
}
