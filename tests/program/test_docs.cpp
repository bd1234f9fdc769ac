#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "elsie/api/abi.h"

#include "pages.h"
#include "program.h"

using namespace elsie::test;

namespace {

/// Commands that end a run before its goal is met (exit code 1) on purpose, because a short run
/// shows enough. All others must reach their goals.
const std::set<std::string> kCutShort = {
    "elsie run worlds/open_arena.xml --seed 5 --duration 6 --record edited.mcap "
    "--at '2:obstacle[+]=<static_box x=\"1\" y=\"1\"/>' --at '3:robot[r1]/@max_speed=0.2'",
    "elsie run edited.xml --seed 5 --duration 6",
    "elsie run worlds/ten_robots.xml --duration 60 --record run.mcap",
    "elsie run worlds/open_arena.xml --duration 10 --json",
    "elsie run worlds/open_arena.xml --duration 12 --at '3:obstacle[+]=<static_box id=\"block\" "
    "x=\"1.5\" y=\"1.5\"/>' --at '5:robot[+]=<robot id=\"late\" x=\"-1.5\" y=\"1.5\"/>' "
    "--at '9:robot[late]/@remove=true'",
    "elsie run worlds/open_arena.xml --duration 12 --at '4:physics/@step=0.005' "
    "--at '6:robot[r1]/coordinator=<arbiter_suppression/>'",
    "elsie run worlds/open_arena.xml --duration 12 --at '4:robot[r1]/@max_speed=0.1' "
    "--at '8:robot[r1]/@x=-1' --at '8:robot[r1]/@y=1'",
    "for seed in 1 2 3; do elsie run worlds/open_arena.xml --duration 20 --seed $seed --json; done "
    "> runs.jsonl",
    "elsie run worlds/ten_robots.xml --duration 60 --picture last.png --picture-fade 10",
    "elsie run worlds/ten_robots.xml --duration 60 --picture two.svg --picture-robots r1,r2 "
    "--picture-from 20 --picture-to 40",
    "elsie run worlds/find_resource.xml --duration 20 --picture found.png",
    "elsie run worlds/find_resource.xml --duration 3 --save-images images --save-images-every 0.5",
    "elsie report obstacles.sqlite --html obstacles.html"};

/// Long command lines, with additions that shorten them here.
const std::map<std::string, std::string> kInPart = {
    {"elsie batch experiments/obstacles.xml", " --shard 1/120 --database obstacles.sqlite"},
    {"elsie run worlds/scattered/swarm.xml --set arena/@length=60 --set arena/@width=60",
     " --set endure/@time=1"}};

/// The line without blanks and a comment at its end, unless it has quotation marks.
std::string command_of(const std::string& line) {
  const std::size_t comment = line.find(" #");
  const std::string command =
      line.substr(0, line.find_first_of("'\"") > comment ? comment : line.npos);
  return command.substr(0, command.find_last_not_of(' ') + 1);
}

/// Whether a line builds or installs the program under test, or a plugin of the reader:
/// tests/package/ runs those.
bool builds(const std::string& line) {
  return line.starts_with("make ") || line.starts_with("cmake ") || line.starts_with("sudo ") ||
         line.find("venv") != line.npos;
}

}  // namespace

TEST_CASE("Every command in the docs runs, and reaches its goals unless it is cut short") {
  std::set<std::string> cut_short, done_in_part;
  for (const fs::path& page : pages()) {
    if (page.parent_path().filename() == "tutorial") {
      continue;  // tests/tutorial follows it as a whole
    }
    if (page.filename() == "clusters.md") {
      continue;  // test_cluster.cpp runs it with a Slurm
    }
    Workplace here;
    if (page.filename() == "installing.md") {
      here.sh("cp examples/01-first-behavior/world.xml world.xml; ln -s '" +
              elsie::test::build_path("examples") + "' build");
    }
    for (const std::string& block : blocks(read(page), "sh")) {
      std::istringstream lines(block);
      for (std::string line; std::getline(lines, line);) {
        // Text in quotation marks may continue on the next line.
        for (std::string more;
             std::count(line.begin(), line.end(), '"') % 2 != 0 && std::getline(lines, more);) {
          line += '\n' + more;
        }
        if (builds(line)) {
          continue;
        }
        CAPTURE(page.filename().string(), line);
        const auto long_one = kInPart.find(command_of(line));
        const auto run =
            here.sh(long_one == kInPart.end() ? line : long_one->first + long_one->second);
        if (long_one != kInPart.end()) {
          done_in_part.insert(long_one->first);
        }
        CAPTURE(run.err);
        const bool ends_early = kCutShort.contains(line);
        // 4: the report of an experiment that was cut short knows some answers not yet.
        CHECK((ends_early ? run.exit_code == 1 || run.exit_code == 4 : run.exit_code == 0));
        CHECK(run.err.empty());
        if (ends_early) {
          cut_short.insert(line);
        }
      }
    }
  }
  // The list has no commands that the docs no longer have.
  CHECK(cut_short == kCutShort);
  CHECK(done_in_part.size() == kInPart.size());
}

