// elsie report, as users and CI servers call it.
#include <filesystem>
#include <iterator>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "made_up.h"
#include "program.h"

namespace fs = std::filesystem;
using Catch::Contains;
using elsie::test::MadeExperiment;
using elsie::test::Workplace;

namespace {

// Its worlds and plugins do not exist: a report does not need them.
std::string experiment_text(const std::string& expectations) {
  return "<experiment format=\"1\" name=\"made up\">\n"
         "  <worlds><world id=\"w\" file=\"nowhere.xml\"/></worlds>\n"
         "  <vary name=\"scheme\" path=\"robot[r1]/coordinator\">\n"
         "    <level label=\"a\"><no_such_plugin/></level>\n"
         "    <level label=\"b\"><neither/></level>\n"
         "  </vary>\n"
         "  <seeds from=\"1\" to=\"3\"/>\n"
         "  <expectations>" +
         expectations + "</expectations>\n</experiment>\n";
}

MadeExperiment experiment(const std::string& expectations) {
  MadeExperiment made_up = elsie::test::made_from({{60, 64, 68}, {30, 33, 36}});
  made_up.text = experiment_text(expectations);
  return made_up;
}

const std::string kMet =
    "<expect name=\"both succeed\" measure=\"success\" at_least=\"1\"/>"
    "<expect name=\"b is shorter\" measure=\"path_length_m\" where=\"scheme=b\" "
    "ratio_to=\"scheme=a\" at_most=\"0.6\" confidence=\"0.95\"/>";
const std::string kMissed =
    "<expect name=\"both are short\" measure=\"path_length_m\" at_most=\"40\"/>";

}  // namespace

TEST_CASE("report prints cells, measures and expectations; 0 when all is as expected") {
  Workplace here;
  write_database(experiment(kMet), here.file("runs.sqlite"));
  const auto run = here.elsie("report runs.sqlite");
  CHECK(run.exit_code == 0);
  CHECK(run.err.empty());
  CHECK_THAT(run.out, Contains("a          3/3     64.0 +- 4.0"));
  CHECK_THAT(run.out, Contains("b          3/3     33.0 +- 3.0"));
  CHECK_THAT(run.out, Contains("  met      both succeed"));
  CHECK_THAT(run.out, Contains("  met      b is shorter"));
}

TEST_CASE("report ends with 1 when an expectation is not met, so that CI fails") {
  Workplace here;
  write_database(experiment(kMet + kMissed), here.file("runs.sqlite"));
  const auto run = here.elsie("report runs.sqlite");
  CHECK(run.exit_code == 1);
  CHECK(run.err.empty());
  CHECK_THAT(run.out, Contains("  NOT MET  both are short"));
  CHECK_THAT(run.out, Contains("mean path_length_m of a is 64 m (3 runs), expected at most 40 m"));
}

TEST_CASE("report ends with 1 when a run crashed, with 4 when one is only still to be done") {
  Workplace here;
  MadeExperiment made_up = experiment("");
  made_up.text = experiment_text("<expect measure=\"path_length_m\" at_least=\"0\"/>");
  made_up.cells[0].runs[1].measures.clear();
  const auto [state, exit_code] =
      GENERATE(std::pair<const char*, int>("crash", 1), std::pair<const char*, int>("pending", 4));
  made_up.cells[0].runs[1].state = state;
  write_database(made_up, here.file("runs.sqlite"));
  CHECK(here.elsie("report runs.sqlite").exit_code == exit_code);
}

