#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "elsie/build/source_build.h"
#include "elsie/plugin/abi_word.h"
#include "elsie/plugin/host.h"

#include "support.h"
#include "variable.h"

using namespace elsie;
using namespace elsie::build;
using namespace elsie::plugin;
using namespace elsie::plugin::test;
using Catch::Contains;

namespace {

/// A behaviour whose wheel rates are those of speed.h.
constexpr const char* kSource = R"(#include <elsie/api/behavior.h>
#include "speed.h"
class Straight final : public elsie::Behavior {
 public:
  elsie::Response respond(const elsie::Perception&) override {
    return elsie::WheelPair().motion({kSpeed, kSpeed});
  }
};
ELSIE_BEHAVIOR(Straight, "straight", "Drives straight on");
)";

void write_speed(const Folder& here, double speed) {
  write(here / "speed.h", "constexpr double kSpeed = " + std::to_string(speed) + ";\n");
}
void write_straight(const Folder& here, double speed = 3.0) {
  write(here / "straight.cpp", std::string_view(kSource));
  write_speed(here, speed);
}

double speed_of(const SourceBuild& build) {
  const Host host({{build.library, "given"}});
  const auto object = host.create<Behavior>(PluginKind::behavior, "straight");
  return answer(*object).left;
}

std::string refusal(const std::filesystem::path& source, const std::filesystem::path& cache) {
  try {
    build_source(source, cache);
  } catch (const PluginError& error) {
    return error.what();
  }
  return "it was built";
}

}  // namespace

TEST_CASE("A source file becomes a plugin, and is compiled again only when something has changed") {
  Folder here, cache;
  write_straight(here);
  const SourceBuild first = build_source(here / "straight.cpp", cache.path());
  CHECK_FALSE(first.from_cache);
  CHECK(speed_of(first) == 3.0);
  const auto watched = [&](const std::string& name) {
    return std::any_of(first.inputs.begin(), first.inputs.end(),
                       [&](const auto& file) { return file.filename() == name; });
  };
  CHECK(watched("straight.cpp"));
  CHECK(watched("speed.h"));
  CHECK(watched("behavior.h"));
  CHECK_FALSE(watched("cmath"));  // the system's

  const SourceBuild again = build_source(here / "straight.cpp", cache.path());
  CHECK(again.from_cache);
  CHECK(again.library == first.library);
  CHECK(again.inputs == first.inputs);

  // A header that it includes has changed; both libraries can be in use at once.
  write_speed(here, 4.0);
  const SourceBuild second = build_source(here / "straight.cpp", cache.path());
  CHECK_FALSE(second.from_cache);
  CHECK(second.library != first.library);
  CHECK(speed_of(second) == 4.0);
  CHECK(speed_of(first) == 3.0);

  // The same names elsewhere are another plugin.
  Folder there;
  write_straight(there, 5.0);
  CHECK(speed_of(build_source(there / "straight.cpp", cache.path())) == 5.0);
}

TEST_CASE("What is saved while the compiler runs is compiled too, and nothing stale is kept") {
  Folder here, cache;
  // A compiler that reads everything, and then finds that the user has saved a file.
  write(here / "compiler",
        "#!/bin/sh\nc++ \"$@\"; result=$?\n"
        "if [ \"$1\" != --version ]; then\n  echo >> " +
            (here / "count").string() + "\n  cd " + here.path().string() +
            "\n  for file in saved/*; do [ -e \"$file\" ] && mv \"$file\" .; done\n"
            "fi\nexit $result\n");
  std::filesystem::permissions(here / "compiler", std::filesystem::perms::owner_all);
  std::filesystem::create_directory(here / "saved");
  const Variable compiler("CXX", (here / "compiler").string());
  const auto compilations = [&] { return bytes_of(here / "count").size(); };
  write_straight(here);

  SECTION("a header, which nobody knew of before") {
    write(here / "saved/speed.h", std::string_view("constexpr double kSpeed = 4.0;\n"));
    CHECK(speed_of(build_source(here / "straight.cpp", cache.path())) == 4.0);
    CHECK(compilations() == 2);
  }
  SECTION("the source") {
    std::string backwards = kSource;
    backwards.replace(backwards.find("{kSpeed"), 7, "{-kSpeed");
    write(here / "saved/straight.cpp", backwards);
    CHECK(speed_of(build_source(here / "straight.cpp", cache.path())) == -3.0);
    CHECK(compilations() == 2);
  }
  SECTION("a source that was half written, of which the compiler complains") {
    write(here / "straight.cpp", std::string_view(kSource).substr(0, 150));
    write(here / "saved/straight.cpp", std::string_view(kSource));
    CHECK(speed_of(build_source(here / "straight.cpp", cache.path())) == 3.0);
    CHECK(compilations() == 2);
  }
  CHECK(build_source(here / "straight.cpp", cache.path()).from_cache);
}

