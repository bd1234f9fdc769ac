// What is read from an experiment file.
#include <cmath>

#include <catch2/catch.hpp>

#include "elsie/world/markup.h"

#include "fixture.h"

using namespace elsie;
using namespace elsie::test;
using experiment::Experiment;

namespace {

std::vector<std::string> labels(const experiment::Factor& factor) {
  std::vector<std::string> all;
  for (const experiment::Level& level : factor.levels) {
    all.push_back(level.label);
  }
  return all;
}

using Texts = std::vector<std::string>;

Texts range(const std::string& from, const std::string& to, const std::string& step) {
  return labels(read(kArena + "<vary path='robot[r1]/@x' from='" + from + "' to='" + to +
                     "' step='" + step + "'/><set path='robot[r2]/@x' value='4'/>")
                    .factors.at(0));
}

}  // namespace

TEST_CASE("An experiment that says everything") {
  const Experiment e =
      experiment::read_experiment(kFolder + "data/everything.xml", host(), options());
  CHECK(e.name == "Everything & more");
  CHECK(e.description == "All that there is");
  CHECK(e.file == kFolder + "data/everything.xml");

  REQUIRE(e.worlds.size() == 2);
  CHECK(e.worlds[0].id == "arena");
  CHECK(e.worlds[0].file == kFolder + "data/arena.xml");
  CHECK(e.worlds[0].name == "arena.xml");
  CHECK(e.worlds[1].id == "full");
  REQUIRE(e.worlds[1].settings.size() == 1);
  CHECK(e.worlds[1].settings[0].path == "obstacle[crate]/@mass");
  CHECK(e.worlds[1].settings[0].value == "0.5");
  CHECK(e.worlds[1].settings[0].location.line == 8);

  REQUIRE(e.settings.size() == 2);
  CHECK(e.settings[1].path == "physics");
  CHECK(e.settings[1].value == "<physics step=\"0.02\"/>");

  REQUIRE(e.factors.size() == 4);
  CHECK(e.factors[0].name == "coordinator");
  CHECK(labels(e.factors[0]) == Texts{"fusion", "layers", "arbitration"});
  CHECK(e.factors[0].levels[1].settings.at(0).path == "robot[r1]/coordinator");
  CHECK(e.factors[0].levels[1].settings.at(0).value ==
        "<layers><inhibit by=\"roam\" of=\"roam\"/></layers>");
  CHECK(e.factors[0].levels[2].settings.at(1).path == "robot[r1]/@max_speed");
  CHECK(e.factors[1].name == "speed");
  CHECK(labels(e.factors[1]) == Texts{"0.1", "0.2", "0.3"});
  CHECK(e.factors[2].name == "weights");
  CHECK(labels(e.factors[2]) == Texts{"1 1", "2 -2"});
  CHECK(labels(e.factors[3]) == Texts{"as ever", "daring"});
  CHECK(e.factors[3].levels[0].settings.empty());

  CHECK(e.seeds == std::vector<std::uint64_t>{3, 5, 8});
  CHECK(e.repeats == 2);
  CHECK(e.time_limit == 30.0);
  CHECK(e.wall_limit == 60.0);
  CHECK(e.trajectory_period == 0.25);
  REQUIRE(e.measures.size() == 3);
  CHECK(e.measures[1].name == "time_s");
  CHECK(e.measures[1].formula.empty());
  CHECK(e.measures[2].formula == "collisions / (time_s / 60)");
  CHECK(e.measures[2].unit == "1/min");
  CHECK(e.measures[2].meaning == "collisions per minute");
  REQUIRE(e.exclusions.size() == 1);
  CHECK(e.exclusions[0].where.size() == 2);
  // Of six combinations of speed and mood, one is left out.
  CHECK(experiment::cells(e).size() == 2 * 3 * 3 * 2 * 2 * 5 / 6);
  CHECK(experiment::number_of_runs(e) == 2 * 3 * 3 * 2 * 2 * 5 / 6 * 3 * 2);
}

