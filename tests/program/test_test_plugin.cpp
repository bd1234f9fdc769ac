// elsie test-plugin: its messages and exit codes.
#include <catch2/catch.hpp>

#include "program.h"

using Catch::Contains;
using Catch::Equals;
using elsie::test::Workplace;

TEST_CASE("A sound plugin is reported as such") {
  Workplace here;
  const auto run = here.elsie("test-plugin wander beam_range arbiter_voting --variants 2");
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.out, Equals("behavior 'wander': no faults found\n"
                             "sensor 'beam_range': no faults found\n"
                             "coordinator 'arbiter_voting': no faults found\n"));
}

TEST_CASE("Faults of a source file are reported in sentences") {
  Workplace here;
  here.write("counts.cpp",
             "#include <elsie/api/behavior.h>\n"
             "class Counts final : public elsie::Behavior {\n"
             "  elsie::Response respond(const elsie::Perception&) override {\n"
             "    static int calls = 0;\n"
             "    return elsie::WheelPair().motion({1.0 * ++calls, 0.0});\n"
             "  }\n"
             "};\n"
             "ELSIE_BEHAVIOR(Counts, \"counts\", \"Counts in a static\");\n");
  const auto run = here.sh("ELSIE_CACHE=$PWD/cache elsie test-plugin counts.cpp");
  CHECK(run.exit_code == 1);
  CHECK_THAT(run.out, Contains("behavior 'counts': two objects answer the same input differently"));
}

TEST_CASE("A plugin that needs elements inside its own is given them") {
  Workplace here;
  CHECK(here.elsie("test-plugin timetable --variants 0").exit_code == 1);
  const auto run = here.elsie(
      "test-plugin timetable referee --variants 2 "
      "--element '<edit time=\"0.5\" path=\"robot[r1]/@x\" value=\"0\"/>' "
      "--element '<edit time=\"1\" path=\"robot[r1]/@x\" value=\"1\"/>' "
      "--element '<after time=\"0.5\"/>'");
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.out, Equals("rule 'timetable': no faults found\n"
                             "rule 'referee': no faults found\n"));
}

TEST_CASE("Wrong arguments are refused in a sentence") {
  Workplace here;
  const auto refused = [&](const std::string& arguments, const std::string& sentence) {
    const auto run = here.elsie("test-plugin " + arguments);
    CAPTURE(arguments, run.err);
    CHECK(run.exit_code == 2);
    CHECK_THAT(run.err, Contains(sentence));
    CHECK(run.out.empty());
  };
  refused("wandre", "there is no plugin 'wandre'; did you mean 'wander'?");
  refused("nowhere.so", "nowhere.so");
  refused("wander --set speed", "--set: expected NAME=VALUE, found 'speed'");
  refused("wander --set speed=fast", "--set speed=fast: expected a number");
  refused("wander --set speed=nan", "--set speed=nan: expected a number");
  refused("wander --set spede=1", "--set spede: none of these plugins has a parameter");
  refused("wander --element '<edit/>'", "none of these plugins has an element <edit>");
  refused("timetable --element '<edit when=\"1\"/>'", "<edit> has no such attribute");
  refused("timetable --element '<edit time=\"soon\"/>'", "expected a number");
  refused("timetable --element '<edit'", "--element");
  refused("wander --variants -1", "--variants");
  refused("", "PLUGIN");
}
