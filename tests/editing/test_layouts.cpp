// Layouts of a world file that is edited: they are edited, and what they draw is not.
#include <catch2/catch.hpp>

#include "elsie/editing/document.h"

#include "../world/equal.h"
#include "../world/fixture.h"

using namespace elsie;
using namespace elsie::test;
using Catch::Contains;
using editing::Document;

namespace {

const std::string kLayouts = R"(<world format="1">
  <obstacles>
    <static_box id="wall" x="1"/>
  </obstacles>
  <layouts seed="4"> <!-- drawn -->
    <scatter id="clutter" count="3">
      <static_box/>
    </scatter>
    <scatter id="fleet" count="2"><robot id="r"/></scatter>
  </layouts>
</world>
)";

Document layout_document(std::uint64_t seed = 1, const std::string& text = kLayouts) {
  world::ReadOptions reading = options();
  reading.check_plugins = false;
  reading.seed = seed;
  return Document(text, kFolder + "world.xml", host(), reading);
}

std::string layout_refusal(const std::string& edit) {
  Document d = layout_document();
  try {
    d.apply({edit});
  } catch (const world::WorldError& error) {
    CHECK(d.text() == kLayouts);
    return error.problems().front().message;
  }
  return "";
}

}  // namespace

TEST_CASE("An edit of a layout changes its text, and the world follows") {
  Document d = layout_document();
  CHECK(d.world().obstacles.size() == 4);
  d.apply({"scatter[clutter]/@count=9"});
  CHECK(d.world().obstacles.size() == 10);
  CHECK_THAT(d.text(), Contains("<scatter id=\"clutter\" count=\"9\">"));
  d.become(kLayouts);
  CHECK(d.world().obstacles.size() == 4);
}

TEST_CASE("The seed of layouts is edited") {
  Document d = layout_document();
  const double before = d.world().obstacles.back().x;
  d.apply({"layouts/@seed=5"});
  CHECK_THAT(d.text(), Contains("<layouts seed=\"5\"> <!-- drawn -->"));
  CHECK(d.world().obstacles.back().x != before);
}

TEST_CASE("Layouts are added and removed") {
  Document d = layout_document();
  d.apply({"scatter[+]=<scatter id=\"food\"><resource/></scatter>"});
  CHECK(d.world().obstacles.size() == 5);
  d.apply({"scatter[clutter]/@remove=true"});
  CHECK(d.world().obstacles.size() == 2);
  Document empty = layout_document(1, "<world format=\"1\"/>\n");
  empty.apply({"layout[+]=<maze columns=\"3\" rows=\"3\"/>"});
  CHECK(empty.world().obstacles.size() > 1);
}

TEST_CASE("An edit of what a layout has drawn is refused, with the layout's name") {
  CHECK(layout_refusal("obstacle[clutter2]/@x=0.5") ==
        "the layout 'clutter' draws this, another one from each seed; edit what scatter[clutter] "
        "says instead");
  CHECK_THAT(layout_refusal("robot[r1]/@max_speed=0.3"), Contains("the layout 'fleet' draws this"));
  CHECK_THAT(layout_refusal("robot[r2]/@remove=true"), Contains("the layout 'fleet' draws this"));
  CHECK_THAT(layout_refusal("robot[r3]/@max_speed=0.3"), Contains("there is no"));
}

TEST_CASE("What is there beside layouts is edited as ever, and the layouts keep clear of it") {
  Document d = layout_document();
  d.apply({"obstacle[wall]/@length=4"});
  CHECK(d.world().obstacles[0].length == 4.0);
  d.apply({"robot[*]/@max_speed=0.3"});
  CHECK_THAT(d.text(), Contains("<robot id=\"r\" max_speed=\"0.3\"/>"));
  CHECK(d.world().robots.at(1).max_speed == 0.3);
}

TEST_CASE("A document has the layouts of the run's seed") {
  std::string by_run = kLayouts;
  by_run.replace(by_run.find(" seed=\"4\""), 9, "");
  CHECK_FALSE(same(layout_document(1, by_run).world(), layout_document(2, by_run).world()));
  CHECK(same(layout_document(4, by_run).world(), layout_document(1).world()));
}

TEST_CASE("The layout that draws something is found, though others stand on its line") {
  std::string text = kLayouts;
  text.replace(text.find("    <scatter id=\"fleet\""), 4, "");
  text.replace(text.find("</scatter>\n<scatter"), 11, "</scatter>");
  text.replace(text.find("\n      <static_box/>\n    "), 25, "<static_box/>");
  Document d = layout_document(1, text);
  CHECK_THAT(text, Contains("</scatter><scatter"));
  try {
    d.apply({"robot[r1]/@max_speed=0.3"});
    FAIL("the edit was made");
  } catch (const world::WorldError& error) {
    CHECK_THAT(error.what(), Contains("the layout 'fleet' draws this"));
  }
}

TEST_CASE("An edit of an attribute that a <draw> draws is refused, with the layout's name") {
  std::string text = kLayouts;
  text.replace(text.find("    <scatter id=\"fleet\""), 0,
               "    <draw id=\"place\" path=\"obstacle[wall]/@y\" from=\"2\" to=\"3\"/>\n");
  text.replace(text.find("      <static_box/>"), 0,
               "      <in_box/><draw path=\"@length\" from=\"0.2\" to=\"0.3\"/>\n");
  Document d = layout_document(1, text);
  const auto layout_refusal = [&](const std::string& edit) -> std::string {
    try {
      d.apply({edit});
      return "";
    } catch (const world::WorldError& error) {
      return error.what();
    }
  };
  CHECK_THAT(layout_refusal("obstacle[wall]/@y=1"), Contains("the layout 'place' draws this"));
  CHECK_THAT(layout_refusal("scatter[clutter]/static_box/@length=1"),
             Contains("the layout 'clutter' draws this"));
  CHECK(layout_refusal("scatter[clutter]/in_box/@length=4") == "");
  CHECK(layout_refusal("obstacle[wall]/@x=2") == "");
  CHECK(d.world().obstacles[0].x == 2.0);
}