TEST_CASE("Expectations") {
  const Experiment e =
      experiment::read_experiment(kFolder + "data/everything.xml", host(), options());
  REQUIRE(e.expectations.size() == 4);
  const experiment::Expectation& works = e.expectations[0];
  CHECK(works.name == "it works");
  CHECK(works.statistic == experiment::Statistic::rate);  // the default for success
  CHECK(works.at_least == 0.9);
  CHECK(works.confidence == 0.95);
  CHECK(works.where.empty());
  CHECK(works.relation == experiment::Relation::none);

  const experiment::Expectation& path = e.expectations[1];
  CHECK(path.name ==
        "mean of path_length_m of successes, coordinator=fusion|layers, speed=0.*: about 2.5 give "
        "or take 0.5");
  CHECK(path.statistic == experiment::Statistic::mean);
  CHECK(path.runs == experiment::Runs::successes);
  REQUIRE(path.where.size() == 2);
  CHECK(path.where[0].factor == "coordinator");
  CHECK(path.where[0].levels == Texts{"fusion", "layers"});
  CHECK(path.about == 2.5);
  CHECK(path.tolerance == 0.5);

  const experiment::Expectation& ratio = e.expectations[2];
  CHECK(ratio.name ==
        "median of time_s per path_length_m, world=full, coordinator=*tion: at most 1.5 times that "
        "of coordinator=layers");
  CHECK(ratio.per == "path_length_m");
  CHECK(ratio.relation == experiment::Relation::ratio);
  REQUIRE(ratio.reference.size() == 1);
  CHECK(ratio.reference[0].factor == "coordinator");
  CHECK(ratio.reference[0].level == "layers");

  const experiment::Expectation& difference = e.expectations[3];
  CHECK(difference.name ==
        "maximum of collisions: at most 3 less and at most 3 more than that of world=arena, "
        "mood=as ever");
  CHECK(difference.relation == experiment::Relation::difference);
  CHECK(difference.reference.size() == 2);
}

TEST_CASE("What a short experiment leaves out") {
  const Experiment e = read(kArena);
  CHECK(e.name == "experiment");
  CHECK(e.seeds == std::vector<std::uint64_t>{1});
  CHECK(e.repeats == 1);
  CHECK_FALSE(e.time_limit);
  CHECK(e.wall_limit == 600.0);
  CHECK(e.trajectory_period == 0.5);
  CHECK(e.measures.empty());
  CHECK(experiment::cells(e).size() == 1);
}

TEST_CASE("What is set while a world runs is a change of the cell's world") {
  const Experiment e = read(
      "<worlds><world file='data/arena.xml'><at time='3'><set path='robot[r1]/@max_speed' "
      "value='0.1'/></at></world></worlds>"
      "<at time='1'><set path='robot[r1]/@coverage' value='2'/><set path='obstacle[+]'>"
      "<static_box id='wall' x='2'/></set></at>"
      "<vary name='fate'><level label='none'/><level label='lost'><at time='3.5'>"
      "<set path='robot[r1]/@remove' value='true'/></at></level></vary>");
  const auto changes_of = [&](std::size_t cell) {
    Texts texts;
    const auto world = experiment::read_cell(e, experiment::cells(e).at(cell), host(), options());
    for (const world::TimedEdit& change : world.edits) {
      texts.push_back(std::to_string(change.time).substr(0, 3) + " " + change.text());
    }
    return texts;
  };
  CHECK(changes_of(0) == Texts{"1.0 robot[r1]/@coverage=2",
                               "1.0 obstacle[+]=<static_box id=\"wall\" x=\"2\"/>",
                               "3.0 robot[r1]/@max_speed=0.1"});
  CHECK(changes_of(1).back() == "3.5 robot[r1]/@remove=true");
  CHECK(experiment::cells(e)[1].edits.empty());
}

TEST_CASE("The levels of a range are the decimal numbers that a reader expects") {
  CHECK(range("0.1", "0.5", "0.1") == Texts{"0.1", "0.2", "0.3", "0.4", "0.5"});
  CHECK(range("-0.1", "0.2", "0.15") == Texts{"-0.1", "0.05", "0.2"});
  CHECK(range("1", "3", "1") == Texts{"1", "2", "3"});
  CHECK(range("0.50", "1", "0.25") == Texts{"0.5", "0.75", "1"});
  CHECK(range("2", "2", "1") == Texts{"2"});
  CHECK(range("-1", "1", "0.5") == Texts{"-1", "-0.5", "0", "0.5", "1"});
  CHECK(range("1e-3", "3e-3", "1e-3") == Texts{"0.001", "0.002", "0.003"});
  CHECK(range("0", "3e-07", "1e-07") == Texts{"0", "1e-07", "2e-07", "3e-07"});
  CHECK(range("-1.5707963267948966", "1.5707963267948966", "0.7853981633974483") ==
        Texts{"-1.5707963267948966", "-0.7853981633974483", "0", "0.7853981633974483",
              "1.5707963267948966"});
  CHECK(range("3", "3.000003", "0.000001") == Texts{"3", "3.000001", "3.000002", "3.000003"});
  const Texts fine = range("0", "0.999", "0.001");
  CHECK(fine.size() == 1000);
  CHECK(fine[700] == "0.7");  // 700 x 0.001 would be 0.7000000000000001
}

