// Plugins without a build system: elsie build, and --plugin.
#include <filesystem>

#include <catch2/catch.hpp>

#include "program.h"

using Catch::Contains;
using elsie::test::Workplace;

namespace {

constexpr const char* kWorld = R"(<world format="1"><robots><robot id="r1" team="red">
  <behaviors><straight/></behaviors><coordinator><arbiter_suppression/></coordinator>
</robot></robots><goals><reach robot="r1" x="1" y="0" radius="0.1"/></goals><limits time="20"/></world>)";

std::string source(const std::string& rates) {
  return "#include <elsie/api/behavior.h>\n"
         "class Straight final : public elsie::Behavior {\n"
         "  elsie::Response respond(const elsie::Perception&) override {\n"
         "    return elsie::WheelPair().motion({" +
         rates +
         "});\n  }\n};\n"
         "ELSIE_BEHAVIOR(Straight, \"straight\", \"Drives straight on\");\n";
}

/// A workplace with its own cache.
struct Bench : Workplace {
  Bench() {
    write("world.xml", kWorld);
    write("straight.cpp", source("10.0, 10.0"));
  }
  auto cached(const std::string& arguments) const {
    return sh("ELSIE_CACHE=cache elsie " + arguments);
  }
};

}  // namespace

TEST_CASE("A world runs with a behaviour that is one source file") {
  Bench here;
  const auto run = here.cached("run world.xml --plugin straight.cpp --quiet");
  CAPTURE(run.err);
  CHECK(run.exit_code == 0);
  CHECK(run.err.empty());
  here.write("straight.cpp", source("0.0, 0.0"));  // it stays in place
  CHECK(here.cached("run world.xml --plugin straight.cpp --quiet").exit_code == 1);
  // Every command that uses plugins knows it.
  CHECK(here.cached("check world.xml --plugin straight.cpp").exit_code == 0);
  CHECK_THAT(here.cached("describe straight --plugin straight.cpp").out,
             Contains("Drives straight on"));
}

TEST_CASE("A terminal shows what is being compiled, and nothing for sources in the cache") {
  Bench here;
  const auto on_a_terminal = [&](const std::string& arguments) {
    return here.sh("ELSIE_CACHE=cache script -qec 'elsie " + arguments + "' /dev/null < /dev/null")
        .out;
  };
  const std::string check = "check world.xml --plugin straight.cpp";
  const std::string progress = "\rcompiling straight.cpp ...\033[K\r\033[K";
  CHECK_THAT(on_a_terminal(check), Catch::StartsWith(progress + "world.xml: in order"));
  CHECK_THAT(on_a_terminal(check), Catch::StartsWith("world.xml: in order"));
  here.write("straight.cpp", source("9.0, 9.0"));
  CHECK(on_a_terminal(check + " --quiet").empty());
  here.write("straight.cpp", "no C++");
  CHECK_THAT(on_a_terminal(check), Catch::StartsWith(progress));
}

TEST_CASE("elsie build makes a library, which runs like any other") {
  Bench here;
  const auto first = here.cached("build straight.cpp");
  CAPTURE(first.err);
  CHECK(first.exit_code == 0);
  CHECK(first.out == "straight.so: behavior 'straight'\n");
  CHECK(here.cached("build straight.cpp").out ==
        "straight.so: behavior 'straight', compiled before\n");
  CHECK(here.elsie("run world.xml --plugin straight.so --quiet").exit_code == 0);
  CHECK(here.elsie("run world.xml --plugin-path . --quiet").exit_code == 0);
}

TEST_CASE("A plugin that cannot be built or used is reported, and nothing runs") {
  Bench here;
  const auto refused = [&](const std::string& arguments) {
    const auto run = here.cached(arguments);
    CAPTURE(arguments);
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    return run.err;
  };
  here.write("wrong.cpp", source("10.0; 10.0"));
  const std::string message = refused("run world.xml --plugin wrong.cpp");
  CHECK_THAT(message, Contains("wrong.cpp:4:"));
  CHECK_THAT(message, Contains("error:"));
  CHECK_THAT(message, Contains("wrong.cpp could not be compiled"));
  CHECK_THAT(refused("build wrong.cpp"), Contains("wrong.cpp:4:"));
  CHECK_FALSE(std::filesystem::exists(here.file("wrong.so")));

  here.write("empty.cpp", "#include <elsie/api/behavior.h>\n");
  CHECK_THAT(refused("build empty.cpp"), Contains("declares no plugin"));
  CHECK_THAT(refused("run world.xml --plugin empty.cpp"), Contains("declares no plugin"));
  here.write("plain.cpp", "int nothing() { return 0; }\n");
  CHECK_THAT(refused("run world.xml --plugin plain.cpp"), Contains("--plugin: 'plain.cpp'"));
  CHECK(refused("run world.xml --plugin missing.cpp") ==
        "elsie: 'missing.cpp' cannot be read: No such file or directory; check the path\n");
  CHECK(refused("run world.xml --plugin missing.so") ==
        "elsie: --plugin: there is no file 'missing.so'\n");
  CHECK(
      refused("run world.xml --plugin world.xml") ==
      "elsie: --plugin: 'world.xml' should be a plugin library (.so), the source of one (.cpp), or "
      "a script with plugins (.py)\n");
  here.write("junk.so", "no library");
  CHECK_THAT(refused("run world.xml --plugin junk.so"), Contains("--plugin: 'junk.so'"));
  CHECK(refused("build straight.cpp --output straight.txt") ==
        "elsie: --output: a plugin library's name must end in .so, but 'straight.txt' does not\n");
  CHECK_THAT(refused("build straight.cpp --output nowhere/straight.so"),
             Contains("there is no folder 'nowhere'"));
  CHECK(refused("build world.xml") ==
        "elsie: 'world.xml' is no C++ source: its name should end in .cpp, .cc or .cxx\n");
}

