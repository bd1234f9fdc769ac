// Cells: which exist, in which order, and which of them an expectation covers.
#include <catch2/catch.hpp>

#include "elsie/experiment/grid.h"

#include "fixture.h"

using namespace elsie;
using namespace elsie::test;
using experiment::Cell;
using experiment::Experiment;

namespace {

using Texts = std::vector<std::string>;

const std::string kFactors =
    "<vary path='robot[r1]/coordinator'><level><pick/></level><level><layers/></level></vary>"
    "<vary name='speed' path='robot[r1]/@max_speed' values='0.1; 0.2; 0.3'/>";

Texts labels(const std::vector<Cell>& grid) {
  Texts all;
  for (const Cell& cell : grid) {
    all.push_back(cell.label);
  }
  return all;
}

// The labels of the cells of the only expectation, each with that of its reference.
Texts about(const std::string& expectation) {
  const Experiment e = read(kTwoWorlds + kFactors + "<expectations><expect measure='time_s' " +
                            "at_least='1' " + expectation + "/></expectations>");
  const std::vector<Cell> grid = experiment::cells(e);
  Texts all;
  const experiment::Grid by_levels(e, grid);
  for (const std::size_t index : by_levels.cells_of(e.expectations.at(0))) {
    const auto other = by_levels.reference_of(e.expectations[0], index);
    all.push_back(grid[index].label + (other ? " / " + grid[*other].label : ""));
  }
  return all;
}

}  // namespace

TEST_CASE("Worlds are outermost, the last factor innermost") {
  const std::vector<Cell> grid = experiment::cells(read(kTwoWorlds + kFactors));
  CHECK(labels(grid) == Texts{"arena, pick, 0.1", "arena, pick, 0.2", "arena, pick, 0.3",
                              "arena, layers, 0.1", "arena, layers, 0.2", "arena, layers, 0.3",
                              "clutter, pick, 0.1", "clutter, pick, 0.2", "clutter, pick, 0.3",
                              "clutter, layers, 0.1", "clutter, layers, 0.2",
                              "clutter, layers, 0.3"});
  for (std::size_t i = 0; i < grid.size(); ++i) {
    CHECK(grid[i].index == i);
  }
  CHECK(grid[10].world == 1);
  CHECK(grid[10].levels == std::vector<std::size_t>{1, 1});
}

TEST_CASE("A cell's label leaves out what is the same in all") {
  CHECK(labels(experiment::cells(read(kArena))) == Texts{"arena"});
  CHECK(labels(experiment::cells(read(kTwoWorlds))) == Texts{"arena", "clutter"});
  CHECK(labels(experiment::cells(read(kArena + "<vary path='robot[r1]/@max_speed' values='0.1'/>" +
                                      "<vary path='robot[r1]/@coverage' values='1; 2'/>"))) ==
        Texts{"1", "2"});
}

TEST_CASE("Combinations that are excluded are no cells") {
  const std::vector<Cell> grid = experiment::cells(
      read(kTwoWorlds + kFactors + "<exclude where='coordinator=layers; speed=0.1|0.3'/>" +
           "<exclude where='world=clutter'/>"));
  CHECK(labels(grid) ==
        Texts{"arena, pick, 0.1", "arena, pick, 0.2", "arena, pick, 0.3", "arena, layers, 0.2"});
  CHECK(grid.back().index == 3);
  CHECK(grid.back().levels == std::vector<std::size_t>{1, 1});
}

TEST_CASE("What is set in a cell: for all, then for its world, then for its levels") {
  const Experiment e = read(
      "<worlds><world file='data/arena.xml'><set path='@description' value='of the world'/></world>"
      "</worlds><limits time='30'/><set path='robot[r1]/@max_speed' value='0.9'/>"
      "<vary path='robot[r1]/coordinator'><level><pick/></level></vary>"
      "<vary path='robot[r1]/@max_speed' values='0.1'/>");
  const std::vector<Cell> grid = experiment::cells(e);
  CHECK(grid.at(0).edits == Texts{"limits/@time=30", "robot[r1]/@max_speed=0.9",
                                  "@description=of the world", "robot[r1]/coordinator=<pick/>",
                                  "robot[r1]/@max_speed=0.1"});
  const world::World world = experiment::read_cell(e, grid[0], host(), options());
  CHECK(world.limits.time == 30);
  CHECK(world.robots[0].max_speed == 0.1);
  CHECK(world.robots[0].coordinator->plugin == "pick");
  CHECK(world.description == "of the world");
}

TEST_CASE("Files are searched for in the experiment's folder, for any world") {
  const Experiment e =
      experiment::read_experiment(kFolder + "data/everything.xml", host(), options());
  const world::World world =
      experiment::read_cell(e, experiment::cells(e).at(0), host(), options());
  CHECK(std::get<std::string>(world.robots[0].behaviors[0].parameters.at("song")) ==
        kFolder + "data/models/tune.txt");
}

TEST_CASE("An expectation is about the cells that match all of `where`") {
  CHECK(about("").size() == 12);
  CHECK(about("where='coordinator=pick; speed=0.2'") ==
        Texts{"arena, pick, 0.2", "clutter, pick, 0.2"});
  CHECK(about("where=' world = clutter ;speed=0.1 | 0.3'") ==
        Texts{"clutter, pick, 0.1", "clutter, pick, 0.3", "clutter, layers, 0.1",
              "clutter, layers, 0.3"});
  CHECK(about("where='world=a*; coordinator=*ck; speed=*'") ==
        Texts{"arena, pick, 0.1", "arena, pick, 0.2", "arena, pick, 0.3"});
  CHECK(about("where='world=*e*a; speed=0*1; coordinator=*'") ==
        Texts{"arena, pick, 0.1", "arena, layers, 0.1"});
}

TEST_CASE(
    "A cell is compared with the one that differs in the levels named, and never with itself") {
  CHECK(about("where='world=arena' ratio_to='coordinator=pick'") ==
        Texts{"arena, layers, 0.1 / arena, pick, 0.1", "arena, layers, 0.2 / arena, pick, 0.2",
              "arena, layers, 0.3 / arena, pick, 0.3"});
  CHECK(about("where='coordinator=layers; speed=0.3' difference_from='world=arena; speed=0.1'") ==
        Texts{"arena, layers, 0.3 / arena, layers, 0.1",
              "clutter, layers, 0.3 / arena, layers, 0.1"});
}

TEST_CASE("The levels of a cell, by factor") {
  const Experiment e = read(kTwoWorlds + kFactors);
  CHECK(experiment::factor_names(e) == Texts{"world", "coordinator", "speed"});
  CHECK(experiment::cells(e).at(10).labels == Texts{"clutter", "layers", "0.2"});
}
