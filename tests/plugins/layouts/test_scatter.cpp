// <scatter>: what stands where, how far apart, and what is refused.
#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <catch2/catch.hpp>

#include "support.h"

using namespace elsie;
using namespace elsie::test;
using Catch::Contains;

TEST_CASE("The same seed gives the same world, and another seed another one") {
  CHECK(text_of(kClutter, 7) == text_of(kClutter, 7));
  CHECK(text_of(kClutter, 7) != text_of(kClutter, 8));
}

TEST_CASE("A layout with a seed of its own does not follow the run's") {
  std::string own = kClutter;
  own.replace(own.find("<layouts>"), 9, "<layouts seed='7'>");
  CHECK(text_of(own, 1) == text_of(kClutter, 7));
  CHECK(drawn(own, 1).drawn->seed == 7);
  CHECK_FALSE(drawn(own, 1).drawn->by_run);
  CHECK(drawn(kClutter, 3).drawn->by_run);
  CHECK_FALSE(drawn("").drawn);
  CHECK(text_of(kClutter, 1, {"layouts/@seed=9"}) == text_of(kClutter, 9));
}

TEST_CASE("The places are those of the first version, on every machine") {
  const world::World world = drawn(kClutter, 1);
  CHECK(world.obstacles.at(0).x == -1.8306);
  CHECK(world.obstacles.at(0).y == 4.5148);
}

TEST_CASE("One more layout, or a larger count, leaves what others draw as it is") {
  const world::World few = drawn(kClutter, 3), more = drawn(kClutter, 3, {"scatter/@count=40"});
  REQUIRE(more.obstacles.size() == 40);
  for (std::size_t i = 0; i < few.obstacles.size(); ++i) {
    CHECK(more.obstacles[i].x == few.obstacles[i].x);
  }
  const world::World other =
      drawn(kClutter, 3, {"scatter[+]=<scatter id='food'><resource/></scatter>"});
  CHECK(other.obstacles[5].x == few.obstacles[5].x);
}

TEST_CASE("Everything keeps the gap to everything: boxes, robots, trains and walls") {
  const double gap = 0.15;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const world::World world = drawn(
        "<arena length='6' width='6'/><obstacles><static_box x='1' y='1' length='2' "
        "heading_deg='30'/></obstacles><robots><robot id='old' x='-1' y='-1'/></robots>"
        "<layouts><scatter id='a' count='20' gap='0.15'><dynamic_box length='0.4'/><heading/>"
        "</scatter><scatter id='b' count='5' gap='0.15'><robot id='r'><segments><segment/>"
        "</segments></robot><heading/></scatter></layouts>",
        seed);
    const auto all = footprints(world);
    CHECK(all.size() == 1 + 20 + 1 + 2 * 5);
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const bool is_train = i > 21 && j > 21 && (i - 22) / 2 == (j - 22) / 2;
        if (!is_train) CHECK_FALSE(are_nearer(all[i], all[j], gap - 1e-6));
      }
      if (i > 0 && i != 21) {
        CHECK(std::abs(all[i].x) + all[i].reach(1, 0) + gap <= 3.0 + 1e-6);
        CHECK(std::abs(all[i].y) + all[i].reach(0, 1) + gap <= 3.0 + 1e-6);
      }
    }
  }
}