TEST_CASE("Every world in the docs is in order") {
  for (const fs::path& page : pages()) {
    if (page.parent_path().filename() == "tutorial") {
      continue;  // tests/tutorial follows it as a whole
    }
    for (const std::string& block : blocks(read(page), "xml")) {
      if (block.find("<world") == std::string::npos) {
        continue;  // only a part of a world
      }
      CAPTURE(page.filename().string(), block);
      Workplace here;
      here.write("worlds.xml", block);
      const auto run =
          here.elsie("check worlds.xml --plugin-path " + elsie::test::build_path("examples"));
      CAPTURE(run.err);
      CHECK(run.exit_code == 0);
    }
  }
}

TEST_CASE("The experiment that its page shows is in order with each piece that is added") {
  const std::string page =
      read(fs::path(elsie::test::source_path("docs")) / "writing-an-experiment.md");
  const auto pieces = blocks(page, "xml");
  REQUIRE(pieces.size() >= 5);
  std::string experiment = pieces.front();
  std::string found;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (i > 0) {
      experiment.insert(experiment.find("</experiment>"), pieces[i]);
    }
    CAPTURE(experiment);
    Workplace here;
    here.write("my_experiment.xml", experiment);
    const auto run = here.elsie("check my_experiment.xml");
    CHECK(run.err.empty());
    CHECK(run.exit_code == 0);
    found = run.out;
  }
  CHECK(found == "my_experiment.xml: in order: 88 cells, 1760 runs, 4 expectations\n");
  CHECK_THAT(page, Catch::Contains("the experiment has 48 cells"));
  CHECK_THAT(page, Catch::Contains("That makes 88 cells"));
}

TEST_CASE("The page on behaviours quotes the example as it is built") {
  const fs::path source(elsie::test::source_path(""));
  const auto code = blocks(read(source / "docs" / "writing-a-behavior.md"), "cpp");
  REQUIRE(code.size() == 4);  // the other three are run below
  CHECK(code[0] == read(source / "examples" / "01-first-behavior" / "shy.cpp"));
}

TEST_CASE("The behaviour that the page on behaviours adds raises its event, and nothing is wrong") {
  const fs::path docs(elsie::test::source_path("docs"));
  Workplace here;
  here.write("brake.cpp", blocks(read(docs / "writing-a-behavior.md"), "cpp").at(1));
  const auto check = here.sh("ELSIE_CACHE=cache elsie test-plugin brake.cpp");
  CAPTURE(check.out, check.err);
  CHECK(check.exit_code == 0);
  const auto run = here.sh(
      "ELSIE_CACHE=cache elsie run worlds/open_arena.xml --duration 120 --plugin brake.cpp "
      "--set 'robot[r1]/behavior[avoid_obstacle]=<brake/>' "
      "--set 'robot[r1]/coordinator=<arbiter_strength/>'");
  CAPTURE(run.err);
  CHECK_THAT(run.out, Catch::Contains("events: came_near "));
}

