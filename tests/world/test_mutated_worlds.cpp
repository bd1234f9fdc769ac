// Worlds with random damage are read or refused, never anything else.
#include <set>

#include <catch2/catch.hpp>

#include "elsie/world/markup.h"
#include "elsie/world/writer.h"

#include "damage.h"
#include "equal.h"
#include "fixture.h"

using namespace elsie;
using namespace elsie::test;

namespace {

const std::vector<std::string> kPieces = xml_pieces(
    R"(</robot> id="r1" remove="true" template="wrong/parts/good.xml" <beam/> <behaviors>)"
    " </behaviors> <coordinator><sum/></coordinator> <blend/>",
    {"<robot id='r1'>", "<!DOCTYPE a>", "<rule of=\"roam\"/>"});
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

// tinyxml2 reads this text alone, unless the places of the elements are asked for.
TEST_CASE("Damaged markup means the same with and without the places of its elements") {
  const std::string original =
      "<?xml version=\"1.0\"?>\n<!-- It's \"plain\". -->\n<world format=\"1\">\n"
      "  <robots><robot id=\"r1\" x=\"1\"\n y=\"2\"></robot><robot/></robots>\n</world>\n";
  const auto read = [](const std::string& text, std::vector<world::ElementSpan>* spans) {
    try {
      return world::markup_of(world::parse_markup(text, "damaged.xml", "world", spans));
    } catch (const world::WorldError& error) {
      return std::string(error.what());
    }
  };
  std::set<std::string> meanings;
  for (unsigned seed = 0; seed < 20'000; ++seed) {
    const std::string text = Damage(seed, kPieces, {"<robot", "</robot", "<world"}).to(original);
    std::vector<world::ElementSpan> spans;
    const std::string meaning = read(text, nullptr);
    CAPTURE(text);
    REQUIRE(meaning == read(text, &spans));
    meanings.insert(meaning);
  }
  CHECK(meanings.size() > 500);
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