TEST_CASE("Things stand in their region") {
  const auto check = [](const std::string& region, const auto& is_inside) {
    const world::World world = drawn(
        scattered("count='60' gap='0'", "<static_box length='0.05' width='0.05'/>" + region), 2);
    REQUIRE(world.obstacles.size() == 60);
    CHECK(std::all_of(world.obstacles.begin(), world.obstacles.end(),
                      [&](const world::Obstacle& box) { return is_inside(box.x, box.y); }));
  };
  check("<in_box x='1' y='-2' length='3' width='1'/>",
        [](double x, double y) { return std::abs(x - 1) <= 1.5 && std::abs(y + 2) <= 0.5; });
  check("<in_box length='4' width='0.5' heading_deg='45'/>", [](double x, double y) {
    return std::abs(x - y) <= 0.5 * std::sqrt(0.5) * 1.001 && std::abs(x + y) <= 2.0 * 1.4143;
  });
  check("<in_disc x='1' radius='2'/>",
        [](double x, double y) { return std::hypot(x - 1, y) <= 2.0001; });
  check("<in_ring inner='3' outer='4'/>", [](double x, double y) {
    return std::hypot(x, y) >= 2.9999 && std::hypot(x, y) <= 4.0001;
  });
  check("<on_line x1='-4' y1='-4' x2='4' y2='4'/>",
        [](double x, double y) { return std::abs(x - y) < 1e-9; });
  check("<on_grid columns='10' rows='10'/>", [](double x, double y) {
    return std::abs(std::abs(std::fmod(x, 1.0)) - 0.5) < 1e-9 &&
           std::abs(std::abs(std::fmod(y, 1.0)) - 0.5) < 1e-9;
  });
}

TEST_CASE("A disc and a ring are filled evenly, and a normal distribution has its spread") {
  const world::World disc =
      drawn(scattered("count='2000' gap='0'", "<charger radius='0.001'/><in_disc radius='4'/>"));
  const auto inner =
      std::count_if(disc.chargers.begin(), disc.chargers.end(),
                    [](const auto& each) { return std::hypot(each.x, each.y) < 2.0; });
  CHECK(inner == Approx(500).margin(60));  // three standard deviations
  const world::World cloud = drawn(
      scattered("count='2000' gap='0'", "<charger radius='0.001'/><gaussian x='1' sd='0.5'/>"));
  double sum = 0.0, squares = 0.0;
  for (const auto& each : cloud.chargers) {
    sum += each.x;
    squares += (each.x - 1.0) * (each.x - 1.0);
  }
  CHECK(sum / 2000 == Approx(1.0).margin(0.035));
  CHECK(std::sqrt(squares / 2000) == Approx(0.5).margin(0.025));
}

TEST_CASE("A grid gives each cell one thing, and jitter moves it within its cell") {
  const world::World world =
      drawn(scattered("count='100' gap='0'",
                      "<charger radius='0.01'/><on_grid columns='10' rows='10' "
                      "jitter='0.8'/>"));
  std::set<std::pair<int, int>> cells;
  bool is_moved = false;
  for (const auto& each : world.chargers) {
    const double x = each.x + 5.0, y = each.y + 5.0;
    cells.emplace(static_cast<int>(x), static_cast<int>(y));
    is_moved |= std::abs(x - std::floor(x) - 0.5) > 0.2;
    CHECK(std::abs(x - std::floor(x) - 0.5) <= 0.4001);
  }
  CHECK(cells.size() == 100);
  CHECK(is_moved);
}

TEST_CASE("An even line goes from end to end") {
  const world::World world =
      drawn(scattered("count='5'",
                      "<robot id='r'/><on_line even='true' x1='-2' y1='1' x2='2' y2='1'/>"
                      "<heading rule='along' deg='90'/>"));
  for (int i = 0; i < 5; ++i) {
    const world::Robot& robot = world.robots[static_cast<std::size_t>(i)];
    CHECK(robot.id == "r" + std::to_string(i + 1));
    CHECK(robot.x == -2.0 + i);
    CHECK(robot.heading_deg == 90.0);
  }
}