TEST_CASE("A range that misses its end by little is refused, too") {
  const auto refusal = [](const std::string& from, const std::string& step) {
    return problems(kArena + "<vary path='robot[r1]/@x' from='" + from + "' to='1' step='" + step +
                    "'/><set path='robot[r2]/@x' value='4'/>");
  };
  CHECK_THAT(refusal("0", "0.3333333"),
             Catch::Contains("do not meet 1; the last one before it is 0.9999999"));
  CHECK_THAT(refusal("0", "0.33333334"),
             Catch::Contains("do not meet 1; the last one before it is 0.66666668"));
  CHECK_THAT(refusal("1e-16", "1"), Catch::Contains("steps of 1 do not meet 1; the last one"));
}

TEST_CASE("Seeds from the first to the last") {
  CHECK(read(kArena + "<seeds from='0' to='3'/>").seeds == std::vector<std::uint64_t>{0, 1, 2, 3});
  CHECK(read(kArena + "<seeds from='9223372036854775806' to='9223372036854775807'/>").seeds ==
        std::vector<std::uint64_t>{9223372036854775806u, 9223372036854775807u});
  CHECK(read(kArena + "<seeds list='  7\n 1 '/>").seeds == std::vector<std::uint64_t>{7, 1});
}

TEST_CASE("Values may have blanks in them, and are without those around them") {
  const Experiment e =
      read(kArena + "<vary path='robot[r1]/behavior[roam]/@weights' values=' 1 2 ;3 4; 5  5'/>");
  CHECK(labels(e.factors.at(0)) == Texts{"1 2", "3 4", "5  5"});
}

TEST_CASE("Measures of worlds are as good as those of every run") {
  const std::string both =
      "<worlds><world file='data/measured.xml'/><world file='data/arena.xml'/></worlds>\n";
  const std::string every = "success, time_s, path_length_m, collected, collisions, energy_left";
  CHECK(problems(both + "<measures><measure name='bumps'/><measure name='time_s'/></measures>") ==
        "");
  CHECK(problems(both + "<measures><measure name='hits'/></measures>") ==
        "experiment.xml:2: no run has a measure 'hits'; there are: " + every + ", bumps");
  CHECK(problems(both + "<expectations><expect measure='bumps' at_most='1' where='world=measured'/>"
                        "</expectations>") == "");
  CHECK(problems(both + "<expectations><expect measure='bumps' at_most='1'/></expectations>") ==
        "experiment.xml:2: runs of the cell 'arena' have no measure 'bumps'; there are: " + every);
  CHECK(problems(both + "<expectations><expect measure='bumps' at_most='1' where='world=measured' "
                        "ratio_to='world=arena'/></expectations>") ==
        "experiment.xml:2: runs of the cell 'arena' have no measure 'bumps'; there are: " + every);
}

TEST_CASE("A factor may not be called like a measure") {
  for (const std::string name : {"time_s", "success"}) {
    CHECK(problems("<worlds><world file='data/arena.xml'/></worlds>\n<vary name='" + name +
                   "' path='robot[r1]/@max_speed' values='0.1; 0.2'/>") ==
          "experiment.xml:2: the factor '" + name +
              "' is called like a measure of the runs; give the factor another name");
  }
}