TEST_CASE("A source that is saved each time that it is compiled is given up with a sentence") {
  Folder here, cache;
  write(here / "compiler",
        "#!/bin/sh\nc++ \"$@\"; result=$?\n"
        "[ \"$1\" = --version ] || echo '// more' >> " +
            (here / "straight.cpp").string() + "\nexit $result\n");
  std::filesystem::permissions(here / "compiler", std::filesystem::perms::owner_all);
  const Variable compiler("CXX", (here / "compiler").string());
  write_straight(here);
  CHECK_THAT(
      refusal(here / "straight.cpp", cache.path()),
      Contains("straight.cpp was compiled 4 times, and each time '") &&
          Contains("straight.cpp' was saved meanwhile; try again once nothing writes to it"));
  for (const auto& entry : std::filesystem::recursive_directory_iterator(cache.path())) {
    CHECK(entry.is_directory());
  }
}

TEST_CASE("The compiler speaks English, whatever the user's language") {
  Folder here, cache;
  write(here / "compiler",
        std::string_view("#!/bin/sh\necho \"$LC_ALL,$LC_MESSAGES,$LC_CTYPE\"; exit 1\n"));
  std::filesystem::permissions(here / "compiler", std::filesystem::perms::owner_all);
  const Variable compiler("CXX", (here / "compiler").string()), all("LC_ALL", "de_DE.UTF-8");
  write_straight(here);
  CHECK_THAT(refusal(here / "straight.cpp", cache.path()), Catch::StartsWith(",C,de_DE.UTF-8\n"));
}

TEST_CASE("What the compiler says is passed on, and the cache keeps nothing of it") {
  Folder here, cache;
  write(here / "wrong.cpp",
        std::string_view("#include <elsie/api/behavior.h>\nint wrong = none;\n"));
  CHECK_THROWS_AS(build_source(here / "wrong.cpp", cache.path()), BuildError);
  const std::string message = refusal(here / "wrong.cpp", cache.path());
  CHECK_THAT(message, Contains("wrong.cpp:2:13: error:"));
  CHECK_THAT(message, Contains("could not be compiled"));
  for (const auto& entry : std::filesystem::recursive_directory_iterator(cache.path())) {
    CHECK(entry.is_directory());
  }
}

TEST_CASE("A missing symbol is found when the plugin is compiled, not when it runs") {
  Folder here, cache;
  write(here / "unlinked.cpp",
        std::string_view("#include <elsie/api/behavior.h>\ndouble nowhere();\n"
                         "class A : public elsie::Behavior {\n"
                         "  elsie::Response respond(const elsie::Perception&) override {\n"
                         "    return elsie::WheelPair().motion({nowhere(), 0.0});\n  }\n};\n"
                         "ELSIE_BEHAVIOR(A, \"a\", \"Asks for what is not there\");\n"));
  if (host_abi_word().find("sanitizer=none") != std::string_view::npos) {
    CHECK_THAT(refusal(here / "unlinked.cpp", cache.path()), Contains("nowhere()"));
  }
}