TEST_CASE("Headings follow their rule") {
  const auto headings = [](const std::string& rule) {
    const auto robots = drawn(scattered("count='20'", "<robot id='r'/>" + rule), 3).robots;
    REQUIRE(robots.size() == 20);
    return robots;
  };
  for (const auto& robot : headings("<heading from_deg='10' to_deg='20'/>")) {
    CHECK((robot.heading_deg >= 10.0 && robot.heading_deg <= 20.0));
  }
  for (const auto& robot : headings("<heading rule='fixed' deg='33'/>")) {
    CHECK(robot.heading_deg == 33.0);
  }
  for (const auto& robot : headings("<heading rule='towards' x='1' y='1'/>")) {
    CHECK(std::remainder(robot.heading_deg - degrees(std::atan2(1 - robot.y, 1 - robot.x)), 360) ==
          Approx(0.0).margin(0.01));
  }
  for (const auto& robot : headings("<heading rule='away'/>")) {
    CHECK(std::remainder(robot.heading_deg - degrees(std::atan2(robot.y, robot.x)), 360) ==
          Approx(0.0).margin(0.01));
  }
  for (const auto& robot : headings("<heading rule='gaussian' deg='90' sd_deg='0'/>")) {
    CHECK(robot.heading_deg == 90.0);
  }
}

TEST_CASE("A density covers its share of the area, whatever the sizes") {
  for (const std::string size : {"", "<draw path='@length' from='0.1' to='0.6'/>"}) {
    const world::World world =
        drawn(scattered("density='0.2'", "<static_box/><in_disc radius='4'/>" + size), 5);
    double area = 0.0;
    for (const world::Obstacle& box : world.obstacles) area += box.length * box.width;
    CHECK(area / (3.141592654 * 16.0) == Approx(0.2).margin(0.003));
  }
}

TEST_CASE("A template, and all that an element says, is in each of them") {
  const world::World world = drawn(scattered(
      "count='3'", "<robot id='r' team='blue' template='robots/scout.xml' max_speed='0.3'/>"));
  REQUIRE(world.robots.size() == 3);
  for (const world::Robot& robot : world.robots) {
    CHECK(robot.sensors.size() == 6);
    CHECK(robot.max_speed == 0.3);
    CHECK(robot.team == "blue");
    CHECK(robot.location.line == 2);
  }
}

TEST_CASE("One thing keeps its own name; several are numbered; without a name it is the layout's") {
  CHECK(drawn(scattered("", "<robot id='r'/>")).robots[0].id == "r");
  CHECK(drawn(scattered("count='2'", "<robot id='r'/>")).robots[1].id == "r2");
  CHECK(drawn(scattered("count='2'", "<static_box/>")).obstacles[1].id == "c2");
}

TEST_CASE("Nothing stands where it is kept clear") {
  const world::World world =
      drawn(scattered("count='60' gap='0'", "<static_box/><keep_clear x='1' y='1' radius='2'/>"));
  for (const world::Obstacle& box : world.obstacles) CHECK(std::hypot(box.x - 1, box.y - 1) > 2.0);
}

TEST_CASE("An edit of a layout comes before it is drawn, one of what it draws after") {
  CHECK(drawn(kClutter, 1, {"scatter[clutter]/@count=3"}).obstacles.size() == 3);
  CHECK(drawn(kClutter, 1, {"layouts/scatter[1]/static_box/@length=0.5"}).obstacles[7].length ==
        0.5);
  const world::World moved = drawn(kClutter, 1, {"obstacle[clutter3]/@x=0.25"});
  CHECK(moved.obstacles[2].x == 0.25);
  CHECK(moved.obstacles[1].x == drawn(kClutter, 1).obstacles[1].x);
  CHECK(drawn(kClutter, 1, {"obstacle[clutter3]/@remove=true"}).obstacles.size() == 29);
  CHECK(drawn(kClutter, 1, {"scatter[clutter]/@remove=true"}).obstacles.empty());
  const world::World all = drawn(kClutter, 1, {"obstacle[*]/@length=0.4"});
  CHECK(std::all_of(all.obstacles.begin(), all.obstacles.end(),
                    [](const world::Obstacle& box) { return box.length == 0.4; }));
}