TEST_CASE("report writes a page, a table and test cases; the database stays as it is") {
  Workplace here;
  write_database(experiment(kMet + kMissed), here.file("runs.sqlite"));
  const std::string before = here.read("runs.sqlite");
  const auto run =
      here.elsie("report runs.sqlite --html page.html --csv runs.csv --junit results.xml --quiet");
  CHECK(run.exit_code == 1);
  CHECK(run.out.empty());
  CHECK(run.err.empty());
  CHECK_THAT(here.read("page.html"), Catch::StartsWith("<!doctype html>"));
  CHECK_THAT(here.read("page.html"), Contains("both are short"));
  CHECK_THAT(here.read("runs.csv"), Catch::StartsWith("run,cell,seed,"));
  CHECK_THAT(here.read("results.xml"), Contains("<testcase classname=\"made up\" name=\"both are "
                                                "short\""));
  CHECK(here.read("runs.sqlite") == before);
  // Again: the same bytes, at any place and time.
  const std::string page = here.read("page.html"), csv = here.read("runs.csv"),
                    junit = here.read("results.xml");
  here.sh(
      "LC_ALL=C.UTF-8 TZ=Asia/Tokyo COLUMNS=60 elsie report runs.sqlite --html page.html "
      "--csv runs.csv --junit results.xml --quiet || true");
  CHECK(here.read("page.html") == page);
  CHECK(here.read("runs.csv") == csv);
  CHECK(here.read("results.xml") == junit);
  for (const auto& entry : fs::directory_iterator(here.file("."))) {
    CHECK(entry.path().extension() != ".part");
  }
}

TEST_CASE("report --json prints one object and nothing else") {
  Workplace here;
  write_database(experiment(kMet), here.file("runs.sqlite"));
  const auto run = here.elsie("report runs.sqlite --json");
  const auto json = nlohmann::json::parse(run.out);
  CHECK(json["good"] == true);
  CHECK(json["expectations"][1]["cells"][0]["value"] == Approx(33.0 / 64.0));
}

TEST_CASE("report refuses bad input in a sentence, with exit code 2") {
  Workplace here;
  write_database(experiment(kMet), here.file("runs.sqlite"));
  here.write("text.sqlite", std::string(200, 'x'));
  here.write("empty.sqlite", "");
  here.write("short.sqlite", here.read("runs.sqlite").substr(0, 5000));
  fs::create_directory(here.file("folder"));
  fs::create_directory(here.file("folder.html"));
  REQUIRE(here.sh("sqlite3 other.sqlite 'CREATE TABLE about (id INTEGER)'\n"
                  "cp runs.sqlite newer.sqlite; sqlite3 newer.sqlite 'PRAGMA user_version = 99'\n"
                  "cp runs.sqlite planless.sqlite; sqlite3 planless.sqlite 'DELETE FROM about'\n"
                  "cp runs.sqlite broken.sqlite\n"
                  "sqlite3 broken.sqlite \"UPDATE about SET text = '<experiment>'\"\n"
                  "cp runs.sqlite runs.html")
              .exit_code == 0);
  const auto refused = [&](const std::string& arguments, const std::string& why) {
    const auto run = here.elsie("report " + arguments);
    CAPTURE(arguments);
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    CHECK_THAT(run.err, Contains(why));
  };
  refused("", "DATABASE is missing");
  refused("missing.sqlite", "there is no database 'missing.sqlite'");
  refused("folder", "'folder' is a directory; expected a database");
  refused("empty.sqlite", "'empty.sqlite' is empty");
  refused("text.sqlite", "'text.sqlite' is not an SQLite database");
  refused("short.sqlite", "the database 'short.sqlite' is damaged (");
  refused("other.sqlite", "'other.sqlite' is a database of another program");
  refused("newer.sqlite", "the database 'newer.sqlite' has version 99 of the schema");
  refused("planless.sqlite", "'planless.sqlite' was not begun: its batch ended before");
  refused("broken.sqlite", "<experiment>");
  refused("runs.sqlite --html page.txt", "--html: expected a name that ends in .html");
  refused("runs.sqlite --csv runs.sqlite",
          "--csv: 'runs.sqlite' is read here, and its content would be lost");
  refused("runs.sqlite --junit nowhere/results.xml", "there is no folder 'nowhere'");
  refused("runs.sqlite --html folder.html", "cannot write 'folder.html': it is a directory");
  refused("runs.sqlite --csv ''", "--csv");
  refused("runs.html --html runs.html",
          "--html: 'runs.html' is read here, and its content would be lost");
  // A folder that takes no new files, whatever its permissions; nothing is written before.
  refused("runs.sqlite --csv early.csv --html /proc/page.html",
          "--html: cannot write '/proc/page.html'");
  CHECK_FALSE(fs::exists(here.file("early.csv")));
  refused("runs.sqlite --cells a", "--html");
  refused("runs.sqlite --csv early.csv --html page.html --cells nowhere",
          "--cells: no cell's name contains 'nowhere'; expected a part of a name, as of 'a'");
  CHECK_FALSE(fs::exists(here.file("early.csv")));
  CHECK_FALSE(fs::exists(here.file("page.html")));
  refused("runs.sqlite --json --quiet", "--quiet");
  refused("runs.sqlite --pdf page.pdf", "--pdf");
  CHECK_FALSE(fs::exists(here.file("missing.sqlite")));
  CHECK(here.read("runs.html") == here.read("runs.sqlite"));
}