TEST_CASE("The elements and the nesting that the page on behaviours adds do as it says") {
  const std::string page =
      read(fs::path(elsie::test::source_path("docs")) / "writing-a-behavior.md");
  Workplace here;
  here.write("visit.cpp", blocks(page, "cpp").at(2) + blocks(page, "cpp").at(3));
  const auto check = here.sh("ELSIE_CACHE=cache elsie test-plugin visit.cpp");
  CAPTURE(check.out, check.err);
  CHECK(check.exit_code == 0);
  const auto time_to_goal = [&](const std::string& behavior) {
    here.write("world.xml",
               "<world format='1'><robots><robot id='r1'><behaviors>" + behavior +
                   "</behaviors><coordinator><arbiter_suppression/></coordinator></robot></robots>"
                   "<goals><reach robot='r1' x='1' y='1' radius='0.1'/></goals></world>");
    const auto run = here.sh("ELSIE_CACHE=cache elsie run world.xml --plugin visit.cpp --json");
    CAPTURE(run.out, run.err);
    CHECK(run.exit_code == 0);
    return nlohmann::json::parse(run.out)["simulated_s"].get<double>();
  };
  const std::string slowly = blocks(page, "xml").at(2);
  REQUIRE_THAT(slowly, Catch::StartsWith("<slowly"));
  const std::size_t from = slowly.find("<visit"), to = slowly.find("</behaviors>");
  const double alone = time_to_goal(slowly.substr(from, to - from));
  CHECK(time_to_goal(slowly) == Approx(2.0 * alone).epsilon(0.1));
}

TEST_CASE("The coordinator and the sensor that their pages add are sound") {
  const fs::path docs(elsie::test::source_path("docs"));
  const auto plugin_with = [&](const char* page, const char* word) {
    for (const std::string& block : blocks(read(docs / page), "cpp")) {
      if (block.find(word) != std::string::npos) {
        return block;
      }
    }
    return std::string();
  };
  Workplace here;
  here.write("best_wish.cpp",
             plugin_with("writing-a-coordinator.md", "ELSIE_COORDINATOR(BestWish"));
  here.write("glare.cpp", plugin_with("writing-a-sensor.md", "ELSIE_SENSOR(Glare"));
  here.write("echo.cpp", plugin_with("writing-a-sensor.md", "ELSIE_SENSOR(Echo"));
  here.write("whisker.cpp", plugin_with("writing-a-sensor.md", "ELSIE_SENSOR(Whisker"));
  const auto check =
      here.sh("ELSIE_CACHE=cache elsie test-plugin best_wish.cpp glare.cpp echo.cpp whisker.cpp");
  CAPTURE(check.out, check.err);
  CHECK(check.exit_code == 0);
  // Alone, and inside of a behaviour whose coordinator asks further.
  for (const char* outer : {"<best_wish/>", "<arbiter_voting/>"}) {
    here.write("world.xml",
               "<world format='1'><robots><robot id='r1' x='-2'><sensors><beam_range/></sensors>"
               "<behaviors><blend><behaviors><avoid_obstacle/><go_to_point x='1' y='1'/>"
               "</behaviors><coordinator><best_wish/></coordinator></blend></behaviors>"
               "<coordinator>" +
                   std::string(outer) +
                   "</coordinator></robot></robots>"
                   "<goals><reach robot='r1' x='1' y='1' radius='0.3'/></goals></world>");
    const auto run = here.sh("ELSIE_CACHE=cache elsie run world.xml --plugin best_wish.cpp");
    CAPTURE(outer, run.out, run.err);
    CHECK(run.exit_code == 0);
  }
  const auto seen = here.sh(
      "ELSIE_CACHE=cache elsie run worlds/open_arena.xml --duration 1 --plugin glare.cpp "
      "--set 'robot[r1]/sensor[1]=<glare z=\"0\"/>'");
  CHECK(seen.exit_code == 2);
  CHECK_THAT(seen.err, Catch::Contains("it is mounted on the floor"));
}

TEST_CASE("The page on Elsie as a library quotes the example as it is built") {
  const fs::path source(elsie::test::source_path(""));
  const fs::path example = source / "examples" / "05-own-program";
  const std::string page = read(source / "docs" / "elsie-as-a-library.md");
  CHECK(blocks(page, "cpp").at(0) == read(example / "main.cpp"));
  CHECK(blocks(page, "cmake").at(0) == read(example / "CMakeLists.txt"));
}

TEST_CASE("A program of one's own runs a shipped world by its name from any folder") {
  Workplace here;
  const std::string same_bits = "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX,-AVX2,-FMA,-FMA4 ";
  const auto own = here.sh("cd / && " + same_bits + elsie::test::build_path("examples") +
                           "/own_program worlds/contexts.xml 3");
  CAPTURE(own.out, own.err);
  CHECK(own.exit_code == 0);
  CHECK_THAT(own.out, Catch::StartsWith("success after "));
  const auto run =
      here.sh("cd / && " + same_bits + "elsie run worlds/contexts.xml --seed 3 --json");
  CHECK_THAT(own.out, Catch::EndsWith(
                          "state hash " +
                          nlohmann::json::parse(run.out)["state_hash"].get<std::string>() + "\n"));
  CHECK(
      here.sh("cd / && " + elsie::test::build_path("examples") + "/own_program worlds/contxts.xml")
          .exit_code == 2);
}