TEST_CASE("What is edited before keeps the gap as well") {
  const std::string world = "<obstacles><static_box id='big'/></obstacles>" + kClutter;
  const auto all =
      footprints(drawn(world, 1, {"obstacle[big]/@length=6", "obstacle[big]/@width=6"}));
  for (std::size_t i = 1; i < all.size(); ++i) CHECK_FALSE(are_nearer(all[i], all[0], 0.199));
}

TEST_CASE("A run has no layouts: its world is written, and reads as the same world") {
  const world::World world = drawn(kClutter, 3);
  const std::string text = world::write_world(world);
  CHECK_THAT(text, !Contains("layouts") && Contains("clutter30"));
  CHECK(world::write_world(world::parse_world(text, "w.xml", shipped())) == text);
}

TEST_CASE("Things are scattered in an arena of any size, whatever its last digits") {
  for (const char* length : {"7.07107", "31.622777", "3.33333333"}) {
    CAPTURE(length);
    const std::string arena =
        "<arena length='" + std::string(length) + "' width='" + length + "'/>";
    CHECK(drawn(arena + scattered("density='0.01'", "<static_box length='0.1' width='0.1'/>"), 1)
              .obstacles.size() > 1);
  }
}

TEST_CASE("What cannot be scattered is refused in a sentence, at its line") {
  CHECK(refusal(scattered("count='400'", "<static_box length='1' width='1'/>")) ==
        "w.xml:2: the layout 'c' has no room for the next of its 400 things after 49: 1000 places "
        "were tried, with a gap of 0.05 m to everything else; lower the count or the gap, or give "
        "them more area");
  CHECK(refusal(scattered("count='4'", "<static_box/><in_disc x='4' radius='2'/>")) ==
        "w.xml:2: the layout 'c' reaches from (2, -2) to (6, 2), outside of the arena, which "
        "reaches to (5, 5); make it smaller, or move it");
  CHECK(
      refusal(scattered("count='-1'", "<static_box/>")) ==
      "w.xml:2: count=\"-1\" of <scatter>: expected a whole number at least 0 and at most 999999");
  CHECK_THAT(refusal(scattered("density='0.95'", "<static_box/>")), Contains("at most 0.9"));
  CHECK_THAT(refusal(scattered("density='0.8'", "<static_box/>")), Contains("lower the density"));
  CHECK_THAT(
      refusal("<arena length='1000' width='1000'/>" +
              scattered("density='0.05' gap='0.001'", "<static_box length='0.1' width='0.1'/>")),
      Contains("has a density of 0.05, which takes more than 1000000 things; lower"));
  CHECK_THAT(refusal(scattered("density='0.1' count='3'", "<static_box/>")),
             Contains("has a count and a density; expected one of them"));
  CHECK_THAT(refusal(scattered("density='0.1'", "<static_box/><gaussian/>")),
             Contains("has no area; give a count instead"));
  CHECK_THAT(refusal(scattered("", "<static_box/><in_box/><in_disc/>")),
             Contains("says more than once where its things stand"));
  CHECK_THAT(refusal(scattered("", "<in_box/>")), Contains("does not say what it scatters"));
  CHECK_THAT(refusal(scattered("", "<static_box/><robot/>")), Contains("scatters several things"));
  CHECK_THAT(refusal(scattered("", "<stick_box/>")), Contains("did you mean '<static_box>'?"));
  CHECK_THAT(refusal(scattered("", "<static_box x='3'/>")), Contains("its place is drawn"));
  CHECK_THAT(refusal(scattered("", "<static_box heading_deg='3'/><heading/>")),
             Contains("<heading> draws it"));
  CHECK_THAT(refusal(scattered("count='10'", "<static_box/><on_grid/>")),
             Contains("has 10 things, but its grid has 9 cells"));
  CHECK_THAT(refusal(scattered("", "<static_box/><in_ring inner='2' outer='2'/>")),
             Contains("expected an inner radius below the outer one"));
  CHECK_THAT(refusal(scattered("", "<static_box/><heading rule='along'/>")),
             Contains("but no <on_line>"));
  CHECK_THAT(refusal("<layouts seed='seven'><maze/></layouts>"), Contains("seed=\"seven\""));
  CHECK_THAT(refusal("<layouts><scater/></layouts>"), Contains("did you mean '<scatter>'?"));
  CHECK_THAT(refusal("<layouts><maze/></layouts><layouts><rooms/></layouts>"),
             Contains("more than one <layouts>"));
  CHECK_THAT(refusal("<layouts><maze id='m'/><rooms id='m'/></layouts>"),
             Contains("there is another layout with the id 'm'"));
  CHECK_THAT(refusal("<arena/>", 1, {"layouts/@seed=3"}), Contains("the world has no layouts"));
  CHECK_THAT(refusal(kClutter, 1, {"obstacle[clutter31]/@x=0"}),
             Contains("there is no obstacle[clutter31]"));
  CHECK_THAT(refusal(kClutter, 1, {"scatter[cluter]/@count=3"}), Contains("there are: clutter"));
}