TEST_CASE("report ends with 4 when the disk is full, and leaves existing files") {
  Workplace here;
  write_database(experiment(kMet), here.file("runs.sqlite"));
  for (const std::string option : {"csv", "junit", "html"}) {
    const auto device = here.elsie("report runs.sqlite --quiet --" + option + " /dev/full");
    CHECK(device.exit_code == 4);
    CHECK_THAT(device.err, Contains("--" + option + ": '/dev/full' could not be written"));
    // No file may grow beyond this, as on a full disk.
    const std::string file = "out." + std::string(option == "junit" ? "xml" : option);
    REQUIRE(here.elsie("report runs.sqlite --quiet --" + option + " " + file).exit_code == 0);
    const std::string before = here.read(file);
    const auto full =
        here.sh("ulimit -f 1; elsie report runs.sqlite --quiet --" + option + " " + file);
    CHECK(full.exit_code == 4);
    CHECK_THAT(full.err, Contains("could not be written: File too large"));
    CHECK(here.read(file) == before);
    CHECK_FALSE(fs::exists(here.file(file + ".part")));
  }
  const auto json = here.sh("elsie report runs.sqlite --json > /dev/full");
  CHECK(json.exit_code == 4);
  CHECK_THAT(json.err, Contains("standard output could not be written"));
}

TEST_CASE("report replaces what it wrote before, through a link too, and writes to devices") {
  Workplace here;
  write_database(experiment(kMet), here.file("runs.sqlite"));
  here.write("target.csv", "run,cell,seed,of a run before\n");
  fs::create_symlink("target.csv", here.file("link.csv"));
  REQUIRE(here.elsie("report runs.sqlite --quiet --csv link.csv").exit_code == 0);
  CHECK(fs::is_symlink(here.file("link.csv")));
  CHECK_THAT(here.read("target.csv"), Catch::StartsWith("run,cell,seed,"));
  const auto run = here.sh("elsie report runs.sqlite --quiet --csv /dev/stdout | cat");
  CHECK(run.exit_code == 0);
  CHECK(run.out == here.read("target.csv"));
}

TEST_CASE("From an experiment to its page: batch, report, replay") {
  Workplace here;
  here.write("beams.xml",
             "<experiment format=\"1\" name=\"beams\">\n"
             "  <worlds><world file=\"worlds/clutter.xml\"/></worlds>\n"
             "  <set path=\"goals\"><goals><travel distance=\"100\"/></goals></set>\n"
             "  <vary path=\"robot[r1]/coordinator\">\n"
             "    <level label=\"fusion\"><fusion_vector_summation/></level>\n"
             "    <level label=\"arbitration\"><arbiter_suppression/></level>\n"
             "  </vary>\n"
             "  <seeds from=\"1\" to=\"3\"/>\n"
             "  <limits time=\"10\"/>\n"
             "  <expectations><expect measure=\"time_s\" at_least=\"9.9\"/>"
             "</expectations>\n"
             "</experiment>\n");
  REQUIRE(here.elsie("batch beams.xml --database beams.sqlite --quiet").exit_code == 0);
  const auto run = here.elsie("report beams.sqlite --html beams.html");
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.out, Contains("fusion"));
  const std::string page = here.read("beams.html");
  CHECK_THAT(page, Contains("Who decided when"));
  CHECK_THAT(page, Contains("<path class=\"way"));
  // No run reached its goals: each is notable, and its command works.
  CHECK_THAT(page, Contains("elsie replay beams.sqlite 6</code>"));
  CHECK(here.sh("elsie replay beams.sqlite 6 --quiet").exit_code == 0);
}