TEST_CASE("The cache keeps the newest libraries of a source, and nothing that nobody asks for") {
  namespace fs = std::filesystem;
  Folder here, cache;
  write_straight(here);
  const auto days_ago = [](int days) {
    return fs::file_time_type::clock::now() - std::chrono::hours(24 * days);
  };
  const SourceBuild first = build_source(here / "straight.cpp", cache.path());
  const fs::path folder = first.library.parent_path();
  fs::last_write_time(first.library, days_ago(1));
  std::vector<fs::path> more;
  for (int i = 0; i < static_cast<int>(kMostBuilds); ++i) {
    more.push_back(folder / ("straight-" + std::to_string(i) + ".so"));
    write(more.back(), std::string_view("another one"));
    fs::last_write_time(more.back(), days_ago(2 + i));
  }
  write(folder / "new.999999999.so", std::string_view("of a compiler that was killed"));
  write(folder / ("new." + std::to_string(getppid()) + ".d"), std::string_view("at work"));
  // Of other sources: one that nobody asks for, one that is asked for, and what is not the cache's.
  for (const std::string name : {"old", "used", "strange"}) {
    fs::create_directory(cache / name);
    write(cache / name / "inputs", std::string_view("x.so\n"));
    write(cache / name / "x.so", std::string_view("a library"));
    fs::last_write_time(cache / name / "inputs", days_ago(name == "used" ? 1 : kCacheDays + 1));
  }
  write(cache / "strange/notes.txt", std::string_view("not of the cache"));

  write_speed(here, 4.0);
  const SourceBuild second = build_source(here / "straight.cpp", cache.path());
  CHECK(fs::exists(second.library));
  CHECK(fs::exists(first.library));
  for (std::size_t i = 0; i < more.size(); ++i) {
    CHECK(fs::exists(more[i]) == (i + 2 < kMostBuilds));
  }
  CHECK_FALSE(fs::exists(folder / "new.999999999.so"));
  CHECK(fs::exists(folder / ("new." + std::to_string(getppid()) + ".d")));
  CHECK_FALSE(fs::exists(cache / "old"));
  CHECK(fs::exists(cache / "used/x.so"));
  CHECK(fs::exists(cache / "strange/x.so"));
}

TEST_CASE("What cannot be compiled is reported in a sentence") {
  Folder here, cache;
  CHECK(refusal("notes.txt", cache.path()) ==
        "'notes.txt' is no C++ source: its name should end in .cpp, .cc or .cxx");
  CHECK(refusal("missing.cpp", cache.path()) ==
        "'missing.cpp' cannot be read: No such file or directory; check the path");
  std::filesystem::create_directory(here / "folder.cpp");
  CHECK_THAT(refusal(here / "folder.cpp", cache.path()), Contains("is no file; check the path"));
  write(here / "straight.cpp", std::string_view(kSource));
  {
    const Variable compiler("CXX", "no-such-compiler");
    CHECK(refusal(here / "straight.cpp", cache.path()) ==
          "there is no compiler 'no-such-compiler' to compile a plugin with; install g++ (on "
          "Debian: apt install g++), or name another one in the environment variable CXX");
  }
  write(here / "occupied", std::string_view("a file"));
  CHECK_THAT(refusal(here / "straight.cpp", here / "occupied"),
             Contains("for compiled plugins cannot be made") && Contains("ELSIE_CACHE"));
}

TEST_CASE("A source is no option of the compiler, whatever its name begins with") {
  Folder here, cache;
  const std::filesystem::path before = std::filesystem::current_path();
  write(here / "speed.h", std::string_view("#pragma once\nconstexpr double kSpeed = 4;\n"));
  write(here / "mine.cpp", std::string_view("of the user's own\n"));
  for (const char* name : {"-omine.cpp", "@mine.cpp"})
    write(here / name, std::string_view(kSource));
  std::filesystem::current_path(here.path());
  std::optional<double> speed;
  CHECK_NOTHROW(speed = speed_of(build_source("-omine.cpp", cache.path())));
  CHECK_THAT(refusal("@mine.cpp", cache.path()), Contains("begins with '@'"));
  std::filesystem::current_path(before);
  CHECK(speed == 4.0);
  std::ifstream mine(here / "mine.cpp");
  std::string line;
  std::getline(mine, line);
  CHECK(line == "of the user's own");
}

TEST_CASE("Flags of the user's own are part of what is cached") {
  Folder here, cache;
  write(here / "straight.cpp",
        std::string_view("#include <elsie/api/behavior.h>\n"
                         "class S final : public elsie::Behavior {\n"
                         "  elsie::Response respond(const elsie::Perception&) override {\n"
                         "    return elsie::WheelPair().motion({SPEED, SPEED});\n  }\n};\n"
                         "ELSIE_BEHAVIOR(S, \"straight\", \"Drives straight on\");\n"));
  const auto built = [&](const std::string& flags) {
    const Variable variable("CXXFLAGS", flags);
    return speed_of(build_source(here / "straight.cpp", cache.path()));
  };
  CHECK(built("-DSPEED=1.0") == 1.0);
  CHECK(built("-DSPEED=2.0") == 2.0);
  CHECK(built("-DSPEED=1.0") == 1.0);
}