TEST_CASE("There may be none of what is scattered, by count or by density") {
  const std::string other = "<layouts><scatter id='o'><static_box/></scatter>";
  for (const char* number : {"count='0'", "density='1e-9'"}) {
    CAPTURE(number);
    const std::string none = "<scatter id='c' " + std::string(number) + "><static_box/>";
    CHECK(text_of(other + none + "</scatter></layouts>") == text_of(other + "</layouts>"));
    // What it would scatter is checked, and found by the draws of the world.
    CHECK_THAT(refusal(scattered(number, "<static_box lenth='1'/>")),
               Contains("did you mean 'length'?"));
    CHECK(refusal("<layouts>" + none +
                  "</scatter><draw path='obstacle[*]/@length' from='0.1' "
                  "to='0.2'/></layouts>") == "");
  }
  CHECK_THAT(refusal("<goals><collect/></goals>" + scattered("count='0'", "<resource/>")),
             Contains("<collect> has nothing to collect"));
}

TEST_CASE("A mistake in the thing itself is said once, however many there are") {
  CHECK(refusal(scattered("count='50'", "<static_box lenth='1'/>")) ==
        "w.xml:2: <static_box> has no attribute 'lenth'; did you mean 'length'?");
  CHECK_THAT(refusal(scattered("count='50'", "<robot id='r' template='nope.xml'/>")),
             Contains("the template 'nope.xml': there is no such file") && !Contains("\n"));
  CHECK_THAT(
      refusal(scattered("count='50'", "<static_box/><draw path='@length' from='-2' to='-1'/>")),
      Contains("of <static_box>: expected a number") && !Contains("\n"));
}

TEST_CASE("A large grid is filled in a time that grows with its cells") {
  // Half of it is a single box, whose cells are tried in vain.
  const world::World world = drawn(
      "<arena length='400' width='400'/><obstacles><static_box x='-100' length='200' width='400'/>"
      "</obstacles>" +
      scattered("count='20000'", "<charger radius='0.01'/><on_grid columns='200' rows='400'/>"));
  CHECK(world.chargers.size() == 20000);
}

TEST_CASE("Places are tried only so many times, and the refusal says how many") {
  CHECK_THAT(
      refusal("<arena length='50' width='50'/>" +
              scattered("count='20000' tries='999999'", "<static_box length='0.5' width='0.5'/>")),
      Contains("2000000 places were tried for all of them, and no layout tries more"));
}

