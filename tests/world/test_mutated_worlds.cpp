// Worlds with random damage are read or refused, never anything else.
#include <catch2/catch.hpp>

#include "elsie/world/writer.h"

#include "damage.h"
#include "equal.h"
#include "fixture.h"

using namespace elsie;
using namespace elsie::test;

namespace {

const std::vector<std::string> kPieces = {"<",
                                          ">",
                                          "/",
                                          "\"",
                                          "'",
                                          "=",
                                          "&",
                                          "&amp;",
                                          "<!--",
                                          "-->",
                                          "<![CDATA[",
                                          "]]>",
                                          "<?",
                                          "nan",
                                          "-1",
                                          "1e999",
                                          "\xC3",
                                          "\n",
                                          "</robot>",
                                          "<robot id='r1'>",
                                          "id=\"r1\"",
                                          "remove=\"true\"",
                                          "template=\"wrong/parts/good.xml\"",
                                          "0",
                                          " ",
                                          "-",
                                          "\x01",
                                          "<!DOCTYPE a>",
                                          "<beam/>",
                                          "<behaviors>",
                                          "</behaviors>",
                                          "<coordinator><sum/></coordinator>",
                                          "<rule of=\"roam\"/>",
                                          "<blend/>",
                                          "9"};
const std::vector<std::string> kPlugins = {"<beam", "<bumper",    "<avoid",  "<roam",     "<sum",
                                           "<eye",  "<threshold", "<layers", "<suppress", "<blend"};

std::string damaged(unsigned seed, const std::string& text) {
  return Damage(seed, kPieces, kPlugins).to(text);
}

}  // namespace

TEST_CASE("A damaged world is read or refused") {
  const std::string original = text_of(kFolder + "data/everything.xml");
  int accepted = 0;
  for (unsigned seed = 0; seed < 5000; ++seed) {
    const std::string text = damaged(seed, original);
    CAPTURE(seed);
    try {
      const world::World w =
          world::parse_world(text, kFolder + "data/damaged.xml", host(), options());
      ++accepted;
      // What is accepted can be saved.
      REQUIRE(same(w, world::parse_world(world::write_world(w), kFolder + "data/again.xml", host(),
                                         options())));
    } catch (const world::WorldError& error) {
      REQUIRE_FALSE(error.problems().empty());
    }
  }
  CHECK(accepted > 50);
  CHECK(accepted < 3000);
}

TEST_CASE("A damaged override is taken or refused") {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    CAPTURE(seed);
    try {
      world::read_world(kFolder + "data/everything.xml", host(),
                        options({damaged(seed, "robot[r1]/sensor[2]/@yaw_deg=15")}));
    } catch (const world::WorldError& error) {
      REQUIRE_FALSE(error.problems().empty());
    }
  }
}