TEST_CASE("Flags that change layouts, calls or type information are refused, by name") {
  Folder here, cache;
  write_straight(here);
  // Some by the compiler, and those that it cannot see by the host, before the library is loaded.
  for (const std::string flag : {
         "-fpack-struct", "-fshort-enums",
#if defined(__x86_64__)
             "-mabi=ms",
#endif
             "-fno-rtti", "-fno-exceptions", "-fshort-wchar"
       }) {
    CAPTURE(flag);
    const Variable flags("CXXFLAGS", flag);
    std::string refused;
    try {
      const SourceBuild build = build_source(here / "straight.cpp", cache.path());
      const Host host({{build.library, "given"}});
      refused = host.report().warnings.empty() ? "" : host.report().warnings.front();
      CHECK_FALSE(is_loaded(build.library));
    } catch (const BuildError& error) {
      refused = error.what();
    }
    CHECK_THAT(refused, Contains(flag));
  }
}

TEST_CASE("The user's flags prevail over ours, and libraries come after the source") {
  Folder here, cache;
  write(here / "compiler", "#!/bin/sh\n[ \"$1\" = --version ] || echo \"$@\" > " +
                               (here / "line").string() + "\nexec c++ \"$@\"\n");
  std::filesystem::permissions(here / "compiler", std::filesystem::perms::owner_all);
  write_straight(here);
  const Variable compiler("CXX", (here / "compiler").string());
  const Variable flags("CXXFLAGS", "-O0 -lm -fgnu-unique");
  const Variable linker("LDFLAGS", "-Wl,--as-needed");
  const Variable libraries("LDLIBS", "-lpthread");
  build_source(here / "straight.cpp", cache.path());
  std::string line;
  std::getline(std::ifstream(here / "line") >> std::ws, line);
  const auto place = [&](const std::string& word) {
    const std::size_t at = line.find(word);
    INFO(word << " in " << line);
    REQUIRE(at != std::string::npos);
    return at;
  };
  CHECK(place("-O2") < place("-O0"));
  CHECK(place(" -g1 ") < place("-O0"));
  CHECK(place("-Wl,--as-needed") < place("straight.cpp"));
  CHECK(place("straight.cpp") < place("-lm"));
  CHECK(place("-lm") < place("-lpthread"));
}

TEST_CASE("A method that was meant to override and does not is warned of") {
  Folder here, cache;
  write(here / "straight.cpp",
        std::string_view("#include <elsie/api/behavior.h>\n"
                         "class S final : public elsie::Behavior {\n"
                         "  elsie::Response respond(const elsie::Perception&) override {\n"
                         "    return elsie::WheelPair().motion({1, 1});\n  }\n"
                         "  virtual void equipped() {}\n};\n"
                         "ELSIE_BEHAVIOR(S, \"straight\", \"Drives straight on\");\n"));
  const SourceBuild first = build_source(here / "straight.cpp", cache.path());
  CHECK_THAT(first.warnings,
             Contains("straight.cpp") && Contains("equipped") && Contains("-Woverloaded-virtual"));
  CHECK(build_source(here / "straight.cpp", cache.path()).warnings.empty());
}

TEST_CASE("A sensor whose sense() is misspelt is not compiled, and a sentence says why") {
  Folder here, cache;
  const auto sensor = [](const std::string& method) {
    return "#include <elsie/api/sensor.h>\n"
           "class S final : public elsie::SensorOf<elsie::RangeReading> {\n" +
           method +
           "};\n"
           "ELSIE_SENSOR(S, \"s\", \"Senses a distance\");\n";
  };
  write(here / "s.cpp", sensor("  elsie::RangeReading sens(const elsie::SensorContext&) {\n"
                               "    return {};\n  }\n"));
  CHECK_THAT(refusal(here / "s.cpp", cache.path()),
             Contains("this sensor senses nothing: override sense() or sense_into()"));
  // A private method is the class' own, too.
  write(here / "s.cpp", sensor("  elsie::RangeReading sense(const elsie::SensorContext&) override "
                               "{\n    return {};\n  }\n"));
  CHECK(refusal(here / "s.cpp", cache.path()) == "it was built");
}