TEST_CASE("A formula is a measure where the runs have all that it names") {
  const std::string both =
      "<worlds><world file='data/measured.xml'/><world file='data/arena.xml'/></worlds>"
      "<vary name='speed' path='robot[r1]/@max_speed' values='0.1; 0.2'/>\n";
  const std::string formulas =
      "<measures><measure name='bump_rate' formula='bumps / time_s'/>"
      "<measure name='relative' formula='bump_rate / speed'/></measures>";
  const auto expects = [&](const std::string& rest) {
    return problems(both + formulas + "<expectations><expect at_most='1' " + rest +
                    "/></expectations>");
  };
  CHECK(expects("measure='relative' where='world=measured'") == "");
  CHECK(expects("measure='time_s' per='bump_rate' where='world=measured'") == "");
  CHECK_THAT(expects("measure='relative'"),
             Catch::Contains("runs of the cell 'arena, 0.1' have no measure 'relative'"));
  CHECK_THAT(expects("measure='bumprate' where='world=measured'"),
             Catch::Contains("did you mean 'bump_rate'?"));
  CHECK(
      problems("<worlds><world file='data/measured.xml'/></worlds>\n"
               "<vary name='bumps' path='robot[r1]/@max_speed' values='0.1; 0.2'/>"
               "<measures><measure name='bump_rate' formula='bumps / time_s'/></measures>") ==
      "experiment.xml:2: the factor 'bumps' is called like a measure of the runs; give the factor "
      "another name");
  // What is wrong with a formula is reported once, whatever is expected of it.
  CHECK(
      problems(kArena + "\n<measures><measure name='x' formula='time_s +'/></measures>"
                        "<expectations><expect measure='x' at_most='1'/></expectations>") ==
      "experiment.xml:2: formula=\"time_s +\" of <measure>: column 9: the formula ends too early; "
      "expected a number, a name or \"(\"");
}

TEST_CASE("Formulas know the robots and the minutes of every run, and no other meaning of them") {
  const auto with = [](const std::string& formula, const std::string& more = "") {
    return problems(kArena + more + "\n<measures>" + formula + "</measures>");
  };
  CHECK(with("<measure name='rate' formula='collisions / robots / minute'/>"
             "<measure name='length' formula='minutes'/>") == "");
  CHECK_THAT(with("<measure name='rate' formula='collisions / robot'/>"),
             Catch::Contains("did you mean 'robots'?"));
  CHECK(with("<measure name='minutes' formula='time_s / 60'/>") ==
        "experiment.xml:2: a formula cannot be called 'minutes', which formulas may use of every "
        "run; give it another name");
  const std::string factor = "<vary name='robots' path='robot[r1]/@max_speed' values='0.1; 0.2'/>";
  CHECK(with("", factor) == "");
  CHECK(with("<measure name='rate' formula='collisions / robots'/>", factor) ==
        "experiment.xml:2: formula=\"collisions / robots\" of <measure>: column 14: 'robots' is a "
        "factor, and what formulas may use of every run; give the factor another name");
}

TEST_CASE("Formulas are shown in their place, and alone after all measures") {
  const auto shown = [](const std::string& measures) {
    return experiment::shown_measures(
        read(kArena + "<measures>" + measures + "</measures>").measures);
  };
  const std::string formula = "<measure name='twice' formula='2 * time_s'/>";
  CHECK(shown(formula + "<measure name='time_s'/>") == Texts{"twice", "time_s"});
  CHECK(shown(formula).empty());
}

TEST_CASE("An outline is the same experiment, without its worlds and plugins") {
  const std::string file = kFolder + "data/everything.xml";
  const Experiment whole = experiment::read_experiment(file, host(), options());
  // Named as if it were elsewhere: none of its files is found there.
  const Experiment outline =
      experiment::parse_outline(world::read_text(file), "/nowhere/everything.xml");
  CHECK(outline.name == whole.name);
  REQUIRE(outline.worlds.size() == whole.worlds.size());
  CHECK(outline.worlds[1].id == whole.worlds[1].id);
  CHECK(outline.worlds[0].file.empty());
  REQUIRE(outline.factors.size() == whole.factors.size());
  CHECK(labels(outline.factors[0]) == labels(whole.factors[0]));
  CHECK(outline.seeds == whole.seeds);
  CHECK(outline.measures.size() == whole.measures.size());
  REQUIRE(outline.expectations.size() == whole.expectations.size());
  for (std::size_t i = 0; i < whole.expectations.size(); ++i) {
    CHECK(outline.expectations[i].name == whole.expectations[i].name);
  }
}

TEST_CASE("An outline's own mistakes are reported") {
  CHECK_THROWS_AS(experiment::parse_outline("<experiment format=\"1\"><worlds/></experiment>", "x"),
                  world::WorldError);
  CHECK_THROWS_WITH(
      experiment::parse_outline(
          "<experiment format=\"1\"><worlds><world file=\"a.xml\"/></worlds><seeds list=\"1\"/>"
          "<expectations><expect measure=\"success\" where=\"colour=red\" at_least=\"1\"/>"
          "</expectations></experiment>",
          "x"),
      Catch::Contains("there is no factor 'colour'"));
}