TEST_CASE("A world without goals: neither the batch nor its report has a rate of success") {
  Workplace here;
  here.write("aimless.xml",
             "<experiment format=\"1\" name=\"aimless\">\n"
             "  <worlds><world file=\"worlds/open_arena.xml\"/></worlds>\n"
             "  <set path=\"goals\"><goals/></set>\n"
             "  <seeds from=\"1\" to=\"2\"/>\n  <limits time=\"1\"/>\n</experiment>\n");
  const auto batch = here.elsie("batch aimless.xml --workers 1");
  CHECK(batch.exit_code == 0);
  CHECK_THAT(batch.out, Contains("  no goals\n") && !Contains("0 %"));
  const auto summary = nlohmann::json::parse(here.elsie("batch aimless.xml --resume --json").out);
  CHECK(summary["successes"].is_null());
  CHECK(summary["cells"][0]["successes"].is_null());
  const auto report = here.elsie("report aimless.sqlite --csv runs.csv");
  CHECK(report.exit_code == 0);
  CHECK_THAT(report.out, Contains("no goals") && !Contains("0/2"));
  CHECK_THAT(here.read("runs.csv"), Contains(",no_goals,"));
}

TEST_CASE(
    "A world whose only goal is about time has a rate of success, in batch and report alike") {
  Workplace here;
  here.write("lasting.xml",
             "<experiment format=\"1\" name=\"lasting\">\n"
             "  <worlds><world file=\"worlds/open_arena.xml\"/></worlds>\n"
             "  <set path=\"goals\"><goals><endure time=\"1\"/></goals></set>\n"
             "  <seeds from=\"1\" to=\"2\"/>\n</experiment>\n");
  CHECK_THAT(here.elsie("batch lasting.xml --workers 1").out, Contains("100 %"));
  const auto report = here.elsie("report lasting.sqlite");
  CHECK(report.exit_code == 0);
  CHECK_THAT(report.out, Contains("2/2") && !Contains("no goals"));
}

TEST_CASE("report answers questions by factor, and writes figures and tables") {
  Workplace here;
  write_database(experiment(kMet), here.file("runs.sqlite"));
  const auto run = here.elsie(
      "report runs.sqlite --by scheme --compare scheme=b scheme=a --model 'path_length_m ~ scheme' "
      "--figures figures --format svg,pdf --latex t.tex --cells-csv c.csv");
  CHECK(run.exit_code == 0);
  CHECK(run.err.empty());
  CHECK_THAT(run.out, Catch::StartsWith("By factor, over all else\n"));
  CHECK_THAT(run.out, Contains("scheme=b"));
  CHECK_THAT(run.out, Contains("Linear model path_length_m ~ scheme"));
  CHECK(fs::exists(here.file("figures/effect-path_length_m-scheme.svg")));
  CHECK(fs::exists(here.file("figures/effect-path_length_m-scheme.pdf")));
  CHECK_FALSE(fs::exists(here.file("figures/effect-path_length_m-scheme.png")));
  CHECK_THAT(here.read("t.tex"), Contains("\\toprule"));
  CHECK_THAT(here.read("c.csv"), Catch::StartsWith("cell,runs,successes,"));
  // Once more, over what is there.
  CHECK(here.elsie("report runs.sqlite --quiet --figures figures --latex t.tex --cells-csv c.csv")
            .exit_code == 0);
}

TEST_CASE("report --by prints its own table only, and what is wrong in a line") {
  Workplace here;
  write_database(experiment(kMet), here.file("good.sqlite"));
  write_database(experiment(kMet + kMissed), here.file("bad.sqlite"));
  const auto good = here.elsie("report good.sqlite --by scheme");
  CHECK(good.exit_code == 0);
  CHECK_THAT(good.out, Catch::StartsWith("By factor, over all else\n") && Contains("\na ") &&
                           !Contains("Expectations") && !Contains("expectation"));
  const auto bad = here.elsie("report bad.sqlite --by scheme");
  CHECK(bad.exit_code == 1);
  CHECK_THAT(bad.out, Contains("\n1 of 3 expectations is not met; the report without questions has "
                               "the details\n") &&
                          !Contains("NOT MET"));
}