TEST_CASE("An element that nests in a list of several structs is not compiled, and says why") {
  Folder here, cache;
  const auto behavior = [](const std::string& nests) {
    return "#include <elsie/api/behavior.h>\n#include <variant>\n"
           "struct A { double x = 0.0; std::vector<A> inner; };\n"
           "struct B { double x = 0.0; };\n"
           "class L final : public elsie::Behavior {\n public:\n"
           "  std::vector<std::variant<A, B>> list;\n"
           "  elsie::Response respond(const elsie::Perception&) override { return {}; }\n};\n"
           "ELSIE_BEHAVIOR(L, \"l\", \"Lists\", elsie::elements(&L::list,\n"
           "  elsie::element<A>(\"a\", \"one\", " +
           nests +
           "elsie::parameter(\"x\", &A::x)),\n"
           "  elsie::element<B>(\"b\", \"other\", elsie::parameter(\"x\", &B::x))));\n";
  };
  write(here / "l.cpp", behavior("elsie::nests(&A::inner), "));
  CHECK_THAT(refusal(here / "l.cpp", cache.path()), Contains("nests() needs a list of one struct"));
  write(here / "l.cpp", behavior(""));
  CHECK(refusal(here / "l.cpp", cache.path()) == "it was built");
}

TEST_CASE("A cache that other users could fill or replace is refused") {
  namespace fs = std::filesystem;
  const fs::perms all = fs::perms::all;
  Folder here;
  write_straight(here);
  fs::create_directory(here / "open");
  fs::permissions(here / "open", all);
  CHECK_THAT(refusal(here / "straight.cpp", here / "open"),
             Contains("/open for compiled plugins may be written by other users; libraries that "
                      "others put there would run as you: remove it, or name a folder of your own "
                      "in the environment variable ELSIE_CACHE"));
  CHECK_THAT(
      refusal(here / "straight.cpp", here / "open/cache"),
      Contains("is in " + (here / "open").string() + ", which may be written by other users"));
  CHECK_FALSE(fs::exists(here / "open/cache"));
  fs::create_directory_symlink(here / "open", here / "link");
  CHECK_THAT(refusal(here / "straight.cpp", here / "link/cache"),
             Contains("which may be written by other users"));

  // As in /tmp, only its owner can rename what is in this folder.
  fs::permissions(here / "open", all | fs::perms::sticky_bit);
  REQUIRE(refusal(here / "straight.cpp", here / "open/cache") == "it was built");
  const std::vector<fs::path> made{here / "open/cache",
                                   *fs::directory_iterator(here / "open/cache")};
  for (const fs::path& folder : made) {
    CHECK(fs::status(folder).permissions() == fs::perms::owner_all);
  }
  constexpr uid_t kSomeoneElse = 65533;
  if (chown((here / "open/cache").c_str(), kSomeoneElse, kSomeoneElse) == 0) {  // only root may
    CHECK_THAT(refusal(here / "straight.cpp", here / "open/cache"),
               Contains("belongs to another user (number 65533)"));
    fs::create_directory_symlink(here.path(), here / "theirs");
    REQUIRE(lchown((here / "theirs").c_str(), kSomeoneElse, kSomeoneElse) == 0);
    CHECK_THAT(refusal(here / "straight.cpp", here / "theirs/cache"),
               Contains("theirs, which belongs to another user"));
  }
}

TEST_CASE("A library in the cache that is not the one that was compiled is not used") {
  Folder here, cache;
  write_straight(here);
  const auto library = build_source(here / "straight.cpp", cache.path()).library;
  std::filesystem::copy_file(library, here / "copy.so");
  SECTION("it was overwritten") { write(library, std::string_view("something else")); }
  SECTION("it is a link") {
    std::filesystem::remove(library);
    std::filesystem::create_symlink(here / "copy.so", library);
  }
  const SourceBuild again = build_source(here / "straight.cpp", cache.path());
  CHECK_FALSE(again.from_cache);
  CHECK_FALSE(std::filesystem::is_symlink(again.library));
  CHECK(speed_of(again) == 3.0);
}

TEST_CASE("The cache is where the environment says") {
  const Variable own("ELSIE_CACHE", "");
  const Variable user("XDG_CACHE_HOME", "/x");
  const Variable home("HOME", "/h");
  CHECK(cache_directory() == "/x/elsie");
  const Variable relative("XDG_CACHE_HOME", "x");
  CHECK(cache_directory() == "/h/.cache/elsie");
  const Variable homeless("HOME", "");
  CHECK(cache_directory() ==
        std::filesystem::temp_directory_path() / ("elsie-" + std::to_string(geteuid())));
  const Variable named("ELSIE_CACHE", "/y");
  CHECK(cache_directory() == "/y");
}
