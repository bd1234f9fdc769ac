// Worlds with random damage are read or refused, never anything else.
#include <set>

#include <catch2/catch.hpp>
#include <tinyxml2.h>

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

// Requires the same names, values, texts and lines.
void require_same(const world::Element& element, const tinyxml2::XMLElement& other) {
  REQUIRE(element.name == other.Name());
  REQUIRE(element.where.line == other.GetLineNum());
  const tinyxml2::XMLAttribute* attribute = other.FirstAttribute();
  for (const world::Attribute& own : element.attributes) {
    REQUIRE(attribute);
    REQUIRE(own.name == attribute->Name());
    REQUIRE(own.value == attribute->Value());
    REQUIRE(own.where.line == attribute->GetLineNum());
    attribute = attribute->Next();
  }
  REQUIRE_FALSE(attribute);
  if (!element.text.empty()) {
    const tinyxml2::XMLNode* text = other.FirstChild();
    while (text && !text->ToText()) text = text->NextSibling();
    REQUIRE(text);
    REQUIRE(std::string(text->Value()).find(element.text) != std::string::npos);
    REQUIRE(element.text_line == text->GetLineNum());
  }
  const tinyxml2::XMLElement* child = other.FirstChildElement();
  for (const world::Element& own : element.children) {
    REQUIRE(child);
    require_same(own, *child);
    child = child->NextSiblingElement();
  }
  REQUIRE_FALSE(child);
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

TEST_CASE("Markup means what it means to another reader") {
  const std::string original =
      "<?xml version=\"1.0\"?>\n<!-- It's \"plain\". -->\n<world format=\"1\">\n"
      "  <robots>a\r\n b&#228;&lt;<robot id=\"r1\" x='&apos;1'\n y=\"2\"></robot><robot/>"
      "</robots>\n</world>\n";
  std::set<std::string> meanings;
  for (unsigned seed = 0; seed < 20'000; ++seed) {
    const std::string text = Damage(seed, kPieces, {"<robot", "</robot", "<world"}).to(original);
    CAPTURE(text);
    try {
      const world::Element root = world::parse_markup(text, "damaged.xml");
      tinyxml2::XMLDocument document;
      REQUIRE(document.Parse(text.c_str()) == tinyxml2::XML_SUCCESS);
      require_same(root, *document.RootElement());
      meanings.insert(world::markup_of(root));
    } catch (const world::WorldError&) {
    }
  }
  CHECK(meanings.size() > 100);
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
