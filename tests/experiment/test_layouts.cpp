// Layouts in experiments: crossed with the seeds, nested in them, or one for all.
#include <catch2/catch.hpp>

#include "elsie/world/writer.h"

#include "fixture.h"

using namespace elsie;
using namespace elsie::test;
using Catch::Contains;

namespace {

const std::string kScattered = "<worlds><world file='data/scattered.xml'/></worlds>\n";

std::string text_of(const experiment::Experiment& e, std::size_t cell, std::uint64_t seed) {
  return world::write_world(
      experiment::read_cell(e, experiment::cells(e).at(cell), host(), options(), seed));
}

}  // namespace

TEST_CASE("Crossed layouts are a factor, whose levels are the same for every seed") {
  const experiment::Experiment e = read(kScattered +
                                        "<vary path='scatter[c]/@count' values='2; 4'/>"
                                        "<layouts from='3' to='5'/><seeds from='1' to='2'/>");
  REQUIRE(e.factors.size() == 2);
  CHECK(e.factors[1].name == "layout_seed");
  const auto cells = experiment::cells(e);
  REQUIRE(cells.size() == 6);
  CHECK(experiment::number_of_runs(e) == 12);
  CHECK(cells[1].labels.back() == "4");
  CHECK(text_of(e, 0, 1) == text_of(e, 0, 2));
  CHECK(text_of(e, 0, 1) != text_of(e, 1, 1));
  CHECK(experiment::read_cell(e, cells[4], host(), options(), 1).drawn->seed == 4);
  CHECK(read(kScattered + "<layouts list='7 9'/>").factors.at(0).levels.at(1).label == "9");
}

TEST_CASE("Nested layouts follow the seeds") {
  const experiment::Experiment e =
      read(kScattered + "<layouts rule='nested'/><seeds from='1' to='2'/>");
  CHECK(experiment::cells(e).size() == 1);
  CHECK(text_of(e, 0, 1) != text_of(e, 0, 2));
}

TEST_CASE("The seed of the layouts is an attribute like any other") {
  const experiment::Experiment e =
      read(kScattered + "<vary name='layout' path='layouts/@seed' values='1; 2'/>");
  CHECK(text_of(e, 0, 8) == text_of(e, 0, 9));
  CHECK(text_of(e, 0, 8) != text_of(e, 1, 8));
}

TEST_CASE("Layouts that cannot be are refused before the first run") {
  CHECK(problems(kScattered + "<layouts rule='nested' from='1' to='2'/>") ==
        "experiment.xml:2: rule=\"nested\" of <layouts>: the seeds of the runs are those of the "
        "layouts; take from, to and list out, or write rule=\"crossed\"");
  CHECK_THAT(problems(kScattered + "<layouts/>"), Contains("<layouts> must say which"));
  CHECK_THAT(problems(kScattered + "<layouts list='1 x'/>"), Contains("'x' is no seed"));
  CHECK_THAT(problems(kArena + "<seeds list='18446744073709551616'/>"),
             Contains("is no seed") && !Contains("lists none"));
  CHECK_THAT(problems(kScattered + "<layouts from='1' to='99999999'/>"),
             Contains("a factor has at most as many levels"));
  CHECK_THAT(problems(kScattered + "<layouts list='1 2'/><vary name='layout_seed' "
                                   "path='limits/@time' values='1; 2'/>"),
             Contains("there is another of this name"));
  CHECK_THAT(problems(kArena + "\n<layouts rule='nested'/>"),
             Contains("experiment.xml:2: ") && Contains("the world has no <layouts>"));
  CHECK_THAT(problems(kScattered + "<set path='layouts/@seed' value='3'/>"
                                   "<layouts rule='nested'/>"),
             Contains("have a seed of their own; take it out"));
  CHECK_THAT(problems(kArena + "\n<layouts from='1' to='2'/>"),
             Contains("experiment.xml:2: the world has no layouts"));
}

TEST_CASE("Every seed must have room for its layout, and the first that has none is named") {
  const std::string crowded =
      "<set path='scatter[c]/@count' value='18'/><set path='scatter[c]/@tries' value='60'/>";
  const std::string found = problems(kScattered + crowded + "<seeds from='1' to='60'/>");
  CHECK_THAT(found, Contains("data/scattered.xml:5: the layout 'c' has no room for the next of its "
                             "18 things") &&
                        Contains("(with the seed "));
  CHECK_THAT(problems(kScattered + "<seeds from='1' to='200000'/>"),
             Contains("the layouts follow the seeds, which makes more than 100000 worlds"));
}

TEST_CASE("Levels are the same only if they draw the same with every seed") {
  const auto with = [](const std::string& levels, const std::string& seeds) {
    return problems(kScattered + "<set path='scatter[c]/@count' value='6'/>" + levels + "<seeds " +
                    seeds + "/>");
  };
  // Places that keep 0.1 m from each other may keep 0.15 m, too.
  const std::string gaps = "<vary path='scatter[c]/@gap' values='0.1; 0.15; 0.3'/>";
  CHECK_THAT(with(gaps, "list='1'"), Contains("the level '0.15' of 'gap' is the same as '0.1'"));
  CHECK(with(gaps, "from='1' to='20'").empty());
  CHECK_THAT(with("<vary path='scatter[c]/@tries' values='1000; 2000'/>", "from='1' to='8'"),
             Contains("the level '2000' of 'tries' is the same as '1000'"));
  // The third level is the second one again, although all begin with the same world.
  CHECK_THAT(with("<vary path='scatter[c]/@gap' values='0.1; 0.15; 0.150'/>", "from='1' to='20'"),
             Contains("the level '0.150' of 'gap' is the same as '0.15'"));
}

TEST_CASE("What is wrong with layouts is not blamed on the time limit") {
  const std::string limits = "\n<limits time='15'/>";
  CHECK_THAT(problems(kArena + "<layouts rule='nested'/>" + limits),
             Contains("the world has no <layouts>") && !Contains("time limit"));
  const std::string crowded =
      "<set path='scatter[c]/@count' value='18'/><set path='scatter[c]/@tries' value='60'/>";
  CHECK_THAT(problems(kScattered + crowded + "<seeds from='1' to='60'/>" + limits),
             Contains("(with the seed ") && !Contains("time limit"));
}