TEST_CASE("A folder with the name of a figure is bad input, and nothing is written") {
  Workplace here;
  write_database(experiment(kMet), here.file("runs.sqlite"));
  fs::create_directories(here.file("figures/success.svg"));
  const auto run = here.elsie(
      "report runs.sqlite --figures figures --html page.html --csv runs.csv --cells-csv cells.csv");
  CHECK(run.exit_code == 2);
  CHECK(run.out.empty());
  CHECK_THAT(run.err, Contains("--figures: 'figures/success.svg' is a folder, and a figure has "
                               "this name; remove it, or name another folder for the figures"));
  for (const char* file : {"page.html", "runs.csv", "cells.csv"}) {
    CAPTURE(file);
    CHECK_FALSE(fs::exists(here.file(file)));
  }
  CHECK(std::distance(fs::directory_iterator(here.file("figures")), {}) == 1);
}

TEST_CASE("report refuses questions without an answer before it writes anything") {
  Workplace here;
  write_database(experiment(kMet), here.file("runs.sqlite"));
  here.write("file", "mine");
  const std::pair<const char*, const char*> wrong[] = {
      {"--by schema", "no factor 'schema' is varied"},
      {"--compare scheme=a scheme=a", "cannot be compared with itself"},
      {"--compare a a", "cannot be compared with itself"},
      {"--compare scheme=a", "--compare"},
      {"--compare scheme=c scheme=a", "'scheme' has no level 'c'"},
      {"--model 'speed ~ scheme'", "there is no measure 'speed'"},
      {"--model path_length_m", "is no formula"},
      {"--figures file", "it is no folder"},
      {"--figures no/such/folder", "--figures: cannot write figures into 'no/such/folder'"},
      {"--figures /proc", "--figures: cannot write figures into '/proc'"},
      {"--figures figures --format gif", "gif"},
      {"--format svg", "--figures"},
      {"--latex table.txt", "expected a name that ends in .tex"},
      {"--cells-csv cells.txt", "expected a name that ends in .csv"}};
  for (const auto& [options, sentence] : wrong) {
    CAPTURE(options);
    const auto run =
        here.elsie("report runs.sqlite --html page.html --figures new " + std::string(options));
    const auto alone = here.elsie("report runs.sqlite --html page.html " + std::string(options));
    CAPTURE(alone.out, alone.err);
    CHECK(alone.exit_code == 2);
    CHECK_THAT(alone.err, Contains(sentence));
    CHECK(alone.out.empty());
    CHECK((run.exit_code == 2 || std::string(options) == "--format svg"));
    CHECK_FALSE(fs::exists(here.file("figures")));
    if (run.exit_code == 2) {
      CHECK_FALSE(fs::exists(here.file("page.html")));
      CHECK_FALSE(fs::exists(here.file("new")));
    }
    fs::remove(here.file("page.html"));
    fs::remove_all(here.file("new"));
  }
  CHECK(here.read("file") == "mine");
}

TEST_CASE("Two reports draw into one folder at once, and an interrupted one leaves nothing there") {
  Workplace here;
  write_database(experiment(kMet), here.file("runs.sqlite"));
  const std::string draw = "elsie report runs.sqlite --quiet --format pdf,png --figures ";
  const auto both = here.sh(draw + "figures & first=$!\n" + draw +
                            "figures; second=$?\nwait $first; echo $? $second; ls -A figures");
  CHECK_THAT(both.out, Catch::StartsWith("0 0\n") && !Contains(".elsie"));
  const auto interrupted =
      here.sh(draw +
              "new & p=$!\n"
              "until ls -A | grep -q '^\\.elsie-' || ! kill -0 $p; do :; done\n"
              "kill -TERM $p; wait $p; echo $?; ls -A | grep -e elsie- -e new");
  CHECK_THAT(interrupted.out, Catch::Equals("4\n") || !Contains("elsie-"));  // or it had ended
}
