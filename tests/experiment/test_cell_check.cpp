// Every cell is read before anything begins; each mistake is reported once, with its conditions.
#include <algorithm>

#include <catch2/catch.hpp>

#include "fixture.h"

using namespace elsie;
using namespace elsie::test;

TEST_CASE("A mistake in a setting is reported on its line, once for all cells that have it") {
  CHECK(problems(kTwoWorlds + "\n<set path='robot[r1]/@max_sped' value='1'/>\n"
                              "<vary path='robot[r1]/@coverage' values='1; 2'/>") ==
        "experiment.xml:2: <robot> has no attribute 'max_sped'; did you mean 'max_speed'?");
}

TEST_CASE("A mistake in some cells only is reported with what they have in common") {
  const std::string levels =
      "\n<vary path='robot[r1]/coordinator'><level><pick/></level><level><sum/></level></vary>\n";
  CHECK(problems(kTwoWorlds + levels +
                 "<vary path='robot[r1]/coordinator/@weighted' "
                 "values='true; false'/>") ==
        "experiment.xml:3: <pick> has no attribute 'weighted'; it may have: id, remove (with "
        "coordinator=pick)");
  CHECK(problems(kTwoWorlds + "\n<set path='obstacle[crate]/@mass' value='1'/>") ==
        "experiment.xml:2: there is no 'obstacle' in <world> of this world (with world=arena)");
}

TEST_CASE("An element may be there in some cells and not in others") {
  const std::string without = "\n<vary path='robot[r2]/@remove' values='false; true'/>";
  const experiment::Experiment e = read(kArena + without);
  const auto grid = experiment::cells(e);
  REQUIRE(grid.size() == 2);
  CHECK(experiment::read_cell(e, grid[0], host(), options()).robots.size() == 2);
  CHECK(experiment::read_cell(e, grid[1], host(), options()).robots.size() == 1);
  CHECK_THAT(problems(kArena + "\n<vary path='robot[r2]/coordinator/@remove' "
                               "values='false; true'/>"),
             Catch::Contains("the robot 'r2' has behaviours but no coordinator"));
  CHECK(problems(kArena + "\n<set path='robots/@remove' value='true'/>") ==
        "experiment.xml:2: <robots> is a list and cannot be removed; to empty it, remove what "
        "stands in it: robot[*]/@remove");
}

TEST_CASE("A mistake that needs two settings is reported for the cell that has both") {
  CHECK(problems(kArena + "\n<vary path='robot[r1]/behavior[roam]/@shy' values='false; true'/>\n"
                          "<vary path='robot[r1]/behavior[roam]/@mood' values='calm; bold'/>") ==
        "data/arena.xml:6: behavior 'roam': shy and bold do not go together (in the cell 'true, "
        "bold')");
  CHECK(problems(kArena + "\n<vary path='robot[r1]/behavior[roam]/@shy' values='false; true'/>\n"
                          "<vary path='robot[r1]/behavior[roam]/@mood' values='calm; bold'/>\n"
                          "<vary path='robot[r1]/@max_speed' values='0.1; 0.2; 0.3'/>") ==
        "data/arena.xml:6: behavior 'roam': shy and bold do not go together (in 3 cells, the first "
        "of them 'true, "
        "bold, 0.1')");
}

TEST_CASE("A setting without effect is warned of once, and one that may do harm is allowed") {
  const auto warnings = [](const std::string& engine, const std::string& cfm) {
    return read(kArena + "<set path='physics/@engine' value='" + engine + "'/>" +
                "<set path='physics/@cfm' value='" + cfm +
                "'/><vary path='robot[r1]/@coverage' values='1; 2'/>")
        .warnings;
  };
  REQUIRE(warnings("planar", "0.001").size() == 1);
  CHECK_THAT(warnings("planar", "0.001")[0], Catch::Contains("cfm=\"0.001\" has no effect"));
  CHECK(warnings("ode", "0").empty());
  CHECK(warnings("planar", "1e-5").empty());
}

TEST_CASE("A plugin that cannot begin a run is found in whatever cell") {
  const std::string mottos = "\n<vary path='robot[r1]/behavior[roam]/@motto' values='now; ";
  CHECK(problems(kArena + mottos + "later'/>").empty());
  CHECK_THROWS_WITH(read(kArena + mottos + "tomorrow'/>"),
                    Catch::Contains("plugin 'roam'") && Catch::Contains("does not begin today"));
}