TEST_CASE("The page on sessions quotes the example, which edits and runs a world") {
  const fs::path source(elsie::test::source_path(""));
  CHECK(blocks(read(source / "docs" / "internals" / "session.md"), "cpp").at(0) ==
        read(source / "examples" / "07-session" / "main.cpp"));
  Workplace here;
  const std::string program = elsie::test::build_path("examples") + "/own_session " +
                              elsie::test::build_path("bin/elsie") + " ";
  const auto session = here.sh(program + "worlds/clutter.xml '@name=edited'");
  CAPTURE(session.out, session.err);
  CHECK(session.exit_code == 0);
  const auto run = nlohmann::json::parse(here.elsie("run worlds/clutter.xml --json").out);
  CHECK(session.out == "success " + run["state_hash"].get<std::string>() + "\n");

  const auto refused = here.sh(program + "worlds/clutter.xml 'robot[r9]/@x=1'");
  CHECK(refused.exit_code == 2);
  CHECK_THAT(refused.err, Catch::Contains("r9"));
}

TEST_CASE("The examples of inference load nothing of the core") {
  Workplace here;
  for (const std::string program : {"braking", "exclusive_or"}) {
    const std::string file = elsie::test::build_path("examples") + "/" + program;
    const auto run = here.sh(file);
    CAPTURE(program, run.out, run.err);
    CHECK(run.exit_code == 0);
    const std::string libraries =
        here.sh("ldd " + file + " | grep -o 'libelsie[a-z-]*' | sort -u").out;
    CHECK(libraries == "libelsie-base\nlibelsie-files\nlibelsie-inference\n");
  }
  CHECK(here.sh(elsie::test::build_path("examples") + "/braking 0.5 4").out ==
        "0.5 m, 4.0 m/s: brake 0.797\n");
}

TEST_CASE("The page on measures quotes what elsie new makes, and its output") {
  const std::string page =
      read(fs::path(elsie::test::source_path("docs")) / "writing-a-measure.md");
  const auto code = blocks(page, "cpp"), output = blocks(page, "text");
  REQUIRE(code.size() == 2);
  REQUIRE(output.size() == 1);
  Workplace here;
  REQUIRE(here.elsie("new measure excursion").exit_code == 0);
  CHECK(code[0] == here.read("excursion/excursion.cpp"));
  CHECK(code[1] == here.read("excursion/test_excursion.cpp"));
  const auto run =
      here.sh("ELSIE_CACHE=cache elsie run excursion/world.xml --plugin excursion/excursion.cpp");
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.out, Catch::EndsWith(output[0]));
}

TEST_CASE("The page on rules quotes what elsie new makes") {
  const auto code =
      blocks(read(fs::path(elsie::test::source_path("docs")) / "writing-a-rule.md"), "cpp");
  REQUIRE(code.size() == 2);
  Workplace here;
  REQUIRE(here.elsie("new rule refill").exit_code == 0);
  CHECK(code[0] == here.read("refill/refill.cpp"));
  CHECK(code[1] == here.read("refill/test_refill.cpp"));
  const auto run =
      here.sh("ELSIE_CACHE=cache elsie run refill/world.xml --plugin refill/refill.cpp --json");
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.out, Catch::Contains("robot[r1]/@energy=10, by the rule 'refill'"));
  CHECK(here.elsie("run refill/world.xml --plugin refill/refill.cpp --set 'rule[refill]/@below=0'")
            .exit_code == 1);
}

TEST_CASE("The page on actuators quotes what elsie new makes") {
  const auto code =
      blocks(read(fs::path(elsie::test::source_path("docs")) / "writing-an-actuator.md"), "cpp");
  REQUIRE(code.size() == 3);
  Workplace here;
  REQUIRE(here.elsie("new actuator flare").exit_code == 0);
  CHECK(code[0] == here.read("flare/flare_command.h"));
  CHECK(code[1] == here.read("flare/flare.cpp"));
  CHECK(code[2] == here.read("flare/test_flare.cpp"));
  CHECK(here.sh("ELSIE_CACHE=cache elsie test-plugin flare/flare.cpp").exit_code == 0);
}