TEST_CASE("Lamps keep clear of what is as high as they are, and of each other") {
  const std::string boxes =
      "<obstacles><static_box length='9' width='9' height='0.4'/></obstacles>";
  const std::string lamps =
      "<layouts><scatter id='l' count='8' gap='0.5'><lamp z='0.6'/></scatter></layouts>";
  const world::World world = drawn(boxes + lamps, 1);
  REQUIRE(world.lamps.size() == 8);
  CHECK(world.lamps[7].id == "l8");
  for (std::size_t i = 0; i < 8; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      CHECK(std::hypot(world.lamps[i].x - world.lamps[j].x, world.lamps[i].y - world.lamps[j].y) >
            0.5);
    }
  }
  CHECK_THAT(refusal("<arena length='4' width='4'/><obstacles><static_box length='4' width='4' "
                     "height='0.8'/></obstacles>" +
                     lamps),
             Contains("has no room for the first of its 8 things"));
}

TEST_CASE("Patches are scattered within the walls, whatever stands there, by a density too") {
  const std::string boxes =
      "<arena length='4' width='4'/><obstacles><static_box length='4' width='4'/></obstacles>";
  const world::World world =
      drawn(boxes +
                "<layouts><scatter id='p' density='0.5'><disc_patch radius='0.5'/></scatter>"
                "<scatter id='q' count='30'><line_patch width='0.1'><point x='0' y='0'/>"
                "<point x='1' y='0'/></line_patch><heading/></scatter></layouts>",
            1);
  CHECK(world.patches.size() == 10 + 30);  // 0.5 * 16 / (pi / 4)
  std::set<double> headings;
  for (const world::Patch& patch : world.patches) {
    CHECK(std::abs(patch.x) <= 2.0);
    if (patch.shape == world::PatchShape::disc) {
      CHECK(std::max(std::abs(patch.x), std::abs(patch.y)) <= 1.5);
    } else {
      headings.insert(patch.heading_deg);
    }
  }
  CHECK(headings.size() > 20);
  CHECK_THAT(refusal(scattered("", "<disc_patch/><heading/>")),
             Contains("a <disc_patch> faces no way"));
}

TEST_CASE("What would have no effect is refused in a sentence") {
  const std::string decided = "w.xml:2: the layout 'c' decides about ";
  CHECK(refusal(scattered("", "<static_box/><draw path='@x' from='0' to='1'/>")) ==
        decided + "'x' of what it scatters, which a <draw> draws as well; leave out this <draw>");
  CHECK_THAT(refusal(scattered("",
                               "<robot id='r'/><heading/>"
                               "<draw path='@heading_deg' from='0' to='1'/>")),
             Contains("'heading_deg' of what") && Contains("leave out this <draw> or <heading>"));
  CHECK_THAT(refusal("<layouts><scatter id='c' count='3'><robot id='r'/></scatter>"
                     "<draw path='robot[r3]/@y' from='0' to='1'/></layouts>"),
             Contains("'y' of what it scatters"));
  CHECK_THAT(refusal(scattered("", "<charger/><heading/>")), Contains("chargers face no way"));
  CHECK_THAT(refusal(scattered("",
                               "<static_box/><draw path='@length' from='1' to='2'/>"
                               "<draw path='@length' from='1' to='3'/>")),
             Contains("the layout 'c' draws '@length' a second time"));
  CHECK_THAT(refusal("<layouts><draw path='arena/@length' from='8' to='9'/>"
                     "<draw path='arena/@length' from='8' to='9'/></layouts>"),
             Contains("draws 'arena/@length' a second time"));
  for (const char* path :
       {"layouts/@seed", "layouts[1]/@seed", "layout[c]/@count", "scatter[c]/@count"}) {
    CHECK(refusal("<layouts><draw id='d' path='" + std::string(path) +
                  "' from='8' to='9'/></layouts>") ==
          "w.xml:2: the layout 'd' draws '" + std::string(path) +
              "' too late: layouts are read before anything is drawn; draw another attribute");
  }
  CHECK_THAT(refusal("<layouts><draw path='robot[r1]/@template' from='1' to='4'/></layouts>"),
             Contains("too late: templates are read before anything is drawn"));
}