TEST_CASE("A time limit that contradicts a world's goal is reported with both lines") {
  const std::string worlds =
      "<worlds><world file='data/arena.xml'/><world file='data/enduring.xml'/></worlds>\n";
  const std::string contradiction =
      "data/enduring.xml:3: <endure> lasts 20 s, but the run ends after 15 s; see <limits>";
  CHECK(problems(worlds + "<limits time='15'/>") ==
        contradiction + "; that time limit is set in experiment.xml:2");
  CHECK(problems(worlds + "<limits time='20'/>").empty());
  // Another mistake is not blamed on the limit.
  CHECK(problems("<worlds><world file='data/faulty.xml'/></worlds>\n<limits time='15'/>") ==
        "data/faulty.xml:4: <robot> has no attribute 'max_sped'; did you mean 'max_speed'?");
  CHECK(problems(worlds + "<set path='limits/@time' value='15'/>\n<limits time='25'/>") ==
        contradiction);
}

TEST_CASE("A mistake of a world is reported on the world's line, whatever is set in it") {
  CHECK(problems("<worlds><world file='data/arena.xml'/><world file='data/faulty.xml'/></worlds>"
                 "<vary path='robot[r1]/@max_speed' values='0.1; 0.2; 0.3'/>") ==
        "data/faulty.xml:4: <robot> has no attribute 'max_sped'; did you mean 'max_speed'?");
}

TEST_CASE("Of many mistakes on one line the first are reported, with the number of others") {
  const std::string all = problems(
      kArena + "\n<vary path='robot[r1]/behavior[roam]/@speed' from='1' to='100' step='1'/>");
  CHECK(std::count(all.begin(), all.end(), '\n') == 20);
  CHECK_THAT(all, Catch::StartsWith("experiment.xml:2: speed=\"100\" of <roam>: expected "));
  CHECK_THAT(all, Catch::EndsWith("experiment.xml:2: ... and 30 more problems on this line"));
}

TEST_CASE("Levels that make no difference are a mistake, and so is what a later setting undoes") {
  CHECK(problems(kArena + "\n<vary name='a' path='robot[r1]/@max_speed' values='0.1; 0.2'/>\n"
                          "<vary name='b' path='robot[r1]/@max_speed' values='0.3; 0.4'/>") ==
        "experiment.xml:2: the level '0.2' of 'a' is the same as '0.1': the cells '0.1, 0.3' and "
        "'0.2, 0.3' do not differ in anything; a later setting may undo it");
  CHECK(problems("<worlds><world file='data/arena.xml'/><world id='again' file='data/arena.xml'/>"
                 "</worlds>") ==
        "experiment.xml:1: 'again' is the same as 'arena': the cells 'arena' and 'again' do not "
        "differ in anything; a later setting may undo it");
  // A setting in an element that is replaced later.
  CHECK_THAT(
      problems(kArena + "<set path='robot[r1]/coordinator/@weighted' value='true'/>"
                        "<vary path='robot[r1]/coordinator'><level><pick/></level></vary>"),
      Catch::Contains("this replaces the element in which 'robot[r1]/coordinator/@weighted=true' "
                      "is set before"));
}

TEST_CASE("A name may mean one quantity only, in unit and meaning, whatever world measures it") {
  const auto worlds = [](const std::string& measures) {
    return "<worlds><world file='data/measured.xml'/><world id='b' file='data/measured.xml'>"
           "<set path='measures'><measures>" +
           measures + "</measures></set></world></worlds>";
  };
  CHECK(problems(worlds("<hits id='bumps'/><way id='far'/>")).empty());
  CHECK_THAT(problems(worlds("<way id='far'/><way id='bumps'/>")),
             Catch::Contains("the measure 'bumps' is two things"));
}

TEST_CASE(
    "A hint on separating levels is given for one that looks like several, and for no other") {
  const auto with = [](const std::string& values) {
    return problems(kArena + "<vary path='robot[r1]/@max_speed' values='" + values + "'/>");
  };
  CHECK_THAT(with("0.1 0.2"), Catch::EndsWith("; the levels of values are separated by ';'"));
  CHECK_THAT(with("fast"), !Catch::Contains("separated"));
  CHECK_THAT(with("0.1 0.2; 0.3"), !Catch::Contains("separated"));
  CHECK_THAT(problems(kArena + "<vary path='robot[r1]/@max_speed'><level value='1 2'/></vary>"),
             !Catch::Contains("separated"));
}