TEST_CASE("The measures that pages show are in order in a world that has what they name") {
  const std::string robots = R"(<fields><field id="pheromone"/></fields><robots>
      <robot id="r1"><behaviors><avoid_obstacle/><wander/></behaviors>
        <sensors><beam_range/></sensors>
        <coordinator><arbiter_suppression/></coordinator></robot>
      <robot id="leader" x="1" leader="true"/><robot id="f1" x="2"/><robot id="f2" x="3"/>
      <robot id="f3" x="-1"/><robot id="b1" x="-2" team="blue"/>
    </robots>)";
  int count = 0;
  for (const fs::path& page : pages()) {
    for (const std::string& block : blocks(read(page), "xml")) {
      if (!block.starts_with("<measures>")) {
        continue;
      }
      ++count;
      CAPTURE(page.filename().string(), block);
      Workplace here;
      here.write("world.xml", "<world format=\"1\">" + robots + block + "</world>");
      const auto run = here.elsie("check world.xml");
      CHECK(run.err.empty());
      CHECK(run.exit_code == 0);
    }
  }
  CHECK(count >= 12);
}

TEST_CASE(
    "The pages on testing, coordinators and sensors show what is built and run by the tests") {
  // Without formatting: the page does not indent.
  const auto plain = [](const std::string& code) {
    std::istringstream lines(code);
    std::string text;
    for (std::string line; std::getline(lines, line);) {
      text += line.substr(std::min(line.find_first_not_of(' '), line.size())) + '\n';
    }
    return text;
  };
  const fs::path source(elsie::test::source_path(""));
  std::string run;
  for (const char* file :
       {"tests/testing/test_snippets.cpp", "tests/testing/without_framework.cpp",
        "examples/01-first-behavior/test_shy.cpp", "examples/01-first-behavior/CMakeLists.txt",
        "examples/02-coordinator/fusion_activity.cpp",
        "examples/02-coordinator/test_fusion_activity.cpp",
        "examples/03-new-sensor/gyrocompass.cpp", "examples/03-new-sensor/gyrocompass_reading.h",
        "examples/03-new-sensor/test_gyrocompass.cpp"}) {
    run += plain(read(source / file));
  }
  std::size_t shown = 0;
  for (const char* name :
       {"testing-a-plugin.md", "writing-a-coordinator.md", "writing-a-sensor.md"}) {
    const std::string page = read(source / "docs" / name);
    for (const char* language : {"cpp", "cmake"}) {
      for (const std::string& block : blocks(page, language)) {
        if (block.find("BestWish") != std::string::npos ||
            block.find("Glare") != std::string::npos || block.find("Echo") != std::string::npos ||
            block.find("Whisker") != std::string::npos) {
          continue;  // run above
        }
        CAPTURE(name, block);
        CHECK(run.find(plain(block)) != std::string::npos);
        ++shown;
      }
    }
  }
  CHECK(shown >= 22);
}

TEST_CASE("The first example is a plugin of fewer than 30 lines that does its job") {
  const fs::path source = elsie::test::source_path("examples/01-first-behavior/shy.cpp");
  const std::string code = read(source);
  CHECK(std::count(code.begin(), code.end(), '\n') < 30);
}

TEST_CASE("The examples do their jobs") {
  Workplace here;
  for (const std::string example : {"01-first-behavior", "02-coordinator", "03-new-sensor"}) {
    const auto run = here.elsie("run examples/" + example + "/world.xml --plugin-path " +
                                elsie::test::build_path("examples"));
    CAPTURE(example, run.out, run.err);
    CHECK(run.exit_code == 0);
  }
}

TEST_CASE("The page on drives quotes what elsie new makes") {
  const std::string page = read(fs::path(elsie::test::source_path("docs")) / "writing-a-drive.md");
  const auto code = blocks(page, "cpp");
  REQUIRE(code.size() == 2);
  Workplace here;
  REQUIRE(here.elsie("new drive wide_track").exit_code == 0);
  CHECK(code[0] == here.read("wide_track/wide_track.cpp"));
  CHECK(code[1] == here.read("wide_track/test_wide_track.cpp"));
}