TEST_CASE("Messages name the source, not the library that it was compiled to") {
  Bench here;
  // With a second plugin, so that the library is usable.
  here.write("again.cpp", source("1.0, 1.0") +
                              "struct Other final : elsie::Behavior {\n"
                              "  elsie::Response respond(const elsie::Perception&) override {\n"
                              "    return {};\n  }\n};\n"
                              "ELSIE_BEHAVIOR(Other, \"other\", \"Another one\");\n");
  const auto twice = here.cached("check world.xml --plugin straight.cpp --plugin again.cpp");
  CHECK_THAT(twice.err, Contains("behavior 'straight' is in both straight.cpp and again.cpp"));
  CHECK_THAT(twice.err, !Contains("cache/"));
  here.write("early.cpp", "#include <cstdlib>\n" + source("1.0, 1.0") +
                              "const int now = [] { std::abort(); return 1; }();\n");
  const auto crashed = here.cached("check world.xml --plugin early.cpp");
  CHECK(crashed.exit_code == 3);
  CHECK_THAT(crashed.err, Contains("early.cpp"));
  CHECK_THAT(crashed.err.substr(0, crashed.err.find('\n')), !Contains("cache/"));
}

TEST_CASE("A crash in a function that was put inline, or an exception of it, names its own line") {
  Bench here;
  here.write("straight.cpp",
             "#include <elsie/api/behavior.h>\n#include <cstdlib>\n#include <vector>\n"
             "class Straight final : public elsie::Behavior {\n"
             "  std::vector<double> rates_;\n"
             "  elsie::Response respond(const elsie::Perception&) override {\n"
             "    const double rate = std::getenv(\"RUDE\") ? rates_[0] : rates_.at(1);\n"
             "    return elsie::WheelPair().motion({rate, 1.0});\n  }\n};\n"
             "ELSIE_BEHAVIOR(Straight, \"straight\", \"Reads what is not there\");\n");
  const auto run = here.sh("RUDE=1 ELSIE_CACHE=cache elsie run world.xml --plugin straight.cpp");
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.err, Contains("straight.cpp"));
  CHECK_THAT(run.err, Contains("straight.cpp:7\n"));
  const auto thrown = here.cached("run world.xml --plugin straight.cpp");
  CHECK(thrown.exit_code == 3);
  CHECK_THAT(thrown.err, Contains("failed in step 0 (at 0 s): vector::_M_range_check") &&
                             Contains("\nthe plugin's own line: ") &&
                             Contains("/straight.cpp:7\n"));
}

TEST_CASE("The manual page and the shells' completion know every subcommand and option") {
  Workplace here;
  const auto manual = here.elsie("manual");
  const auto bash = here.elsie("completion bash");
  const auto zsh = here.elsie("completion zsh");
  CHECK(manual.exit_code == 0);
  for (const std::string word : {"run", "explain", "describe", "train", "build"}) {
    CHECK_THAT(manual.out, Contains(".SS " + word));
    CHECK_THAT(bash.out, Contains("    " + word + ")"));
    CHECK_THAT(zsh.out, Contains("'" + word + ":"));
  }
  CHECK_THAT(manual.out, Contains("\\-\\-record\\-rate"));
  CHECK_THAT(bash.out, Contains("--record-rate"));
  CHECK_THAT(zsh.out, Contains("--record-rate"));
  here.write("elsie.bash", bash.out +
                               "\nCOMP_WORDS=(elsie run --rec); COMP_CWORD=2; _elsie; echo "
                               "${COMPREPLY[@]}\n"
                               "COMP_WORDS=(elsie describe wan); _elsie; echo "
                               "${COMPREPLY[@]}\n");
  const auto completed = here.sh("bash elsie.bash");
  CHECK(completed.out ==
        "--record --record-rate --record-times --record-images --record-robots\nwander\n");
  const auto wrong = here.elsie("completion fish");
  CHECK(wrong.exit_code == 2);
  CHECK_THAT(wrong.err, Contains("fish"));
}
